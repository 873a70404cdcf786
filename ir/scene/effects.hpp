// SPDX-License-Identifier: MIT
// What a scene calls for: an effect is on only if something in the checked, folded scene needs it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/source/span.hpp"

namespace cobble::ir {

/// COBBLE_EFFECT(id, name, doc): `name` is the word of `--no-NAME` and of `cobble explain SCENE`.
#define COBBLE_EFFECTS(COBBLE_EFFECT)                                                        \
    COBBLE_EFFECT(kDepthOfField, "depth-of-field", "a lens with an aperture")                \
    COBBLE_EFFECT(kMotionBlur, "motion-blur", "objects that move while the shutter is open") \
    COBBLE_EFFECT(kSoftShadows, "soft-shadows", "lights with a size")                        \
    COBBLE_EFFECT(kShadows, "shadows", "lights that something can hide")                     \
    COBBLE_EFFECT(kReflection, "reflection", "materials that mirror")                        \
    COBBLE_EFFECT(kRefraction, "refraction", "materials that are seen through")              \
    COBBLE_EFFECT(kHighlights, "highlights", "materials with shininess")                     \
    COBBLE_EFFECT(kTextures, "textures", "materials with a picture")                         \
    COBBLE_EFFECT(kNormalMaps, "normal-maps", "materials with a normal or bump map")         \
    COBBLE_EFFECT(kNoise, "noise", "materials of procedural marble")                         \
    COBBLE_EFFECT(kEnvironment, "environment", "a cube map around the scene or on a material")

enum class Effect : std::uint8_t {
#define COBBLE_EFFECT(id, name, doc) id,
    COBBLE_EFFECTS(COBBLE_EFFECT)
#undef COBBLE_EFFECT
        kCount_
};
inline constexpr std::size_t kEffectCount = static_cast<std::size_t>(Effect::kCount_);

std::string_view name_of(Effect effect);
std::string_view description_of(Effect effect);

struct EffectState {
    bool on = false;
    std::vector<source::Span> causes;  ///< what calls for it, in order; empty if off
    std::string reason;                ///< why it is off, or "asked for" if only an option wants it
};

struct Effects {
    std::array<EffectState, kEffectCount> states;

    [[nodiscard]] bool on(Effect effect) const {
        return states[static_cast<std::size_t>(effect)].on;
    }
};

}  // namespace cobble::ir
