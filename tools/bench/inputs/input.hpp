// SPDX-License-Identifier: MIT
// The scenes that the benchmarks measure with, made by themselves and the same in every run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ir/math/vec.hpp"
#include "ir/scene/scene.hpp"

namespace cobble::bench {

/// A scene with a camera, one material and one point light.
struct Input {
    std::string name;   ///< as options name it
    std::string title;  ///< with what it is made of
    ir::Scene scene;
    /// The same surfaces for whoever has no boxes: only the faces that are not between two blocks.
    std::optional<ir::Scene> triangles;

    [[nodiscard]] const ir::Scene& for_peers() const { return triangles ? *triangles : scene; }
};

struct InputName {
    std::string_view name;
    std::string_view what;
    bool on_request = false;  ///< too large to be measured unless it is named
};

/// All that make_input() knows.
const std::vector<InputName>& input_names();

/// `name` is one of input_names().
Input make_input(std::string_view name);

/// The mesh of an OBJ file, seen from outside its bounding box. None if it cannot be read or holds
/// no face; `problem` then says why.
std::optional<Input> read_input(const std::string& path, std::string& problem);

/// A camera at `eye` that looks at `target`; `angle` is the full vertical opening in radians.
void aim_camera(ir::Scene& scene, math::Vec3d eye, math::Vec3d target, double angle);

/// One white matt material and one point light.
ir::Scene empty_scene(math::Vec3d light);

void add_object(ir::Scene& scene, ir::ShapeKind kind, std::size_t shape);

/// Triangles, spheres and boxes as stored; a mesh that is placed often counts once.
std::size_t stored_primitives(const ir::Scene& scene);

/// A lumpy ball above hills, half of about `triangles` each.
Input mesh_input(std::uint32_t triangles);
/// Balls of different size, some overlapping, in a ball.
Input sphere_input(std::uint32_t count);
/// Hills of unit cubes, three deep and more at steps; about 250,000 of them.
Input block_input(bool as_boxes);
/// One tree of some 3,000 triangles, placed `count` times over a ground.
Input forest_input(std::uint32_t count);

/// Appends a corner without normal or texture coordinates for each vertex.
void add_face(ir::Mesh& mesh, std::size_t a, std::size_t b, std::size_t c);

}  // namespace cobble::bench
