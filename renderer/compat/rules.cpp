// SPDX-License-Identifier: MIT
#include "renderer/compat/rules.hpp"

namespace cobble::renderer {
namespace {

void cast_rays(CompatRules& rules, CompatRules::Highlight highlight) {
    rules.highlight = highlight;
    rules.shadows = false;
    rules.bounces = 0;
}

void trace_rays(CompatRules& rules) {
    rules.falloff = CompatRules::Falloff::kOnePlus;
    rules.noise = true;
    rules.refraction = true;
}

}  // namespace

CompatRules rules_of(ir::Compat compat, const Settings& settings) {
    CompatRules rules;
    rules.shadows = settings.compat.shadows;
    rules.bounces = settings.bounces;
    rules.jitter = settings.compat.jitter;
    rules.kernel = settings.compat.filter;
    rules.grid = rules.jitter || rules.kernel ? 3 : 1;
    rules.nearest_texel = settings.compat.pixelated;
    switch (compat) {
        case ir::Compat::kNone:
        case ir::Compat::kA4:
            cast_rays(rules, CompatRules::Highlight::kReflectedView);
            rules.ambient_shows_texture = true;
            break;
        case ir::Compat::kA5:
            trace_rays(rules);
            break;
        case ir::Compat::kFa2016:
            rules.falloff = CompatRules::Falloff::kProportional;
            rules.highlight = CompatRules::Highlight::kReflectedView;
            rules.textures = false;
            rules.up_as_written = true;
            break;
        case ir::Compat::kProject:
            rules.normal_maps = true;
            if (settings.compat.casting) {
                cast_rays(rules, CompatRules::Highlight::kClampedLight);
                rules.falloff = CompatRules::Falloff::kOnePlus;
                rules.noise = true;
                rules.mirror_materials = true;
                rules.focus = settings.compat.blurry;
            } else {
                trace_rays(rules);
            }
            break;
    }
    return rules;
}

}  // namespace cobble::renderer
