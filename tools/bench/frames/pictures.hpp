// SPDX-License-Identifier: MIT
// The pictures that whole renderers are compared on.
#pragma once

#include <string_view>
#include <vector>

#include "tools/bench/inputs/input.hpp"

namespace cobble::bench {

struct PictureName {
    std::string_view name;
    std::string_view what;
    bool glass = false;  ///< spheres see through, nothing casts shadows, rays go eight deep
};

const std::vector<PictureName>& picture_names();

/// How often a ray may go on from a surface in a picture with glass.
inline constexpr unsigned kGlassBounces = 8;

/// `name` is one of picture_names(). Material 0 is matt; material 1, of pictures with glass, has a
/// refraction index.
Input make_picture(std::string_view name);

}  // namespace cobble::bench
