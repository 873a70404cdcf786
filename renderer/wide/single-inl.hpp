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
HWY_INLINE void search_mesh(const WideTree<T>& tree, const RayForms<T>& ray, ir::ObjectId object,
                            Search<T>& search) {
    walk_wide<kAny, kParallel>(
        tree, static_cast<const ir::ObjectId*>(nullptr), ray,
        search, [&](ChildRef at) HWY_ATTR __attribute__((always_inline)) {
            test_block<kAny, kParallel>(tree.triangles[at.index()], at.count(), object, ray,
                                        search);
        });
}

template <bool kAny, typename T>
HWY_NOINLINE void search_placed_mesh(const WideTree<T>& tree, const RayForms<T>& ray,
                                     ir::ObjectId object, Search<T>& search) {
    if (ray.slabs.any_parallel) {
        search_mesh<kAny, true>(tree, ray, object, search);
    } else {
        search_mesh<kAny, false>(tree, ray, object, search);
    }
}

/// A leaf of anything but triangles and boxes.
template <bool kAny, typename T>
HWY_INLINE void test_leaf(const Geometry<T>& g, ChildRef at, const RayForms<T>& ray,
                          Search<T>& search) {
    switch (at.kind()) {
        case PrimitiveKind::kSphere: {
            const SphereBlock<T>& block = g.wide.spheres[at.index()];
            std::uint32_t bits = (1U << at.count()) - 1;
            if constexpr (sizeof(T) == sizeof(float)) bits &= met_spheres(block, ray);
            while (bits != 0) {
                const auto i = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
                bits &= bits - 1;
                test_sphere(ray, {block.center[0][i], block.center[1][i], block.center[2][i]},
                            block.radius[i], block.object[i], search);
            }
            break;
        }
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
        case PrimitiveKind::kBox:
            break;
    }
}

template <bool kAny, bool kParallel, typename T>
HWY_INLINE void search_world(const Geometry<T>& g, const RayForms<T>& ray, Search<T>& search) {
    const WideTree<T>& tree = g.wide;
    walk_wide<kAny, kParallel>(
        tree, g.box_objects.empty() ? nullptr : g.box_objects.data(), ray,
        search, [&](ChildRef at) HWY_ATTR __attribute__((always_inline)) {
            if (HWY_LIKELY(at.kind() == PrimitiveKind::kTriangle)) {
                test_block<kAny, kParallel>(tree.triangles[at.index()], at.count(), {}, ray,
                                            search);
            } else {
                test_leaf<kAny>(g, at, ray, search);
            }
        });
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

template <bool kAny, typename T>
HWY_INLINE Search<T> search_one(const Geometry<T>& g, const Ray<T>& ray, const Exclude& exclude) {
    Search<T> search = begin_search(ray, exclude);
    const RayForms<T> forms(ray.origin, ray.direction);
    for (const MovingPrimitive& plane : g.planes) test_plane(g, forms, plane, search);
    if (kAny && search.best.object.valid()) return search;
    if (HWY_UNLIKELY(forms.slabs.any_parallel)) {
        search_world<kAny, true>(g, forms, search);
    } else {
        search_world<kAny, false>(g, forms, search);
    }
    return search;
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
