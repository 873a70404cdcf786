// SPDX-License-Identifier: MIT
// All primitives of a prepared scene in flat arrays, and the trees over them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ir/math/affine.hpp"
#include "ir/math/vec.hpp"
#include "ir/scene/ids.hpp"
#include "ir/scene/scene.hpp"
#include "renderer/accel/tree.hpp"
#include "renderer/accel/wide_tree.hpp"
#include "renderer/geometry/primitives.hpp"

namespace cobble::renderer {

/// The triangles of a mesh that is placed by a matrix, however often. Its coordinates are relative
/// to `origin`, a grid point of the mesh's own space.
template <typename T>
struct PlacedMesh {
    std::vector<TrianglePrimitive<T>> triangles;  ///< in the order of the leaves; empty if `wide`
    Tree<T> tree;
    WideTree<T> wide;  ///< of the fast core, which needs no other
};

/// One way an instance stands: at rest the only one, else one of its keys.
template <typename T>
struct InstanceKey {
    /// Defines the instance: rays are mapped by it, in T.
    math::Affine<T> world_to_object;
    /// Its inverse in double, for the way back; between keys it is computed anew.
    math::Affined object_to_world;
};

/// A shape under a matrix. `shape_origin` (in the shape's space) is 0 after world_to_object.
template <typename T>
struct Instance {
    ir::ShapeKind kind =
        ir::ShapeKind::kMesh;  ///< of every kind but planes: they are composed with their matrix
    ir::ObjectId object;
    std::uint32_t first_key = 0;  ///< into Geometry::instance_keys
    std::uint32_t keys = 1;
    std::uint32_t mesh = 0;         ///< kMesh: into Geometry::meshes
    SpherePrimitive<T> sphere;      ///< kSphere
    BoxPrimitive<T> box;            ///< kBox
    TrianglePrimitive<T> triangle;  ///< kTriangle
    math::Vec3d shape_origin;
    BoxBounds<T> world_bounds;  ///< padded; for all time; one more box in what a hit is
};

/// Primitives of each kind in the order of the tree's leaves.
template <typename T>
struct Geometry {
    Tree<T> tree;      ///< over everything but the planes
    WideTree<T> wide;  ///< the same for the fast core: it holds triangles, spheres and boxes itself
    std::vector<TrianglePrimitive<T>> triangles;
    std::vector<SpherePrimitive<T>> spheres;
    std::vector<BoxPrimitive<T>> boxes;
    bool any_boxes = false;  ///< in `wide`, whose slots of boxes are numbered by their objects
    std::vector<MovingPrimitive> moving_triangles;
    std::vector<MovingPrimitive> moving_spheres;
    std::vector<Instance<T>> instances;
    std::vector<MovingPrimitive> planes;  ///< 1 key if at rest; endless, so each is tested

    std::vector<std::array<math::Vec3<T>, 3>> triangle_keys;
    std::vector<SphereKey<T>> sphere_keys;
    std::vector<PlaneKey> plane_keys;
    std::vector<InstanceKey<T>> instance_keys;
    std::vector<PlacedMesh<T>> meshes;

    /// Of each object, in the array of its kind: an instance, a moving triangle or sphere, a plane.
    /// kNone for the others, whose hits are looked up in the source.
    static constexpr std::uint32_t kNone = 0xffffffffU;
    struct Place {
        bool instance = false;
        std::uint32_t index = kNone;
    };
    std::vector<Place> places;
};

}  // namespace cobble::renderer
