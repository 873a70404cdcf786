// SPDX-License-Identifier: MIT
// One ray through a scene.
//
// Read again for each instruction set, so that its guard is Highway's and not a pragma.
#if defined(COBBLE_SINGLE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef COBBLE_SINGLE_INL
#undef COBBLE_SINGLE_INL
#else
#define COBBLE_SINGLE_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "renderer/scene/geometry.hpp"
#include "renderer/wide/spheres-inl.hpp"
#include "renderer/wide/triangles-inl.hpp"
#include "renderer/wide/walk-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

template <bool kAny, bool kParallel, typename T>
HWY_INLINE void search_mesh(const WideTree<T>& tree, const RayLanes<T>& ray,
                            FormsOnDemand<T>& forms, ir::ObjectId object, Search<T>& search) {
    walk_wide<kAny, kParallel>(
        tree, NoBoxSlots(), ray, forms,
        search, [&](ChildRef at) HWY_ATTR __attribute__((always_inline)) {
            return test_block<kAny, kParallel>(tree.triangles[at.index()], at.count(), object, ray,
                                               forms, search);
        });
}

template <bool kAny, typename T>
HWY_NOINLINE void search_placed_mesh(const WideTree<T>& tree, const RayForms<T>& ray,
                                     ir::ObjectId object, Search<T>& search) {
    FormsOnDemand<T> forms(ray);
    const RayLanes<T> lanes(ray, false);
    if (ray.slabs.any_parallel) {
        search_mesh<kAny, true>(tree, lanes, forms, object, search);
    } else {
        search_mesh<kAny, false>(tree, lanes, forms, object, search);
    }
}

/// A leaf of what has no blocks.
template <bool kAny, typename T>
HWY_INLINE void test_leaf(const Geometry<T>& g, ChildRef at, const RayForms<T>& ray,
                          Search<T>& search) {
    switch (at.kind()) {
        case PrimitiveKind::kMovingTriangle:
            test_moving_triangle(g, ray, g.moving_triangles[at.index()], search);
            break;
        case PrimitiveKind::kMovingSphere:
            test_moving_sphere(g, ray, g.moving_spheres[at.index()], search);
            break;
        case PrimitiveKind::kInstance: {
            const Instance<T>& instance = g.instances[at.index()];
            test_instance(g, ray, instance, search,
                          [&](const PlacedMesh<T>& mesh, const RayForms<T>& inside) HWY_ATTR {
                              search_placed_mesh<kAny>(mesh.wide, inside, instance.object, search);
                          });
            break;
        }
        case PrimitiveKind::kTriangle:
        case PrimitiveKind::kSphere:
        case PrimitiveKind::kBox:
            break;
    }
}

template <bool kAny, bool kParallel, typename T, typename Boxes>
HWY_INLINE void search_world(const Geometry<T>& g, Boxes boxes, const RayLanes<T>& ray,
                             FormsOnDemand<T>& forms, Search<T>& search) {
    const WideTree<T>& tree = g.wide;
    // Boxes in slots must know the best hit.
    constexpr bool kWait = !kAny && !Boxes::kSome && sizeof(T) == sizeof(float);
    [[maybe_unused]] WaitingSphere waiting;
    walk_wide<kAny, kParallel>(
        tree, boxes, ray, forms, search, [&](ChildRef at) HWY_ATTR __attribute__((always_inline)) {
            if (at.kind() == PrimitiveKind::kSphere) {
                if constexpr (kWait) {
                    waiting.meet(tree.spheres[at.index()], ray, forms, search);
                    return false;
                } else {
                    return test_spheres<kAny>(tree.spheres[at.index()], ray, forms, search);
                }
            }
            if constexpr (kWait) waiting.settle(forms, search);
            if (HWY_LIKELY(at.kind() == PrimitiveKind::kTriangle)) {
                return test_block<kAny, kParallel>(tree.triangles[at.index()], at.count(), {}, ray,
                                                   forms, search);
            }
            test_leaf<kAny>(g, at, forms.get(), search);
            return kAny && search.best.object.valid();
        });
    if constexpr (kWait) waiting.settle(forms, search);
}

template <typename T>
Search<T> begin_search(const Ray<T>& ray, const Exclude& exclude) {
    Search<T> search;
    constexpr T kMost = std::numeric_limits<T>::max();
    search.best.t = ray.t_max < kMost ? ray.t_max : kMost;
    search.t_min = ray.t_min;
    search.time = ray.time;
    search.exclude = exclude;
    return search;
}

/// False if nothing is left to look for.
template <bool kAny, typename T>
HWY_INLINE bool test_planes(const Geometry<T>& g, FormsOnDemand<T>& forms, Search<T>& search) {
    for (const MovingPrimitive& plane : g.planes) test_plane(g, forms.get(), plane, search);
    return !(kAny && search.best.object.valid());
}

/// A ray on its own, whatever its direction.
template <bool kAny, typename T>
HWY_NOINLINE void search_alone(const Geometry<T>& g, const Ray<T>& ray, Search<T>& search) {
    const RayForms<T> made(ray.origin, ray.direction);
    FormsOnDemand<T> forms(made);
    if (!test_planes<kAny>(g, forms, search)) return;
    const RayLanes<T> lanes(made, sizeof(T) == sizeof(float));
    const BoxSlots<T> boxes;
    if (made.slabs.any_parallel) {
        search_world<kAny, true>(g, boxes, lanes, forms, search);
    } else {
        search_world<kAny, false>(g, boxes, lanes, forms, search);
    }
}

template <bool kAny, typename T, typename Boxes>
void search_rows(const Geometry<T>& g, Boxes boxes, const Ray<T>* rays, const Exclude* excludes,
                 std::size_t count, Hit<T>* hits, Counters& counters) {
    const auto land = [&](const Search<T>& search, std::size_t i) {
        hits[i] = search.best;
        counters.box_tests += search.box_tests;
        counters.primitive_tests += search.primitive_tests;
    };
    // Fewer than this are not worth the rows.
    constexpr std::size_t kFew = 4;
    for (std::size_t at = 0; at < count; at += RayRows<T>::kRays) {
        const std::size_t some = std::min(RayRows<T>::kRays, count - at);
        if (some < kFew) {
            for (std::size_t i = at; i < count; ++i) {
                Search<T> search = begin_search(rays[i], excludes[i]);
                search_alone<kAny>(g, rays[i], search);
                land(search, i);
            }
            return;
        }
        const RayRows<T> rows(rays + at, some);
        for (std::size_t i = 0; i < some; ++i) {
            const Ray<T>& ray = rays[at + i];
            Search<T> search = begin_search(ray, excludes[at + i]);
            if (HWY_UNLIKELY(rows.odd(i))) {
                search_alone<kAny>(g, ray, search);
            } else {
                FormsOnDemand<T> forms(ray);
                if (test_planes<kAny>(g, forms, search)) {
                    search_world<kAny, false>(g, boxes, rows.lanes(i), forms, search);
                }
            }
            land(search, at + i);
        }
    }
}

/// Rays that have nothing in common.
template <bool kAny, typename T>
void search_singly(const Geometry<T>& g, const Ray<T>* rays, const Exclude* excludes,
                   std::size_t count, Hit<T>* hits, Counters& counters) {
    if (!g.any_boxes) {
        search_rows<kAny>(g, NoBoxSlots(), rays, excludes, count, hits, counters);
    } else {
        search_rows<kAny>(g, BoxSlots<T>(), rays, excludes, count, hits, counters);
    }
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
