// SPDX-License-Identifier: MIT
// Our cores as contestants: the reference, and the fast core by each instruction set.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "renderer/scene/prepared_scene.hpp"
#include "tools/bench/rays/measure.hpp"
#include "tools/bench/rays/ray_sets.hpp"

namespace cobble::bench {

/// "cobble-reference"; then for each instruction set, the best first, "cobble-avx2" (one ray a
/// call) and "cobble-batch-avx2". What is passed must outlive the contestants.
template <typename T>
std::vector<Contestant> cobble_contestants(const renderer::PreparedScene<T>& reference,
                                           const renderer::PreparedScene<T>& fast,
                                           const RaySet<T>& rays);

/// How many answers of the fast core differ from the reference's in any bit of t, object, face, u
/// or v (any hit: in whether there is one), summed over instruction sets, one ray a call and in
/// batches. Prints the first of each to stderr.
template <typename T>
std::uint64_t count_differences(const renderer::PreparedScene<T>& reference,
                                const renderer::PreparedScene<T>& fast, const RaySet<T>& rays);

/// Nodes and leaves of the fast core's trees, with what they point into to be hit.
template <typename T>
std::uint64_t tree_bytes(const renderer::PreparedScene<T>& fast);

}  // namespace cobble::bench
