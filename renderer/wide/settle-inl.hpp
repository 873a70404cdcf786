// SPDX-License-Identifier: MIT
// The exact t, u and v of the triangles that a packet's rays have met.
//
// A triangle's t is computed in twice the precision, but lies by definition in what the triangle's
// own box spans: as long as these spans do not overlap, they order two hits, and only the last one
// of each ray needs its t.
//
// Read again for each instruction set, so that its guard is Highway's and not a pragma.
#if defined(COBBLE_SETTLE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef COBBLE_SETTLE_INL
#undef COBBLE_SETTLE_INL
#else
#define COBBLE_SETTLE_INL
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "renderer/wide/packet-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

inline math::Vec3<float> corner_of(const TriangleBlock<float>& block, std::size_t lane,
                                   std::size_t i) {
    return {block.vertices[i][0][lane], block.vertices[i][1][lane], block.vertices[i][2][lane]};
}

inline TrianglePrimitive<float> lane_of(const TriangleBlock<float>& block, std::size_t lane) {
    TrianglePrimitive<float> triangle;
    for (std::size_t i = 0; i < 3; ++i) triangle.vertices[i] = corner_of(block, lane, i);
    triangle.object = block.object[lane];
    triangle.face = block.face[lane];
    return triangle;
}

/// A ray's numbers along the axes.
inline math::Vec3<float> ray_row(const float (&rows)[3][kPacketRays], std::size_t ray) {
    return {rows[0][ray], rows[1][ray], rows[2][ray]};
}

inline Exclude exclude_of(const Packet& p, std::size_t ray) {
    return {ir::ObjectId{p.excluded_object[ray]}, p.excluded_face[ray],
            p.excluded_closed[ray] != p.excluded_object[ray]};
}

/// The shear of a ray, from what the packet has of it.
inline RayShear<float> shear_of(const Packet& p, std::size_t ray) {
    return {
        ray_row(p.origin, ray), ray_row(p.direction, ray), p.kx, p.ky, p.kz, p.sx[ray], p.sy[ray]};
}

/// What a single test asks and answers. Of any hit the bound alone says where a ray ends.
template <bool kAny>
inline Search<float> begin_search(const Packet& p, std::size_t ray) {
    Search<float> search;
    search.best = p.best[ray];
    if (kAny) search.best.t = p.bound[ray];
    search.t_min = p.t_min[ray];
    search.time = p.times[ray * p.time_step];
    search.exclude = exclude_of(p, ray);
    return search;
}

template <bool kAny>
inline void end_search(const Search<float>& search, Packet& p, std::size_t ray) {
    p.best[ray] = search.best;
    const bool through = kAny && search.best.object.valid();
    p.bound[ray] = through ? std::numeric_limits<float>::lowest() : search.best.t;
    p.least[ray] = p.bound[ray];
    p.box_tests += search.box_tests;
}

inline RayForms<float> forms_of(const Packet& p, std::size_t ray) {
    return {{ray_row(p.origin, ray), ray_row(p.inverse, ray), ray_row(p.inverse_far, ray)},
            shear_of(p, ray)};
}

/// Computes t, u and v of the triangle that is ahead, if there is one.
HWY_NOINLINE inline void settle(const WideTree<float>& tree, Packet& p, std::size_t ray) {
    const std::uint32_t ahead = p.ahead[ray];
    if (ahead == Packet::kNoTriangle) return;
    p.ahead[ray] = Packet::kNoTriangle;
    const auto triangle = lane_of(tree.triangles[ahead / kBlockLanes], ahead % kBlockLanes);
    const auto& v = triangle.vertices;
    const RayShear<float> shear = shear_of(p, ray);
    const auto hit = detail::triangle_in_wide(
        shear, v,
        {detail::shear(shear, v[0] - shear.origin), detail::shear(shear, v[1] - shear.origin),
         detail::shear(shear, v[2] - shear.origin)},
        EdgeRule::kInclusive);
    // It was sure to be met, and before anything else.
    const Span<float> span{p.least[ray], p.bound[ray]};
    p.best[ray] = {clamp_to(span, hit->t), triangle.object, triangle.face, hit->u, hit->v};
    p.bound[ray] = p.best[ray].t;
    p.least[ray] = p.best[ray].t;
}

/// The rays of a group for which a triangle waits, a bit each.
HWY_INLINE std::uint32_t waiting_rays(const Packet& p, std::size_t group) {
    const hn::RebindToUnsigned<Packet::D> du;
    const auto ahead = hn::Load(du, p.ahead + group * Packet::kLanes);
    return bits_of(du, hn::Ne(ahead, hn::Set(du, Packet::kNoTriangle)));
}

/// The triangles that wait for a group's rays: corner, axis, ray; and whose they are. Neighbours
/// mostly wait for the same one. Lanes that none waits for have whatever comes first.
struct CornersOfGroup {
    alignas(64) float at[3][3][Packet::kLanes];
    alignas(64) std::uint32_t object[Packet::kLanes];
    alignas(64) std::uint32_t face[Packet::kLanes];
};
HWY_INLINE void gather_corners(const WideTree<float>& tree, const Packet& p, std::size_t group,
                               std::uint32_t waiting, CornersOfGroup& corners) {
    const Packet::D d;
    const hn::RebindToUnsigned<Packet::D> du;
    const auto ahead = hn::Load(du, p.ahead + group * Packet::kLanes);
    hn::Vec<Packet::D> c[3][3];
    auto object = ahead;
    auto face = ahead;
    const auto each = [&](auto what) HWY_ATTR {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t axis = 0; axis < 3; ++axis) what(i, axis);
        }
    };
    bool some = false;
    while (waiting != 0) {
        const std::size_t ray =
            group * Packet::kLanes + hwy::Num0BitsBelowLS1Bit_Nonzero32(waiting);
        const std::uint32_t one = p.ahead[ray];
        const TriangleBlock<float>& block = tree.triangles[one / kBlockLanes];
        const std::size_t lane = one % kBlockLanes;
        const auto same = hn::Eq(ahead, hn::Set(du, one));
        waiting &= ~bits_of(du, same);
        object = hn::IfThenElse(same, hn::Set(du, block.object[lane].value), object);
        face = hn::IfThenElse(same, hn::Set(du, block.face[lane]), face);
        if (some) {
            const auto mask = hn::RebindMask(d, same);
            each([&](std::size_t i, std::size_t axis) HWY_ATTR {
                c[i][axis] =
                    hn::IfThenElse(mask, hn::Set(d, block.vertices[i][axis][lane]), c[i][axis]);
            });
        } else {
            each([&](std::size_t i, std::size_t axis)
                     HWY_ATTR { c[i][axis] = hn::Set(d, block.vertices[i][axis][lane]); });
        }
        some = true;
    }
    each([&](std::size_t i, std::size_t axis)
             HWY_ATTR { hn::Store(c[i][axis], d, corners.at[i][axis]); });
    hn::Store(object, du, corners.object);
    hn::Store(face, du, corners.face);
}

/// Vectors in lanes.
template <class V>
struct Vectors {
    V x, y, z;
};
template <class D, class V = hn::Vec<D>>
HWY_INLINE Vectors<V> widened(D d, const float* x, const float* y, const float* z) {
    const hn::Rebind<float, D> df;
    return {hn::PromoteTo(d, hn::Load(df, x)), hn::PromoteTo(d, hn::Load(df, y)),
            hn::PromoteTo(d, hn::Load(df, z))};
}
template <class D, class V = hn::Vec<D>>
HWY_INLINE Vectors<V> all_lanes(D d, math::Vec3d v) {
    return {hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
}
/// a b - c e
template <class D, class V = hn::Vec<D>>
HWY_INLINE V cross_of(D, V a, V b, V c, V e) {
    return hn::Sub(hn::Mul(a, b), hn::Mul(c, e));
}
template <class D, class V = hn::Vec<D>>
HWY_INLINE Vectors<V> difference(D, const Vectors<V>& a, const Vectors<V>& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
template <class D, class V = hn::Vec<D>>
HWY_INLINE Vectors<V> normal_of(D d, const Vectors<V>& p0, const Vectors<V>& p1,
                                const Vectors<V>& p2) {
    const auto a = difference(d, p1, p0);
    const auto b = difference(d, p2, p0);
    return {cross_of(d, a.y, b.z, a.z, b.y), cross_of(d, a.z, b.x, a.x, b.z),
            cross_of(d, a.x, b.y, a.y, b.x)};
}

/// Where rays meet planes, as met_at() has it; not where they run along them, `along` is 0.
template <class V>
struct PlaneMet {
    V t, along;
};
template <class D, class V = hn::Vec<D>>
HWY_INLINE PlaneMet<V> plane_met(D d, const Vectors<V>& normal, const Vectors<V>& point,
                                 const Vectors<V>& origin, const Vectors<V>& direction) {
    const auto product = [&](const Vectors<V>& b) HWY_ATTR {
        return hn::Add(hn::Add(hn::Mul(normal.x, b.x), hn::Mul(normal.y, b.y)),
                       hn::Mul(normal.z, b.z));
    };
    const V along = product(direction);
    return {hn::Div(product(difference(d, point, origin)), along), along};
}

/// clamp_to()
template <class D, class V = hn::Vec<D>>
HWY_INLINE V clamp_lanes(D, V t, V near, V far) {
    return hn::IfThenElse(hn::Lt(t, near), near, hn::IfThenElse(hn::Gt(t, far), far, t));
}

/// Of a group's rays for which a triangle waits: two triangles whose spans overlap, the one that
/// waits and another that they meet as surely, `triangle`. The t of both, as settle() has it; the
/// one that comes first then waits, and its span is its t. `near` and `far`: the other's span.
/// Returns the rays that see either edge-on, of which nothing is decided.
HWY_NOINLINE inline std::uint32_t put_in_order(const WideTree<float>& tree, Packet& p,
                                               std::size_t group, std::uint32_t rays,
                                               std::uint32_t triangle, const float* near,
                                               const float* far) {
    using D = hn::CappedTag<double, 8>;
    const D d;
    const hn::Rebind<float, D> df;
    const hn::RebindToUnsigned<decltype(df)> du;
    constexpr std::size_t kLanes = hn::MaxLanes(D());
    const TriangleBlock<float>& block = tree.triangles[triangle / kBlockLanes];
    const std::size_t lane = triangle % kBlockLanes;
    CornersOfGroup corners;
    gather_corners(tree, p, group, rays, corners);
    const math::Vec3d p0 = widen(corner_of(block, lane, 0));
    const math::Vec3d across =
        cross(widen(corner_of(block, lane, 1)) - p0, widen(corner_of(block, lane, 2)) - p0);
    std::uint32_t edge_on = 0;
    for (std::size_t part = 0; part < Packet::kLanes; part += kLanes) {
        const std::uint32_t some = rays >> part & ((1U << kLanes) - 1);
        if (some == 0) continue;
        const std::size_t at = group * Packet::kLanes + part;
        const auto of_ray = [&](const float(*rows)[kPacketRays]) HWY_ATTR {
            return widened(d, rows[0] + at, rows[1] + at, rows[2] + at);
        };
        const auto corner = [&](std::size_t c) HWY_ATTR {
            const auto& rows = corners.at[c];
            return widened(d, rows[0] + part, rows[1] + part, rows[2] + part);
        };
        const auto direction = of_ray(p.direction);
        const auto origin = of_ray(p.origin);
        const auto first = plane_met(d, normal_of(d, corner(0), corner(1), corner(2)), corner(0),
                                     origin, direction);
        const auto second = plane_met(d, all_lanes(d, across), all_lanes(d, p0), origin, direction);
        const auto zero = hn::Zero(d);
        const std::uint32_t open =
            bits_of(d, hn::Or(hn::Eq(first.along, zero), hn::Eq(second.along, zero))) & some;
        edge_on |= open << part;
        const auto t = clamp_lanes(df, hn::DemoteTo(df, first.t), hn::Load(df, p.least + at),
                                   hn::Load(df, p.bound + at));
        const auto other = clamp_lanes(df, hn::DemoteTo(df, second.t), hn::Load(df, near + part),
                                       hn::Load(df, far + part));
        // Where they are equal, what Search::offer() goes by.
        const auto object = hn::Load(du, corners.object + part);
        const auto face = hn::Load(du, corners.face + part);
        const auto its_object = hn::Set(du, block.object[lane].value);
        const auto before = hn::Or(
            hn::Gt(object, its_object),
            hn::And(hn::Eq(object, its_object), hn::Gt(face, hn::Set(du, block.face[lane]))));
        const auto replaced =
            hn::Or(hn::Lt(other, t), hn::And(hn::Eq(other, t), hn::RebindMask(df, before)));
        const auto decided = mask_of(df, some & ~open);
        const auto now = hn::IfThenElse(replaced, other, t);
        hn::BlendedStore(now, decided, df, p.least + at);
        hn::BlendedStore(now, decided, df, p.bound + at);
        hn::BlendedStore(hn::Set(du, triangle), hn::RebindMask(du, hn::And(decided, replaced)), du,
                         p.ahead + at);
    }
    return edge_on;
}

/// settle() of all rays: the same arithmetic, a lane each. Every lane of a group is computed, those
/// that no triangle waits for with that of another ray.
HWY_NOINLINE inline void settle_all(const WideTree<float>& tree, Packet& p) {
    using D = hn::CappedTag<double, 8>;
    using V = hn::Vec<D>;
    const D d;
    const hn::Rebind<float, D> df;
    constexpr std::size_t kLanes = hn::MaxLanes(D());
    std::uint32_t waiting = 0;
    CornersOfGroup corners;
    for (std::size_t at = 0; at < p.count; at += kLanes) {
        const std::size_t group = at / Packet::kLanes;
        const std::size_t in_group = at % Packet::kLanes;
        if (in_group == 0) {
            waiting = waiting_rays(p, group);
            if (waiting != 0) gather_corners(tree, p, group, waiting, corners);
        }
        if ((waiting >> in_group & ((1U << kLanes) - 1)) == 0) continue;
        const auto of_ray = [&](const float(*rows)[kPacketRays]) HWY_ATTR {
            return widened(d, rows[0] + at, rows[1] + at, rows[2] + at);
        };
        const auto corner = [&](std::size_t c) HWY_ATTR {
            const auto& rows = corners.at[c];
            return widened(d, rows[0] + in_group, rows[1] + in_group, rows[2] + in_group);
        };
        V x[3], y[3];
        const auto sx = hn::Load(df, p.sx + at);
        const auto sy = hn::Load(df, p.sy + at);
        for (std::size_t c = 0; c < 3; ++c) {
            const auto relative = [&](std::size_t axis) HWY_ATTR {
                return hn::Sub(hn::Load(df, corners.at[c][axis] + in_group),
                               hn::Load(df, p.origin[axis] + at));
            };
            const auto z = relative(p.kz);
            x[c] = hn::PromoteTo(d, hn::Sub(relative(p.kx), hn::Mul(sx, z)));
            y[c] = hn::PromoteTo(d, hn::Sub(relative(p.ky), hn::Mul(sy, z)));
        }
        const V u = cross_of(d, x[2], y[1], y[2], x[1]);
        const V v = cross_of(d, x[0], y[2], y[0], x[2]);
        const V w = cross_of(d, x[1], y[0], y[1], x[0]);
        const V det = hn::Add(hn::Add(u, v), w);
        const auto [t, along] = plane_met(d, normal_of(d, corner(0), corner(1), corner(2)),
                                          corner(0), of_ray(p.origin), of_ray(p.direction));
        const auto ts = clamp_lanes(df, hn::DemoteTo(df, t), hn::Load(df, p.least + at),
                                    hn::Load(df, p.bound + at));
        const auto number_of = [&](const std::uint32_t* numbers) HWY_ATTR {
            return hn::BitCast(df,
                               hn::Load(hn::RebindToUnsigned<decltype(df)>(), numbers + in_group));
        };
        // A hit's first four numbers side by side.
        alignas(64) float first_four[4 * kLanes];
        alignas(64) float vs[kLanes];
        hn::StoreInterleaved4(ts, number_of(corners.object), number_of(corners.face),
                              hn::DemoteTo(df, hn::Div(v, det)), df, first_four);
        hn::Store(hn::DemoteTo(df, hn::Div(w, det)), df, vs);
        const std::uint32_t edge_on = bits_of(d, hn::Eq(along, hn::Zero(d)));
        for (std::uint32_t left = waiting >> in_group & ((1U << kLanes) - 1); left != 0;
             left &= left - 1) {
            const auto i = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
            const std::size_t ray = at + i;
            if ((edge_on >> i & 1) != 0) {
                settle(tree, p, ray);
                continue;
            }
            static_assert(offsetof(Hit<float>, v) == 4 * sizeof(float));
            const hn::FixedTag<float, 4> four;
            hn::StoreU(hn::Load(four, first_four + 4 * i), four, &p.best[ray].t);
            p.best[ray].v = vs[i];
        }
    }
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
