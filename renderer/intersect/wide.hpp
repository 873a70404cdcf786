// SPDX-License-Identifier: MIT
// The walk through wide trees, by the best instruction set that the processor has. Private to this
// folder.
#pragma once

#include "renderer/intersect/query.hpp"
#include "renderer/scene/geometry.hpp"

namespace cobble::renderer {

/// Everything but the planes. `any`: ends at the first hit in the interval, whichever it is.
void search_wide(const Geometry<float>& geometry, const RayForms<float>& ray, Search<float>& search,
                 bool any);
void search_wide(const Geometry<double>& geometry, const RayForms<double>& ray,
                 Search<double>& search, bool any);

}  // namespace cobble::renderer
