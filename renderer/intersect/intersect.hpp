// SPDX-License-Identifier: MIT
// Questions to a prepared scene: what does a ray hit, is anything in the way, what is there.
//
// A hit: the primitive's test accepts, the slab test of its own box (exact extremes of its
// vertices; for an instance its padded world box too) accepts, and t is clamped to what that box
// spans. Slabs are monotone under rounding, so every box of the tree that encloses the primitive's
// spans no less, and a node is left out only if it begins strictly beyond the best t: the tree's
// answer equals that of testing everything, bit for bit.
//
// All functions are defined for float and double and reentrant; but for enumerate_hits() none
// allocates, locks or throws.
#pragma once

#include <vector>

#include "renderer/geometry/hit.hpp"
#include "renderer/geometry/ray.hpp"
#include "renderer/scene/prepared_scene.hpp"
#include "renderer/tile/counters.hpp"

namespace cobble::renderer {

/// The smallest (t, object, face) in the ray's interval; an invalid hit if there is none. Uses the
/// tree, or everything, as the scene was prepared. Adds to box_tests and primitive_tests.
template <typename T>
Hit<T> closest_hit(const PreparedScene<T>& scene, const Ray<T>& ray, const Exclude& exclude,
                   Counters& counters);

/// Whether closest_hit() would find anything; usually much cheaper.
template <typename T>
bool any_hit(const PreparedScene<T>& scene, const Ray<T>& ray, const Exclude& exclude,
             Counters& counters);

/// Tests every primitive, however the scene was prepared: what the tree is compared with.
template <typename T>
Hit<T> closest_hit_brute_force(const PreparedScene<T>& scene, const Ray<T>& ray,
                               const Exclude& exclude, Counters& counters);
template <typename T>
bool any_hit_brute_force(const PreparedScene<T>& scene, const Ray<T>& ray, const Exclude& exclude,
                         Counters& counters);

/// All hits in the ray's interval in (t, object, face) order, of one unmoved ray. Edges are
/// half-open here: a ray through an edge or a vertex of a closed mesh crosses each sheet of it
/// once, so that crossings can be counted. Spheres and boxes give both their ends. Slow; it
/// allocates.
template <typename T>
std::vector<Hit<T>> enumerate_hits(const PreparedScene<T>& scene, const Ray<T>& ray);

}  // namespace cobble::renderer
