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
    return bytes[0] | std::uint32_t{bytes[1]} << 8;
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

/// What the edge functions and the triangle's own box leave open of a block.
template <typename T>
struct BlockHits {
    std::uint32_t open = 0;  ///< lanes that may hold a better hit: all others surely do not
    std::uint32_t inside =
        0;  ///< those of them that the line surely meets, between t_min and t_max
    alignas(32) T points[3][2][kBlockLanes];  ///< of the open ones: corner, sheared x and y
};

template <bool kParallel, typename T>
HWY_INLINE void test_edges(const TriangleBlock<T>& block, const RayForms<T>& ray, T t_min, T t_best,
                           BlockHits<T>& hits) {
    using D = hn::CappedTag<T, kBlockLanes>;
    const D d;
    constexpr std::size_t kLanes = hn::MaxLanes(D());
    const RayShear<T>& s = ray.shear;
    const auto least = hn::Set(d, detail::kEdgeThreshold<T>);
    const auto most = hn::Set(d, std::numeric_limits<T>::max());
    const auto zero = hn::Zero(d);
    const auto sx = hn::Set(d, s.sx);
    const auto sy = hn::Set(d, s.sy);
    const auto ox = hn::Set(d, s.origin[s.kx]);
    const auto oy = hn::Set(d, s.origin[s.ky]);
    const auto oz = hn::Set(d, s.origin[s.kz]);
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
        const auto below = hn::Or(hn::Or(hn::Lt(u, zero), hn::Lt(v, zero)), hn::Lt(w, zero));
        const auto above = hn::Or(hn::Or(hn::Gt(u, zero), hn::Gt(v, zero)), hn::Gt(w, zero));
        auto open = hn::Not(hn::And(sure, hn::And(below, above)));
        if (HWY_LIKELY(hn::AllFalse(d, open))) continue;

        auto near = hn::Set(d, std::numeric_limits<T>::lowest());
        auto far = most;
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
        const auto min = hn::Set(d, t_min);
        const auto best = hn::Set(d, t_best);
        open = hn::And(hn::And(open, hn::Le(near, far)),
                       hn::And(hn::Gt(far, min), hn::Le(near, best)));
        if (hn::AllFalse(d, open)) continue;
        hits.open |= bits_of(d, open) << part;
        hits.inside |=
            bits_of(d, hn::And(hn::And(open, sure), hn::And(hn::Gt(near, min), hn::Lt(far, best))))
            << part;
        hn::Store(ax, d, hits.points[0][0] + part);
        hn::Store(ay, d, hits.points[0][1] + part);
        hn::Store(bx, d, hits.points[1][0] + part);
        hn::Store(by, d, hits.points[1][1] + part);
        hn::Store(cx, d, hits.points[2][0] + part);
        hn::Store(cy, d, hits.points[2][1] + part);
    }
}

template <typename T>
struct WaitingChild {
    T near;
    ChildRef child;
};

/// The slots that are boxes of the scene.
template <typename T>
HWY_INLINE std::uint32_t box_slots(const WideNode<T>& node) {
    using D = hn::CappedTag<std::uint32_t, WideNode<T>::kWidth>;
    const D d;
    constexpr std::size_t kLanes = hn::MaxLanes(D());
    const auto box = hn::Set(d, ChildRef::leaf(PrimitiveKind::kBox, 0, 1).bits() >> 29);
    std::uint32_t bits = 0;
    for (std::size_t part = 0; part < WideNode<T>::kWidth; part += kLanes) {
        const auto child = hn::Load(d, reinterpret_cast<const std::uint32_t*>(node.child) + part);
        bits |= bits_of(d, hn::Eq(hn::ShiftRight<29>(child), box)) << part;
    }
    return bits;
}

template <typename T>
BoxBounds<T> slot_bounds(const WideNode<T>& node, std::size_t slot) {
    return {{node.bounds[0][slot], node.bounds[1][slot], node.bounds[2][slot]},
            {node.bounds[3][slot], node.bounds[4][slot], node.bounds[5][slot]}};
}

/// Walks one tree; `leaf(child)` is asked for each leaf that may hold a better hit. A slot that is
/// a box of the scene is tested at once: `boxes` says whose it is, or is null if there are none.
template <bool kAny, bool kParallel, typename T, typename Leaf>
HWY_INLINE void walk_wide(const WideTree<T>& tree, const ir::ObjectId* boxes,
                          const RayForms<T>& ray, Search<T>& search, Leaf leaf) {
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
            if (boxes != nullptr && bits != 0) {
                std::uint32_t own = bits & box_slots(node);
                bits &= ~own;
                while (own != 0) {
                    const auto slot = hwy::Num0BitsBelowLS1Bit_Nonzero32(own);
                    own &= own - 1;
                    test_box(ray, slot_bounds(node, slot), boxes[node.child[slot].index()], search);
                    if (kAny && search.best.object.valid()) {
                        search.box_tests += steps * kWidth;
                        return;
                    }
                }
            }
            if (bits != 0) {
                const auto first = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
                bits &= bits - 1;
                at = node.child[first];
                if (bits == 0) continue;
                if constexpr (kAny) {
                    // Any order will do: what is farther than the end has been left out already.
                    do {
                        const auto slot = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
                        bits &= bits - 1;
                        *top++ = {search.t_min, node.child[slot]};
                    } while (bits != 0);
                    continue;
                }
                const auto second = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
                bits &= bits - 1;
                const bool swapped = begins[second] < begins[first];
                const WaitingChild<T> pair[2] = {{begins[first], at},
                                                 {begins[second], node.child[second]}};
                at = pair[swapped ? 1 : 0].child;
                WaitingChild<T>* const base = top;
                *top++ = pair[swapped ? 0 : 1];
                if (bits == 0) continue;
                *top++ = pair[swapped ? 1 : 0];
                do {
                    const auto slot = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
                    bits &= bits - 1;
                    const WaitingChild<T> next{begins[slot], node.child[slot]};
                    // The farthest first, so that the nearest is taken next.
                    WaitingChild<T>* place = top++;
                    while (place > base && place[-1].near < next.near) {
                        *place = place[-1];
                        --place;
                    }
                    *place = next;
                } while (bits != 0);
                at = (--top)->child;
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

/// One open lane, as intersect_triangle() and test_triangle() go on with it.
template <typename T>
HWY_NOINLINE void offer_lane(const TriangleBlock<T>& block, std::size_t lane,
                             const BlockHits<T>& hits, ir::ObjectId object, std::uint32_t face,
                             const RayForms<T>& ray, Search<T>& search) {
    std::array<math::Vec3<T>, 3> vertices;
    std::array<detail::ShearedPoint<T>, 3> points;
    for (std::size_t i = 0; i < 3; ++i) {
        vertices[i] = {block.vertices[i][0][lane], block.vertices[i][1][lane],
                       block.vertices[i][2][lane]};
        points[i] = {hits.points[i][0][lane], hits.points[i][1][lane]};
    }
    const auto hit = detail::triangle_in_wide(ray.shear, vertices, points, search.rule);
    if (!hit) return;
    const Span<T> span = slab_span(ray.slabs, bounds_of(vertices));
    search.offer(clamp_to(span, hit->t), object, face, hit->u, hit->v);
}

/// Any hit that is sure needs no t: its place in the order is not asked.
template <bool kAny, bool kParallel, typename T>
HWY_INLINE void test_block(const TriangleBlock<T>& block, std::uint32_t count, ir::ObjectId placed,
                           const RayForms<T>& ray, Search<T>& search) {
    search.primitive_tests += count;
    BlockHits<T> hits;
    test_edges<kParallel>(block, ray, search.t_min, search.best.t, hits);
    std::uint32_t bits = hits.open & ((1U << count) - 1);
    while (bits != 0) {
        const auto lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
        bits &= bits - 1;
        const ir::ObjectId object = placed.valid() ? placed : block.object[lane];
        const std::uint32_t face = block.face[lane];
        if (object == search.exclude.object && face == search.exclude.face) continue;
        if constexpr (kAny) {
            if ((hits.inside >> lane & 1) != 0 && search.instance_near < search.best.t) {
                search.best.object = object;
                return;
            }
        }
        offer_lane(block, lane, hits, object, face, ray, search);
        if constexpr (kAny) {
            if (search.best.object.valid()) return;
        }
    }
}

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

/// The lanes that the line of the ray meets: the discriminant of intersect_sphere(), bit for bit.
HWY_INLINE std::uint32_t met_spheres(const SphereBlock<float>& block, const RayForms<float>& ray) {
    using D = hn::CappedTag<double, kBlockLanes>;
    const D d;
    const hn::Rebind<float, D> df;
    constexpr std::size_t kLanes = hn::MaxLanes(D());
    const math::Vec3d along = widen(ray.shear.direction);
    const auto dx = hn::Set(d, along.x);
    const auto dy = hn::Set(d, along.y);
    const auto dz = hn::Set(d, along.z);
    const auto a = hn::Set(d, dot(along, along));
    const auto zero = hn::Zero(d);
    const auto dot_of = [&](auto x0, auto y0, auto z0, auto x1, auto y1, auto z1) HWY_ATTR {
        return hn::Add(hn::Add(hn::Mul(x0, x1), hn::Mul(y0, y1)), hn::Mul(z0, z1));
    };
    std::uint32_t bits = 0;
    for (std::size_t part = 0; part < kBlockLanes; part += kLanes) {
        const auto relative = [&](std::size_t axis) HWY_ATTR {
            return hn::Sub(hn::Set(d, double{ray.shear.origin[axis]}),
                           hn::PromoteTo(d, hn::Load(df, block.center[axis] + part)));
        };
        const auto fx = relative(0);
        const auto fy = relative(1);
        const auto fz = relative(2);
        const auto r = hn::PromoteTo(d, hn::Load(df, block.radius + part));
        const auto b = hn::Sub(zero, dot_of(fx, fy, fz, dx, dy, dz));
        const auto q = hn::Div(b, a);
        const auto lx = hn::Add(fx, hn::Mul(dx, q));
        const auto ly = hn::Add(fy, hn::Mul(dy, q));
        const auto lz = hn::Add(fz, hn::Mul(dz, q));
        const auto rest = hn::Sub(hn::Mul(r, r), dot_of(lx, ly, lz, lx, ly, lz));
        bits |= bits_of(d, hn::Ge(rest, zero)) << part;
    }
    return bits;
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
