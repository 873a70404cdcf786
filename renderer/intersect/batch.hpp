// SPDX-License-Identifier: MIT
// Questions to a prepared scene, many at once. Each ray's answer is that of closest_hit() or
// any_hit(), bit for bit: batches are there for speed alone.
#pragma once

#include <cstdint>
#include <span>

#include "renderer/intersect/intersect.hpp"

namespace cobble::renderer {

/// What a batch promises about its rays; believed for speed only.
enum class Coherence : std::uint8_t {
    kNone,      ///< nothing
    kCoherent,  ///< neighbours in the batch start and go nearly alike: from one camera, to one
                ///< light
};

/// closest_hit() of each ray into the hit at its index. All spans have one length.
template <typename T>
void closest_hits(const PreparedScene<T>& scene, std::span<const Ray<T>> rays,
                  std::span<const Exclude> excludes, std::span<Hit<T>> hits, Counters& counters,
                  Coherence coherence);

/// any_hit() of each ray: 1 if anything is in its way, else 0. All spans have one length.
template <typename T>
void any_hits(const PreparedScene<T>& scene, std::span<const Ray<T>> rays,
              std::span<const Exclude> excludes, std::span<std::uint8_t> hit, Counters& counters,
              Coherence coherence);

/// The same, without a copy: what has an object hit something, and nothing else of it means
/// anything.
template <typename T>
void any_hits(const PreparedScene<T>& scene, std::span<const Ray<T>> rays,
              std::span<const Exclude> excludes, std::span<Hit<T>> hits, Counters& counters,
              Coherence coherence);

/// The same of `hits.size()` rays in columns.
template <typename T>
void closest_hits(const PreparedScene<T>& scene, const RayColumns<T>& rays, std::span<Hit<T>> hits,
                  Counters& counters, Coherence coherence);
template <typename T>
void any_hits(const PreparedScene<T>& scene, const RayColumns<T>& rays, std::span<Hit<T>> hits,
              Counters& counters, Coherence coherence);

}  // namespace cobble::renderer
