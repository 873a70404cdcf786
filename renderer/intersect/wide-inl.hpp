// SPDX-License-Identifier: MIT
// One ray through a wide tree, compiled once for each instruction set. No include guard of the
// usual kind: Highway reads it again for each target.
#if defined(COBBLE_WIDE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef COBBLE_WIDE_INL
#undef COBBLE_WIDE_INL
#else
#define COBBLE_WIDE_INL
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <limits>

#include "renderer/accel/tree.hpp"
#include "renderer/accel/wide_tree.hpp"
#include "renderer/intersect/query.hpp"
#include "renderer/scene/geometry.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A ray's slabs with a copy in each lane.
template <typename T>
struct SlabLanes {
    using D = hn::CappedTag<T, WideNode<T>::kWidth>;
    using V = hn::Vec<D>;

    V origin[3], inverse[3], inverse_far[3];
    std::size_t near[3], far[3];  ///< which of a node's six rows of bounds come first and last

    explicit SlabLanes(const RaySlabs<T>& ray) {
        const D d;
        for (std::size_t a = 0; a < 3; ++a) {
            origin[a] = hn::Set(d, ray.origin[a]);
            inverse[a] = hn::Set(d, ray.inverse[a]);
            inverse_far[a] = hn::Set(d, ray.inverse_far[a]);
            near[a] = ray.negative[a] ? a + 3 : a;
            far[a] = ray.negative[a] ? a : a + 3;
        }
    }
};

template <class D>
HWY_INLINE std::uint32_t bits_of(D d, hn::Mask<D> mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    return bytes[0];
}

/// A bit for each slot whose box the ray meets in [t_min, t_best], and where it begins to. The
/// arithmetic of slab_span(), so that it is monotone with it.
template <bool kParallel, typename T>
HWY_INLINE std::uint32_t node_hits(const WideNode<T>& node, const RaySlabs<T>& ray,
                                   const SlabLanes<T>& lanes, T t_min, T t_best, T* begins) {
    using D = typename SlabLanes<T>::D;
    const D d;
    constexpr std::size_t kLanes = hn::MaxLanes(D());
    std::uint32_t bits = 0;
    for (std::size_t part = 0; part < WideNode<T>::kWidth; part += kLanes) {
        auto near = hn::Set(d, t_min);
        auto far = hn::Set(d, t_best);
        auto inside = hn::Eq(near, near);
        for (std::size_t a = 0; a < 3; ++a) {
            if constexpr (kParallel) {
                if (ray.parallel[a]) {
                    inside = hn::And(
                        inside,
                        hn::And(hn::Le(hn::Load(d, node.bounds[a] + part), lanes.origin[a]),
                                hn::Ge(hn::Load(d, node.bounds[a + 3] + part), lanes.origin[a])));
                    continue;
                }
            }
            near = hn::Max(near, hn::Mul(hn::Sub(hn::Load(d, node.bounds[lanes.near[a]] + part),
                                                 lanes.origin[a]),
                                         lanes.inverse[a]));
            far = hn::Min(far, hn::Mul(hn::Sub(hn::Load(d, node.bounds[lanes.far[a]] + part),
                                               lanes.origin[a]),
                                       lanes.inverse_far[a]));
        }
        auto met = hn::Le(near, far);
        if constexpr (kParallel) met = hn::And(met, inside);
        hn::Store(near, d, begins + part);
        bits |= bits_of(d, met) << part;
    }
    return bits;
}

/// The lanes of a block that may hold a better hit: all but those that the edge functions or the
/// triangle's own box surely rule out.
template <bool kParallel, typename T>
HWY_INLINE std::uint32_t triangle_candidates(const TriangleBlock<T>& block, const RayForms<T>& ray,
                                             T t_min, T t_best) {
    using D = hn::CappedTag<T, kBlockLanes>;
    const D d;
    constexpr std::size_t kLanes = hn::MaxLanes(D());
    const RayShear<T>& s = ray.shear;
    const auto least = hn::Set(d, detail::kEdgeThreshold<T>);
    const auto most = hn::Set(d, std::numeric_limits<T>::max());
    const auto sx = hn::Set(d, s.sx);
    const auto sy = hn::Set(d, s.sy);
    const auto ox = hn::Set(d, s.origin[s.kx]);
    const auto oy = hn::Set(d, s.origin[s.ky]);
    const auto oz = hn::Set(d, s.origin[s.kz]);
    std::uint32_t bits = 0;
    for (std::size_t part = 0; part < kBlockLanes; part += kLanes) {
        const auto corner = [&](std::size_t i, std::size_t axis)
                                HWY_ATTR { return hn::Load(d, block.vertices[i][axis] + part); };
        const auto az = hn::Sub(corner(0, s.kz), oz);
        const auto bz = hn::Sub(corner(1, s.kz), oz);
        const auto cz = hn::Sub(corner(2, s.kz), oz);
        const auto ax = hn::Sub(hn::Sub(corner(0, s.kx), ox), hn::Mul(sx, az));
        const auto bx = hn::Sub(hn::Sub(corner(1, s.kx), ox), hn::Mul(sx, bz));
        const auto cx = hn::Sub(hn::Sub(corner(2, s.kx), ox), hn::Mul(sx, cz));
        const auto ay = hn::Sub(hn::Sub(corner(0, s.ky), oy), hn::Mul(sy, az));
        const auto by = hn::Sub(hn::Sub(corner(1, s.ky), oy), hn::Mul(sy, bz));
        const auto cy = hn::Sub(hn::Sub(corner(2, s.ky), oy), hn::Mul(sy, cz));
        const auto u = hn::Sub(hn::Mul(cx, by), hn::Mul(cy, bx));
        const auto v = hn::Sub(hn::Mul(ax, cy), hn::Mul(ay, cx));
        const auto w = hn::Sub(hn::Mul(bx, ay), hn::Mul(by, ax));
        const auto au = hn::Abs(u);
        const auto av = hn::Abs(v);
        const auto aw = hn::Abs(w);
        // Written so that NaN and infinity are "not sure".
        const auto sure =
            hn::And(hn::And(hn::Ge(au, least), hn::Ge(av, least)),
                    hn::And(hn::Ge(aw, least), hn::Le(hn::Add(hn::Add(au, av), aw), most)));
        const auto zero = hn::Zero(d);
        const auto below = hn::Or(hn::Or(hn::Lt(u, zero), hn::Lt(v, zero)), hn::Lt(w, zero));
        const auto above = hn::Or(hn::Or(hn::Gt(u, zero), hn::Gt(v, zero)), hn::Gt(w, zero));
        auto open = hn::Not(hn::And(sure, hn::And(below, above)));
        if (hn::AllFalse(d, open)) continue;

        auto near = hn::Set(d, t_min);
        auto far = hn::Set(d, t_best);
        for (std::size_t a = 0; a < 3; ++a) {
            const auto lo = hn::Min(hn::Min(corner(0, a), corner(1, a)), corner(2, a));
            const auto hi = hn::Max(hn::Max(corner(0, a), corner(1, a)), corner(2, a));
            const auto o = hn::Set(d, ray.slabs.origin[a]);
            if constexpr (kParallel) {
                if (ray.slabs.parallel[a]) {
                    open = hn::And(open, hn::And(hn::Le(lo, o), hn::Ge(hi, o)));
                    continue;
                }
            }
            const bool negative = ray.slabs.negative[a];
            near = hn::Max(
                near, hn::Mul(hn::Sub(negative ? hi : lo, o), hn::Set(d, ray.slabs.inverse[a])));
            far = hn::Min(
                far, hn::Mul(hn::Sub(negative ? lo : hi, o), hn::Set(d, ray.slabs.inverse_far[a])));
        }
        bits |= bits_of(d, hn::And(open, hn::Le(near, far))) << part;
    }
    return bits;
}

template <typename T>
struct WaitingChild {
    T near;
    ChildRef child;
};

/// Walks one tree; `leaf(child, node, slot)` is asked for each leaf that may hold a better hit.
template <bool kAny, bool kParallel, typename T, typename Leaf>
HWY_INLINE void walk_wide(const WideTree<T>& tree, const RayForms<T>& ray, Search<T>& search,
                          Leaf leaf) {
    if (tree.nodes.empty()) return;
    constexpr std::size_t kWidth = WideNode<T>::kWidth;
    const SlabLanes<T> lanes(ray.slabs);
    const WideNode<T>* const nodes = tree.nodes.data();
    WaitingChild<T> stack[kMaxTreeDepth * (kWidth - 1) + kWidth];
    WaitingChild<T>* top = stack;
    ChildRef at = ChildRef::inner(0);
    std::uint64_t steps = 0;
    for (;;) {
        if (HWY_LIKELY(at.is_inner())) {
            const WideNode<T>& node = nodes[at.index()];
            ++steps;
            alignas(64) T begins[kWidth];
            std::uint32_t bits =
                node_hits<kParallel>(node, ray.slabs, lanes, search.t_min, search.best.t, begins);
            if (bits != 0) {
                const auto first = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
                bits &= bits - 1;
                if (bits == 0) {
                    at = node.child[first];
                    continue;
                }
                WaitingChild<T> nearest{begins[first], node.child[first]};
                WaitingChild<T>* const base = top;
                do {
                    const auto slot = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
                    bits &= bits - 1;
                    WaitingChild<T> next{begins[slot], node.child[slot]};
                    if (next.near < nearest.near) std::swap(next, nearest);
                    // The farthest first, so that the nearest is taken next.
                    WaitingChild<T>* place = top++;
                    while (place > base && place[-1].near < next.near) {
                        *place = place[-1];
                        --place;
                    }
                    *place = next;
                } while (bits != 0);
                at = nearest.child;
                continue;
            }
        } else {
            leaf(at);
            if constexpr (kAny) {
                if (search.best.object.valid()) break;
            }
        }
        // Strictly beyond the best: an equal t may still win by its object.
        do {
            if (top == stack) {
                search.box_tests += steps * kWidth;
                return;
            }
            --top;
        } while (top->near > search.best.t);
        at = top->child;
    }
    search.box_tests += steps * kWidth;
}

template <bool kAny, bool kParallel, typename T>
HWY_INLINE void test_block(const TriangleBlock<T>& block, std::uint32_t count, ir::ObjectId placed,
                           const RayForms<T>& ray, Search<T>& search) {
    std::uint32_t bits = triangle_candidates<kParallel>(block, ray, search.t_min, search.best.t) &
                         ((1U << count) - 1);
    search.primitive_tests += count;
    while (bits != 0) {
        const auto lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
        bits &= bits - 1;
        std::array<math::Vec3<T>, 3> vertices;
        for (std::size_t i = 0; i < 3; ++i) {
            vertices[i] = {block.vertices[i][0][lane], block.vertices[i][1][lane],
                           block.vertices[i][2][lane]};
        }
        const ir::ObjectId object = placed.valid() ? placed : block.object[lane];
        test_triangle(ray, vertices, object, block.face[lane], search);
    }
}

template <bool kAny, bool kParallel, typename T>
HWY_INLINE void search_mesh(const WideTree<T>& tree, const RayForms<T>& ray, ir::ObjectId object,
                            Search<T>& search) {
    walk_wide<kAny, kParallel>(tree, ray, search, [&](ChildRef at) HWY_ATTR {
        test_block<kAny, kParallel>(tree.triangles[at.index()], at.count(), object, ray, search);
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

template <bool kAny, typename T>
HWY_NOINLINE void test_rare(const Geometry<T>& g, ChildRef at, const RayForms<T>& ray,
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

template <bool kAny, bool kParallel, typename T>
HWY_INLINE void search_world(const Geometry<T>& g, const RayForms<T>& ray, Search<T>& search) {
    const WideTree<T>& tree = g.wide;
    walk_wide<kAny, kParallel>(tree, ray, search, [&](ChildRef at) HWY_ATTR {
        switch (at.kind()) {
            case PrimitiveKind::kTriangle:
                test_block<kAny, kParallel>(tree.triangles[at.index()], at.count(), {}, ray,
                                            search);
                break;
            case PrimitiveKind::kSphere: {
                const SphereBlock<T>& block = tree.spheres[at.index()];
                for (std::uint32_t i = 0; i < at.count(); ++i) {
                    test_sphere(ray, {block.center[0][i], block.center[1][i], block.center[2][i]},
                                block.radius[i], block.object[i], search);
                }
                break;
            }
            case PrimitiveKind::kBox:
                test_box(ray, g.boxes[at.index()].bounds, g.boxes[at.index()].object, search);
                break;
            default:
                test_rare<kAny>(g, at, ray, search);
        }
    });
}

template <typename T>
void search_any_way(const Geometry<T>& g, const RayForms<T>& ray, Search<T>& search, bool any) {
    const bool parallel = ray.slabs.any_parallel;
    if (any) {
        if (parallel) {
            search_world<true, true>(g, ray, search);
        } else {
            search_world<true, false>(g, ray, search);
        }
    } else if (parallel) {
        search_world<false, true>(g, ray, search);
    } else {
        search_world<false, false>(g, ray, search);
    }
}

void search_wide_float(const Geometry<float>& g, const RayForms<float>& ray, Search<float>& search,
                       bool any) {
    search_any_way(g, ray, search, any);
}
void search_wide_double(const Geometry<double>& g, const RayForms<double>& ray,
                        Search<double>& search, bool any) {
    search_any_way(g, ray, search, any);
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
