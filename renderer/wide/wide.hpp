// SPDX-License-Identifier: MIT
// The walk through wide trees, by the best instruction set that the processor has.
#pragma once

#include <cstddef>

#include "renderer/query/query.hpp"
#include "renderer/scene/geometry.hpp"
#include "renderer/tile/counters.hpp"

namespace cobble::renderer {

/// Coherent rays that are fewer than this are searched one by one: a packet is not worth beginning.
inline constexpr std::size_t kFewestTogether = 16;

/// `count` rays, in an array or in columns, against a scene prepared for the fast core. With `any`
/// a ray ends at the first hit in its interval, whichever it is, and only `object` has a meaning.
/// `coherent`: neighbours in the array go much the same way; a wrong word costs time, never an
/// answer.
template <typename T>
struct WideQuery {
    const Geometry<T>* geometry = nullptr;
    const Ray<T>* rays = nullptr;
    const Exclude* excludes = nullptr;
    std::size_t count = 0;
    bool any = false;
    bool coherent = false;
    const RayColumns<T>* columns =
        nullptr;  ///< the rays and what they leave out, if `rays` is null
};

void search_wide(const WideQuery<float>& query, Hit<float>* hits, Counters& counters);
void search_wide(const WideQuery<double>& query, Hit<double>* hits, Counters& counters);

}  // namespace cobble::renderer
