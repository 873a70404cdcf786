// SPDX-License-Identifier: MIT
// The pictures that a render is asked for: where each goes, and what speaks against it before
// anything is rendered.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "renderer/film/picture.hpp"
#include "renderer/settings.hpp"

namespace cobble::driver {

/// Where each picture goes; empty for those that are not wanted.
struct TargetPaths {
    std::string color, depth, normals, albedo, sample_count;
};

struct RenderTarget {
    std::string path;
    renderer::Plane32 renderer::Picture::*plane;  ///< of the result
    std::string_view name;                        ///< "color", "depth", ...: as in a ShardNote
};

/// Those that are wanted, the colour first.
std::vector<RenderTarget> targets_of(const TargetPaths& paths);

/// Whether each has a place to go: a format that holds it, a folder, room on the disk. Gives "" or
/// what is wrong; writes nothing.
std::string check_targets(const std::vector<RenderTarget>& targets, const renderer::Crop& window);

/// Whether this machine has the memory for so many pictures of this window, and for `more` bytes a
/// pixel that the render keeps. Gives "" or what is wrong.
std::string check_memory(std::size_t targets, const renderer::Crop& window, std::uint64_t more);

}  // namespace cobble::driver
