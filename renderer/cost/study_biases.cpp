// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include "renderer/cost/parts.hpp"
#include "renderer/integrator/shading_scene.hpp"

namespace cobble::renderer {
namespace {

Bias bias(std::string name, std::string meaning, const Distance& distance) {
    return {std::move(name), std::move(meaning), distance.rmse, distance.flip, distance.maximum};
}

Plane32 clamped(Plane32 plane) {
    for (float& value : plane.values) value = std::clamp(value, 0.0F, 1.0F);
    return plane;
}

}  // namespace

std::optional<std::vector<Bias>> study_biases(const Studio& studio, std::uint32_t samples) {
    const Settings settings = studio.settings(samples);
    const std::optional<Run> as_asked = studio.run(settings);
    if (!as_asked) return std::nullopt;
    const Plane32& picture = as_asked->picture.color;
    std::vector<Bias> biases;
    using ir::Effect;
    const bool goes_on =
        settings.effects.on(Effect::kReflection) || settings.effects.on(Effect::kRefraction);
    if (goes_on) {
        Settings deeper = settings;
        deeper.bounces = std::min(2 * settings.bounces + 2, kMostBounces);
        const std::optional<Run> run = studio.run(deeper);
        if (!run) return std::nullopt;
        biases.push_back(bias("bounce limit",
                              std::to_string(settings.bounces) + " turns of a ray against " +
                                  std::to_string(deeper.bounces),
                              distance(studio, run->picture.color, picture)));
    }
    biases.push_back(bias("clamping", "values above white, which a display cannot show",
                          distance(studio, picture, clamped(picture))));
    if (settings.effects.on(Effect::kTextures)) {
        Settings nearest = settings;
        nearest.texture_filter = ir::TextureFilter::kNearest;
        Settings bilinear = settings;
        bilinear.texture_filter = ir::TextureFilter::kBilinear;
        const std::optional<Run> sharp = studio.run(nearest);
        const std::optional<Run> soft = sharp ? studio.run(bilinear) : std::nullopt;
        if (!soft) return std::nullopt;
        biases.push_back(bias("texture filter", "nearest texels against bilinear ones",
                              distance(studio, soft->picture.color, sharp->picture.color)));
    }
    return biases;
}

}  // namespace cobble::renderer
