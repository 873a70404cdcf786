// SPDX-License-Identifier: MIT
// What the writers of scene files share.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string>

#include "ir/math/elementary.hpp"
#include "tools/bench/frames/scene_files.hpp"

namespace cobble::bench {

using Out = std::back_insert_iterator<std::string>;

/// "x y z", as short as reads back the same.
inline std::string words(math::Vec3d v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }
/// "<x,y,z>"
inline std::string pointed(math::Vec3d v) { return fmt::format("<{},{},{}>", v.x, v.y, v.z); }

/// Height of the picture's half at distance 1.
inline double half_height(const ir::Camera& camera) {
    const auto half = math::sincos(camera.angle / 2);
    return half.sin / half.cos;
}

}  // namespace cobble::bench
