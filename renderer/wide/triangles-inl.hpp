// SPDX-License-Identifier: MIT
// A block of triangles at once: what its edge functions and boxes leave open is decided one by one.
//
// Read again for each instruction set, so that its guard is Highway's and not a pragma.
#if defined(COBBLE_TRIANGLES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef COBBLE_TRIANGLES_INL
#undef COBBLE_TRIANGLES_INL
#else
#define COBBLE_TRIANGLES_INL
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "renderer/accel/wide_tree.hpp"
#include "renderer/query/query.hpp"
#include "renderer/wide/lanes-inl.hpp"
#include "renderer/wide/ray_rows-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

/// detail::edge_error() in lanes, with the threshold that intersect_triangle() adds.
template <class D, class V = hn::Vec<D>, typename T = hn::TFromD<D>>
HWY_INLINE V edge_errors(D d, V size, V depth) {
    const auto unit = [d](T times) HWY_ATTR { return hn::Set(d, times * kRounding<T>); };
    const auto reach = hn::Add(size, hn::Mul(unit(16), depth));
    return hn::Add(hn::Mul(unit(8), hn::Mul(reach, hn::Add(reach, depth))),
                   hn::Set(d, detail::kEdgeThreshold<T>));
}

/// RayShear in lanes: the origin along its axes kx, ky and kz, and the slopes.
template <class V>
struct ShearLanes {
    V ox, oy, oz, sx, sy;
};

/// The sheared corners, their edge functions, and what these may be off by.
template <class V>
struct EdgeLanes {
    V ax, ay, bx, by, cx, cy;
    V u, v, w;
    V error;
};

/// The arithmetic of intersect_triangle(); `corner(i, axis)` gives the corners, one ray's many or
/// many rays' one.
template <class D, typename Corner, class V = hn::Vec<D>>
HWY_INLINE EdgeLanes<V> edges_of(D d, const ShearLanes<V>& ray, std::size_t kx, std::size_t ky,
                                 std::size_t kz, Corner corner) {
    EdgeLanes<V> e;
    const V az = hn::Sub(corner(0, kz), ray.oz);
    const V bz = hn::Sub(corner(1, kz), ray.oz);
    const V cz = hn::Sub(corner(2, kz), ray.oz);
    e.ax = hn::Sub(hn::Sub(corner(0, kx), ray.ox), hn::Mul(ray.sx, az));
    e.bx = hn::Sub(hn::Sub(corner(1, kx), ray.ox), hn::Mul(ray.sx, bz));
    e.cx = hn::Sub(hn::Sub(corner(2, kx), ray.ox), hn::Mul(ray.sx, cz));
    e.ay = hn::Sub(hn::Sub(corner(0, ky), ray.oy), hn::Mul(ray.sy, az));
    e.by = hn::Sub(hn::Sub(corner(1, ky), ray.oy), hn::Mul(ray.sy, bz));
    e.cy = hn::Sub(hn::Sub(corner(2, ky), ray.oy), hn::Mul(ray.sy, cz));
    e.u = hn::Sub(hn::Mul(e.cx, e.by), hn::Mul(e.cy, e.bx));
    e.v = hn::Sub(hn::Mul(e.ax, e.cy), hn::Mul(e.ay, e.cx));
    e.w = hn::Sub(hn::Mul(e.bx, e.ay), hn::Mul(e.by, e.ax));
    const V size = hn::Add(
        hn::Add(hn::Add(hn::Abs(e.ax), hn::Abs(e.ay)), hn::Add(hn::Abs(e.bx), hn::Abs(e.by))),
        hn::Add(hn::Abs(e.cx), hn::Abs(e.cy)));
    e.error = edge_errors(d, size, hn::Add(hn::Add(hn::Abs(az), hn::Abs(bz)), hn::Abs(cz)));
    return e;
}

/// Two edge functions have opposite signs beyond what they may err by: what intersect_triangle()
/// refuses at once. Written so that NaN and infinity are "not sure".
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> surely_outside(D d, V u, V v, V w, V error) {
    const auto below = hn::Sub(hn::Zero(d), error);
    return hn::And(hn::Or(hn::Or(hn::Lt(u, below), hn::Lt(v, below)), hn::Lt(w, below)),
                   hn::Or(hn::Or(hn::Gt(u, error), hn::Gt(v, error)), hn::Gt(w, error)));
}

/// All edge functions have one sign, and none has lost bits to underflow or overflow:
/// detail::triangle_in_wide() accepts.
template <class D, class V = hn::Vec<D>, typename T = hn::TFromD<D>>
HWY_INLINE hn::Mask<D> surely_inside(D d, V u, V v, V w) {
    const auto least = hn::Set(d, detail::kEdgeThreshold<T>);
    const auto below = hn::Sub(hn::Zero(d), least);
    const auto same =
        hn::Or(hn::And(hn::And(hn::Ge(u, least), hn::Ge(v, least)), hn::Ge(w, least)),
               hn::And(hn::And(hn::Le(u, below), hn::Le(v, below)), hn::Le(w, below)));
    const auto sum = hn::Add(hn::Add(hn::Abs(u), hn::Abs(v)), hn::Abs(w));
    return hn::And(same, hn::Le(sum, hn::Set(d, std::numeric_limits<T>::max())));
}

/// What the edge functions and the triangle's own box leave open of a block.
template <typename T>
struct BlockHits {
    std::uint32_t open = 0;    ///< lanes that may hold a better hit: all others surely do not
    std::uint32_t sure = 0;    ///< those of them that the line surely meets
    std::uint32_t inside = 0;  ///< those of these that lie between t_min and t_max
    alignas(32) T points[3][2][kBlockLanes];  ///< of the open ones: corner, sheared x and y
};

/// The lanes of a block that hold what a ray has just left.
template <typename T>
HWY_INLINE std::uint32_t left_lanes(const TriangleBlock<T>& block, ir::ObjectId placed,
                                    const Exclude& exclude) {
    using D = hn::CappedTag<std::uint32_t, kBlockLanes>;
    const D d;
    constexpr std::size_t kLanes = hn::MaxLanes(D());
    const auto object = hn::Set(d, exclude.object.value);
    const auto face = hn::Set(d, exclude.face);
    std::uint32_t bits = 0;
    for (std::size_t part = 0; part < kBlockLanes; part += kLanes) {
        const auto of =
            placed.valid() ? hn::Set(d, placed.value) : hn::Load(d, &block.object[part].value);
        const auto same = hn::And(hn::Eq(of, object), hn::Eq(hn::Load(d, block.face + part), face));
        bits |= bits_of(d, same) << part;
    }
    return bits;
}

template <bool kParallel, typename T>
HWY_INLINE void test_edges(const TriangleBlock<T>& block, ir::ObjectId placed,
                           const RayLanes<T>& ray, const Search<T>& search, BlockHits<T>& hits) {
    using D = hn::CappedTag<T, kBlockLanes>;
    const D d;
    constexpr std::size_t kLanes = hn::MaxLanes(D());
    const ShearAxes s = ray.axes;
    const auto most = hn::Set(d, std::numeric_limits<T>::max());
    const ShearLanes<hn::Vec<D>> shear{hn::Set(d, ray.origin[s.x]), hn::Set(d, ray.origin[s.y]),
                                       hn::Set(d, ray.origin[s.z]), hn::Set(d, ray.sx),
                                       hn::Set(d, ray.sy)};
    for (std::size_t part = 0; part < kBlockLanes; part += kLanes) {
        const auto corner = [&](std::size_t i, std::size_t axis)
                                HWY_ATTR { return hn::Load(d, block.vertices[i][axis] + part); };
        const auto [ax, ay, bx, by, cx, cy, u, v, w, error] =
            edges_of(d, shear, s.x, s.y, s.z, corner);
        auto open = hn::Not(surely_outside(d, u, v, w, error));
        std::uint32_t left = bits_of(d, open) << part;
        if (HWY_LIKELY(left == 0)) continue;
        // A ray that leaves a surface always comes by here.
        left &= ~left_lanes(block, placed, search.exclude);
        if (left == 0) continue;

        auto near = hn::Set(d, std::numeric_limits<T>::lowest());
        auto far = most;
        for (std::size_t a = 0; a < 3; ++a) {
            const auto lo = hn::Min(hn::Min(corner(0, a), corner(1, a)), corner(2, a));
            const auto hi = hn::Max(hn::Max(corner(0, a), corner(1, a)), corner(2, a));
            const auto o = hn::Set(d, ray.origin[a]);
            if constexpr (kParallel) {
                if (ray.parallel[a]) {
                    open = hn::And(open, hn::And(hn::Le(lo, o), hn::Ge(hi, o)));
                    continue;
                }
            }
            const bool negative = (ray.signs >> a & 1) != 0;
            near = hn::Max(near, hn::Mul(hn::Sub(negative ? hi : lo, o),
                                         hn::Set(d, ray.inverse[a * ray.stride])));
            far = hn::Min(far, hn::Mul(hn::Sub(negative ? lo : hi, o),
                                       hn::Set(d, ray.inverse_far[a * ray.stride])));
        }
        const auto min = hn::Set(d, search.t_min);
        const auto best = hn::Set(d, search.best.t);
        open = hn::And(hn::And(open, hn::Le(near, far)),
                       hn::And(hn::Gt(far, min), hn::Le(near, best)));
        left &= bits_of(d, open) << part;
        if (left == 0) continue;
        const auto sure = hn::And(open, surely_inside(d, u, v, w));
        hits.open |= left;
        hits.sure |= bits_of(d, sure) << part;
        hits.inside |= bits_of(d, hn::And(sure, hn::And(hn::Gt(near, min), hn::Lt(far, best))))
                       << part;
        hn::Store(ax, d, hits.points[0][0] + part);
        hn::Store(ay, d, hits.points[0][1] + part);
        hn::Store(bx, d, hits.points[1][0] + part);
        hn::Store(by, d, hits.points[1][1] + part);
        hn::Store(cx, d, hits.points[2][0] + part);
        hn::Store(cy, d, hits.points[2][1] + part);
    }
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
    if ((hits.sure >> lane & 1) == 0) {
        test_triangle(ray, vertices, object, face, search);
        return;
    }
    const auto hit = detail::triangle_in_wide(ray.shear, vertices, points, search.rule);
    if (!hit) return;
    const Span<T> span = slab_span(ray.slabs, bounds_of(vertices));
    search.offer(clamp_to(span, hit->t), object, face, hit->u, hit->v);
}

/// True if any hit is asked for and found. One that is sure needs no t: its place in the order is
/// not asked.
template <bool kAny, bool kParallel, typename T>
HWY_INLINE bool test_block(const TriangleBlock<T>& block, std::uint32_t count, ir::ObjectId placed,
                           const RayLanes<T>& ray, FormsOnDemand<T>& forms, Search<T>& search) {
    search.primitive_tests += count;
    BlockHits<T> hits;
    test_edges<kParallel>(block, placed, ray, search, hits);
    std::uint32_t bits = hits.open & ((1U << count) - 1);
    while (bits != 0) {
        const auto lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
        bits &= bits - 1;
        const ir::ObjectId object = placed.valid() ? placed : block.object[lane];
        const std::uint32_t face = block.face[lane];
        if constexpr (kAny) {
            if ((hits.inside >> lane & 1) != 0 && search.instance_near < search.best.t) {
                search.best.object = object;
                return true;
            }
        }
        offer_lane(block, lane, hits, object, face, forms.get(), search);
        if constexpr (kAny) {
            if (search.best.object.valid()) return true;
        }
    }
    return false;
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
