// SPDX-License-Identifier: MIT
// Scenes of the hard cases with rays that go for their weak places: edges, vertices, corners and
// outlines, as many as one likes.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "tests/hard/scenes.hpp"

namespace cobble::test {

/// A ray in the world's coordinates; `target` is at t = 1.
struct AimedRay {
    Vec3d origin;
    Vec3d target;
    double time = 0;
};

struct Aim {
    int row = 0;  ///< of the hard cases
    std::string name;
    ir::Scene scene;
    /// Whether each of the rays starts in a closed thing, or over an endless one, so that one that
    /// hits nothing has slipped through.
    bool closed = false;
    std::function<AimedRay(Random&)> next;
};

/// All of them; the order is fixed.
std::vector<Aim> aims();

/// An aimed ray and others that go for much the same place from nearly the same one, as many as a
/// packet of the fast core takes. Some of them are the same ray; the others pass it at distances of
/// all orders of size. What the one cannot miss none of them can.
inline constexpr std::size_t kBundle = 64;
std::array<AimedRay, kBundle> bundle_of(const Aim& aim, Random& random);

/// Calls give(AimedRay) `count` times: `bundled` rays in whole bundles, and others one by one.
template <typename Give>
void aim_rays(const Aim& aim, std::size_t count, std::size_t bundled, Random& random, Give give) {
    std::size_t given = 0;
    for (; given + kBundle <= std::min(count, bundled); given += kBundle) {
        for (const AimedRay& r : bundle_of(aim, random)) give(r);
    }
    for (; given < count; ++given) give(aim.next(random));
}

/// As the ray loop of a prepared scene wants it.
template <typename T>
renderer::Ray<T> local_ray(const renderer::PreparedScene<T>& scene, const AimedRay& aimed) {
    renderer::Ray<T> r;
    r.origin = scene.to_local(aimed.origin);
    r.direction = scene.to_local(aimed.target) - r.origin;
    r.time = static_cast<T>(aimed.time);
    return r;
}

/// The five closed solids of rows 1 to 3.
std::vector<Solid> closed_solids();

/// A point of an edge, or a vertex, of the solid.
Vec3d on_edge(const Solid& solid, Random& random, bool vertex);

/// Triangles of a floor of 8 by 8 cells cut in three ways, so that edges end in the middle of
/// others, each triangle twice, wound either way, in the order of a shuffle.
std::vector<std::array<Vec3d, 3>> cut_floor(bool tilted, Random& random);

/// A point of the cut floor's edges and vertices, or at both anywhere: `i` goes through the kinds.
Vec3d on_cut_floor(bool tilted, std::uint32_t i, Random& random);

/// Three maps after each other: scales of the same order of size as `spread`, shears, a mirror.
math::Affined deep_map(Random& random, double spread);

}  // namespace cobble::test
