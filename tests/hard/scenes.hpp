// SPDX-License-Identifier: MIT
// Scenes and rays for the tests of hard cases, built without a file.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "ir/math/inverse.hpp"
#include "ir/scene/scene.hpp"
#include "renderer/intersect/intersect.hpp"
#include "renderer/intersect/surface.hpp"
#include "tests/oracle/random.hpp"

namespace cobble::test {

using math::Vec2d;
using math::Vec3;
using math::Vec3d;

/// A closed triangle mesh: positions and corners.
struct Solid {
    std::vector<Vec3d> positions;
    std::vector<std::array<std::uint32_t, 3>> faces;
};

Solid icosphere(int subdivisions);
/// A tetrahedron-like star: an icosphere whose vertices are pushed in or out at random, closed and
/// star-shaped around its centre.
Solid random_star(int subdivisions, std::uint64_t seed);
/// The unit square in x and y, two triangles, and its mirror 2 behind it, closed by sides.
Solid square_prism();
Solid transformed(Solid solid, double scale, Vec3d offset);

/// Fills a scene object by object; gives each one's id.
class SceneMaker {
  public:
    ir::Scene scene;

    SceneMaker();
    ir::ObjectId sphere(Vec3d center, double radius);
    ir::ObjectId moving_sphere(std::vector<ir::Sphere::Key> keys);
    ir::ObjectId triangle(Vec3d a, Vec3d b, Vec3d c);
    ir::ObjectId moving_triangle(std::vector<std::array<Vec3d, 3>> keys);
    ir::ObjectId box(Vec3d lo, Vec3d hi);
    ir::ObjectId plane(Vec3d normal, double offset);
    ir::ObjectId mesh(const Solid& solid);
    /// Places the last object's shape (or, with `again`, that object's once more) by these
    /// object-to-world maps, one per key.
    void place_last(const std::vector<math::Affined>& object_to_world);
    ir::ObjectId again(ir::ObjectId object);

  private:
    ir::ObjectId add(ir::ShapeKind kind, std::size_t shape);
};

math::Affined translation(Vec3d by);
math::Affined scaling(Vec3d by);
/// About a unit axis, radians.
math::Affined rotation(Vec3d axis, double angle);

template <typename T>
renderer::Ray<T> ray(Vec3d origin, Vec3d direction) {
    renderer::Ray<T> r;
    r.origin = origin.to<T>();
    r.direction = direction.to<T>();
    return r;
}

/// All members, by their bits but for the sign of zero.
template <typename T>
bool same(const renderer::Hit<T>& a, const renderer::Hit<T>& b) {
    return a.object == b.object &&
           (!a.object.valid() || (a.t == b.t && a.face == b.face && a.u == b.u && a.v == b.v));
}

/// Whether tree and brute force agree on closest and any hit; the hit itself in `hit`.
template <typename T>
bool tree_agrees(const renderer::PreparedScene<T>& scene, const renderer::Ray<T>& r,
                 const renderer::Exclude& exclude = {}, renderer::Hit<T>* hit = nullptr) {
    renderer::Counters counters;
    const auto a = renderer::closest_hit(scene, r, exclude, counters);
    const auto b = renderer::closest_hit_brute_force(scene, r, exclude, counters);
    const bool c = renderer::any_hit(scene, r, exclude, counters);
    if (hit != nullptr) *hit = a;
    return same(a, b) && c == a.object.valid();
}

}  // namespace cobble::test
