// SPDX-License-Identifier: MIT
// Embree as a contestant, on the same rays: narrowed to float where ours are double, without
// exclusions, laid out beforehand as each call wants them.
#pragma once

#include <cstdint>
#include <vector>

#include "tools/bench/embree/embree_scene.hpp"
#include "tools/bench/rays/measure.hpp"
#include "tools/bench/rays/ray_sets.hpp"

namespace cobble::bench {

/// "embree-robust-1", "embree-fast-1"; for coherent rays also packets of 8 and 16. The scenes must
/// outlive the contestants.
template <typename T>
std::vector<Contestant> embree_contestants(const EmbreeScene& robust, const EmbreeScene& fast,
                                           const RaySet<T>& rays);

/// How Embree's answers differ from the reference's.
struct Disagreement {
    std::uint64_t hits = 0;       ///< one hits, the other does not
    std::uint64_t distances = 0;  ///< both hit, and t differs by more than a thousandth
};

template <typename T>
Disagreement count_disagreements(const EmbreeScene& scene, const RaySet<T>& rays);

}  // namespace cobble::bench
