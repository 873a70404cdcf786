// SPDX-License-Identifier: MIT
// Camera, lights, background and materials: what stands beside the objects.
#pragma once

#include <optional>
#include <vector>

#include "frontend/ast/views.hpp"
#include "ir/lower.hpp"
#include "ir/scene/scene.hpp"

namespace cobble::ir {

/// The images of one material, as loaded.
struct MaterialAssets {
    ImageId texture;
    ImageId normal_map;
    ImageId bump_map;
    CubeMapId cube_map;
};

/// The whole block, from its name to its last token.
source::Span span_of(const frontend::CheckedScene& checked, frontend::BlockNodeId block);
std::string label_of(const frontend::CheckedScene& checked, frontend::BlockNodeId block);

/// The first camera that has all it needs, or nothing. An `up` along the direction is replaced by
/// a perpendicular one, a lens without focus distance by a pinhole (both were reported).
std::optional<Camera> lower_camera(const frontend::CheckedScene& checked);

/// In textual order; lights that lack something are left out.
std::vector<Light> lower_lights(const frontend::CheckedScene& checked, const LowerOptions& options);

/// The last Background, or the defaults. `has_lights` false makes the ambient light 1 1 1.
Background lower_background(const frontend::CheckedScene& checked, const LowerOptions& options,
                            bool has_lights);

/// One child of Materials; broken ones become substitutes.
Material lower_material(const frontend::CheckedScene& checked, frontend::BlockNodeId block,
                        const MaterialAssets& assets, const LowerOptions& options);

}  // namespace cobble::ir
