// SPDX-License-Identifier: MIT
// Which effects a render simulates: ir::Effects without its reasons, as the ray loop asks.
//
// An effect can be left out when this is compiled: COBBLE_COMPILED_OUT is a mask with bit i set for
// effect i of ir::Effect. It is off then, whoever asks, and the compiler knows. That is there to
// measure what an effect costs that is compiled in and off: all files of a program that include
// this must be compiled with the same mask.
#pragma once

#include <cstdint>

#include "ir/scene/effects.hpp"

#ifndef COBBLE_COMPILED_OUT
#define COBBLE_COMPILED_OUT 0
#endif

namespace cobble::renderer {

constexpr std::uint32_t bit_of(ir::Effect effect) {
    return 1U << static_cast<std::uint32_t>(effect);
}
constexpr bool compiled_in(ir::Effect effect) {
    return (static_cast<std::uint32_t>(COBBLE_COMPILED_OUT) & bit_of(effect)) == 0;
}

class ActiveEffects {
  public:
    ActiveEffects() = default;
    explicit ActiveEffects(const ir::Effects& effects) {
        for (std::uint32_t i = 0; i < ir::kEffectCount; ++i) {
            const auto effect = static_cast<ir::Effect>(i);
            if (compiled_in(effect) && effects.on(effect)) mask_ |= bit_of(effect);
        }
    }

    [[nodiscard]] bool on(ir::Effect effect) const {
        return compiled_in(effect) && (mask_ & bit_of(effect)) != 0;
    }

    [[nodiscard]] bool depth_of_field() const { return on(ir::Effect::kDepthOfField); }
    [[nodiscard]] bool motion_blur() const { return on(ir::Effect::kMotionBlur); }
    [[nodiscard]] bool soft_shadows() const { return on(ir::Effect::kSoftShadows); }
    [[nodiscard]] bool shadows() const { return on(ir::Effect::kShadows); }
    [[nodiscard]] bool reflection() const { return on(ir::Effect::kReflection); }
    [[nodiscard]] bool refraction() const { return on(ir::Effect::kRefraction); }
    [[nodiscard]] bool highlights() const { return on(ir::Effect::kHighlights); }
    [[nodiscard]] bool textures() const { return on(ir::Effect::kTextures); }
    [[nodiscard]] bool normal_maps() const { return on(ir::Effect::kNormalMaps); }
    [[nodiscard]] bool noise() const { return on(ir::Effect::kNoise); }
    [[nodiscard]] bool environment() const { return on(ir::Effect::kEnvironment); }

  private:
    std::uint32_t mask_ = 0;
};

}  // namespace cobble::renderer
