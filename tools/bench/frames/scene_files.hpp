// SPDX-License-Identifier: MIT
// One scene in the languages of several renderers: what inputs hold (meshes, spheres, boxes, matt
// material, glass, one point light), shaded alike, flat faces.
#pragma once

#include <string>

#include "tools/bench/frames/pictures.hpp"

namespace cobble::bench {

struct ScenePlan {
    PictureName picture;
    unsigned width = 1024, height = 768;
    unsigned samples = 1;  ///< a pixel, a square number
    std::string folder;    ///< where files go; it exists
};

/// Each writes what its program reads, and returns the path of the main file; "" if it cannot be
/// written.
std::string write_cobble_scene(const Input& input, const ScenePlan& plan);
std::string write_povray_scene(const Input& input, const ScenePlan& plan);
std::string write_tachyon_scene(const Input& input, const ScenePlan& plan);

/// False if it cannot be written.
bool write_text(const std::string& path, const std::string& text);

}  // namespace cobble::bench
