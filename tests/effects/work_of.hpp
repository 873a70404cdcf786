// SPDX-License-Identifier: MIT
// What each effect does that can be counted: nothing where it is off.
#pragma once

#include <cstdint>

#include "ir/scene/effects.hpp"
#include "renderer/tile/counters.hpp"

namespace cobble::test {

inline std::uint64_t work_of(ir::Effect effect, const renderer::Counters& counters) {
    switch (effect) {
        case ir::Effect::kDepthOfField:
            return counters.lens_draws;
        case ir::Effect::kMotionBlur:
            return counters.time_draws;
        case ir::Effect::kSoftShadows:
            return counters.light_draws;
        case ir::Effect::kShadows:
            return counters.shadow_rays;
        case ir::Effect::kReflection:
            return counters.reflected_rays;
        case ir::Effect::kRefraction:
            return counters.refracted_rays;
        case ir::Effect::kHighlights:
            return counters.highlights;
        case ir::Effect::kTextures:
            return counters.texture_lookups;
        case ir::Effect::kNormalMaps:
            return counters.normal_map_lookups;
        case ir::Effect::kNoise:
            return counters.noise_evaluations;
        case ir::Effect::kEnvironment:
            return counters.cube_map_lookups;
        case ir::Effect::kCount_:
            break;
    }
    return 0;
}

inline ir::Effects effects_of_mask(std::uint32_t mask) {
    ir::Effects result;
    for (std::uint32_t i = 0; i < ir::kEffectCount; ++i) {
        result.states[i].on = (mask >> i & 1U) != 0;
    }
    return result;
}
inline constexpr std::uint32_t kAllEffects = (1U << ir::kEffectCount) - 1;

}  // namespace cobble::test
