// SPDX-License-Identifier: MIT
// Procedural marble: Perlin's improved noise, its octaves, and the two colours between them.
#pragma once

#include <cstdint>

#include "ir/math/vec.hpp"
#include "ir/scene/scene.hpp"

namespace cobble::renderer {

/// Perlin, "Improving Noise", SIGGRAPH 2002, with its permutation. In about [-1, 1]; 0 at lattice
/// points. Each coordinate wraps at 256, exactly: noise(x + 256 k) = noise(x) wherever x + 256 k is
/// a double. So there is no overflow, but from 2^53 on every double is a lattice point and the
/// noise is 0. NaN and infinity give 0.
double perlin_noise(math::Vec3d point);

/// Sum over i below `octaves` of noise(2^i point) / 2^i. Terms beyond the 53rd are less than the
/// sum's rounding and are left out, so a large count costs nothing.
double octave_noise(math::Vec3d point, std::uint32_t octaves);

/// How much of color1 is at a point of world space: (1 + sin(frequency x + amplitude N)) / 2.
double marble(const ir::Noise& noise, math::Vec3d point);

/// m color1 + (1 - m) color2.
ir::Color marble_color(const ir::Noise& noise, math::Vec3d point);

}  // namespace cobble::renderer
