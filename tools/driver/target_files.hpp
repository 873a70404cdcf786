// SPDX-License-Identifier: MIT
// A picture of a finished render as a file.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "ir/scene/scene.hpp"
#include "renderer/film/picture.hpp"
#include "renderer/settings.hpp"
#include "tools/driver/render_targets.hpp"

namespace cobble::driver {

/// What its pictures are made of and how they are to look.
struct TargetStyle {
    const ir::Scene& scene;
    const renderer::Settings& settings;
    /// What is white and black in 8-bit pictures of depth, if not what there is.
    std::optional<std::pair<double, double>> depth_range;
    std::string transfer;   ///< --transfer: "srgb" encodes colours
    bool is_shard = false;  ///< the file says which part of the render it is
    /// White in 8-bit pictures of sample counts; 0: the settings' samples.
    std::uint32_t most_samples = 0;
};

/// Encodes the plane by the ending of the target's path and writes the file whole. Gives "" or what
/// went wrong.
std::string write_target(const RenderTarget& target, const renderer::Picture& picture,
                         const TargetStyle& style);

}  // namespace cobble::driver
