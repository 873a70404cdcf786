// SPDX-License-Identifier: MIT
#include "renderer/settings.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace cobble::renderer {

Crop window_of(const Settings& settings) {
    Crop window{0, 0, settings.width, settings.height};
    if (settings.crop) {
        window.x1 = std::min(settings.crop->x1, settings.width);
        window.y1 = std::min(settings.crop->y1, settings.height);
        window.x0 = std::min(settings.crop->x0, window.x1);
        window.y0 = std::min(settings.crop->y0, window.y1);
    }
    if (window.x0 == window.x1 || window.y0 == window.y1) return {};
    return window;
}

std::string fingerprint(const Settings& settings) {
    std::string text;
    // Numbers are written so that they come back as they were: no two give one text.
    const auto add = [&text](const auto& value) { text += fmt::format("{} ", value); };
    const auto add_enum = [&add](auto value) { add(static_cast<unsigned>(value)); };
    add(settings.width);
    add(settings.height);
    const Crop window = window_of(settings);
    for (const std::uint32_t side : {window.x0, window.y0, window.x1, window.y1}) add(side);
    add(settings.samples);
    add(settings.light_samples);
    add(settings.scrambles);
    if (const auto& goal = settings.goal) {
        add("goal");
        add(goal->error);
        add_enum(goal->method);
        add(goal->most_samples);
        add(settings.shown_as_srgb);
    }
    add(settings.bounces);
    add(settings.seed);
    add(settings.salts);
    add_enum(settings.filter);
    add_enum(settings.precision);
    for (const ir::EffectState& effect : settings.effects.states) add(effect.on);
    if (settings.texture_filter) {
        add("texture");
        add_enum(*settings.texture_filter);
    }
    const Settings::Compat& compat = settings.compat;
    for (const bool flag :
         {compat.shadows, compat.jitter, compat.filter, compat.casting, compat.pixelated}) {
        add(flag);
    }
    if (compat.blurry) {
        add("blurry");
        add(*compat.blurry);
    }
    add(compat.depth_min);
    add(compat.depth_max);
    return text;
}

}  // namespace cobble::renderer
