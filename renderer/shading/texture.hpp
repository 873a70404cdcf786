// SPDX-License-Identifier: MIT
// Pictures on surfaces: how texture coordinates find texels.
//
// The picture repeats. Texel centres lie at (i + 0.5) / size, v = 0 is the bottom row. Arithmetic
// is in double whatever the scene's precision, so that a texture holds still at large coordinates.
#pragma once

#include <cstdint>
#include <vector>

#include "ir/math/vec.hpp"
#include "ir/scene/assets.hpp"
#include "ir/scene/scene.hpp"

namespace cobble::renderer {

/// What stands for a picture that is not there, or coordinates that are no numbers.
inline constexpr ir::Color kErrorColor{1, 0, 1};

/// The colour of texel (x, y), y from the top: 8-bit values over 255, or the floats as they are.
ir::Color texel(const ir::Image& image, std::uint32_t x, std::uint32_t y);

/// x - floor(x), in [0, 1) even where that difference rounds to 1. Infinite or NaN gives NaN.
double wrap_unit(double x);

/// kErrorColor and black, eight fields a repeat; finite coordinates.
ir::Color error_checker(math::Vec2d uv);

/// Repeats; NaN or infinite coordinates give kErrorColor, a missing or empty image error_checker().
ir::Color sample_texture(const ir::Image& image, ir::TextureFilter filter, math::Vec2d uv);

/// The same on raw numbers: 8-bit values as 0 to 255, floats times 255. A picture of one value
/// gives that value to the bit, wherever it is asked. Missing: 128 128 255, which is flat. Not for
/// coordinates that are no numbers.
math::Vec3d sample_data(const ir::Image& image, ir::TextureFilter filter, math::Vec2d uv);

}  // namespace cobble::renderer
