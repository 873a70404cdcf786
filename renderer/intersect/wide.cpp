// SPDX-License-Identifier: MIT
#include "renderer/intersect/wide.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/intersect/wide.cpp"
#include <hwy/foreach_target.h>
// Behind foreach_target.h, as Highway wants it.
#include "renderer/intersect/wide-inl.hpp"

#if HWY_ONCE
namespace cobble::renderer {

HWY_EXPORT(search_wide_float);
HWY_EXPORT(search_wide_double);

void search_wide(const Geometry<float>& geometry, const RayForms<float>& ray, Search<float>& search,
                 bool any) {
    HWY_DYNAMIC_DISPATCH(search_wide_float)(geometry, ray, search, any);
}
void search_wide(const Geometry<double>& geometry, const RayForms<double>& ray,
                 Search<double>& search, bool any) {
    HWY_DYNAMIC_DISPATCH(search_wide_double)(geometry, ray, search, any);
}

}  // namespace cobble::renderer
#endif
