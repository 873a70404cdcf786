// SPDX-License-Identifier: MIT
// What sets the published programs apart, as data: each program is one row of answers.
#pragma once

#include <cstdint>
#include <optional>

#include "ir/scene/scene.hpp"
#include "renderer/settings.hpp"

namespace cobble::renderer {

struct CompatRules {
    enum class Falloff : std::uint8_t {
        kNone,          ///< the ray caster of 2012: a point light is as bright everywhere
        kOnePlus,       ///< color / (1 + falloff d^2)
        kProportional,  ///< 2016: color / (falloff d^2); 0, which would divide by zero, is none
    };
    enum class Highlight : std::uint8_t {
        kNone,           ///< the ray tracer of 2012 reads `shininess` and ignores it
        kReflectedView,  ///< max(0, L.R)^shininess, R the view ray reflected
        kClampedLight,   ///< the project: L reflected with max(0, N.L), seen along the view ray
    };

    Falloff falloff = Falloff::kNone;
    Highlight highlight = Highlight::kNone;
    bool shadows = false;
    bool textures = true;
    bool noise = false;
    bool refraction = false;
    /// Ambient light shows the texture, as it does in the handout of 2012 (its textured scenes are
    /// off by ten levels otherwise); else the diffuse colour, as in the project.
    bool ambient_shows_texture = false;
    bool normal_maps = false;
    /// The project's ray caster: a material with a cube map shows half of it and half of its noise,
    /// once for each light.
    bool mirror_materials = false;
    bool up_as_written = false;  ///< 2016: the camera's `up` is neither unit nor perpendicular
    bool nearest_texel = false;
    std::uint32_t bounces = 0;
    /// The picture is made of grid x grid times as many samples, and reduced.
    std::uint32_t grid = 1;
    bool jitter = false;
    bool kernel = false;          ///< the 5-tap filter before the reduction
    std::optional<double> focus;  ///< distance of the plane that a thin lens shows sharply

    /// Rays that leave a surface begin this far from it, in world units; their origin is the hit
    /// point itself. The course's constant.
    static constexpr double kStart = 0.001;
};

/// `compat` is not kNone.
CompatRules rules_of(ir::Compat compat, const Settings& settings);

}  // namespace cobble::renderer
