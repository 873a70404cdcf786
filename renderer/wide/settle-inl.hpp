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

inline TrianglePrimitive<float> lane_of(const TriangleBlock<float>& block, std::size_t lane) {
    TrianglePrimitive<float> triangle;
    for (std::size_t i = 0; i < 3; ++i) {
        triangle.vertices[i] = {block.vertices[i][0][lane], block.vertices[i][1][lane],
                                block.vertices[i][2][lane]};
    }
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

/// settle() of all rays: the same arithmetic, a lane each. Every lane of a group is computed, those
/// that no triangle waits for with that of another ray.
HWY_NOINLINE inline void settle_all(const WideTree<float>& tree, Packet& p) {
    using D = hn::CappedTag<double, 8>;
    using V = hn::Vec<D>;
    const D d;
    const hn::Rebind<float, D> df;
    constexpr std::size_t kLanes = hn::MaxLanes(D());
    std::uint32_t waiting = 0;
    struct Vectors {
        V x, y, z;
    };
    const auto minus = [](const Vectors& a, const Vectors& b) HWY_ATTR {
        return Vectors{hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
    };
    const auto difference = [](V a, V b, V c, V e)
                                HWY_ATTR { return hn::Sub(hn::Mul(a, b), hn::Mul(c, e)); };
    const auto product = [](const Vectors& a, const Vectors& b) HWY_ATTR {
        return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
    };
    CornersOfGroup corners;
    for (std::size_t at = 0; at < p.count; at += kLanes) {
        const std::size_t group = at / Packet::kLanes;
        const std::size_t in_group = at % Packet::kLanes;
        if (in_group == 0) {
            waiting = waiting_rays(p, group);
            if (waiting != 0) gather_corners(tree, p, group, waiting, corners);
        }
        if ((waiting >> in_group & ((1U << kLanes) - 1)) == 0) continue;
        const auto widened = [&](const float* x, const float* y, const float* z) HWY_ATTR {
            return Vectors{hn::PromoteTo(d, hn::Load(df, x)), hn::PromoteTo(d, hn::Load(df, y)),
                           hn::PromoteTo(d, hn::Load(df, z))};
        };
        const auto of_ray = [&](const float(*rows)[kPacketRays]) HWY_ATTR {
            return widened(rows[0] + at, rows[1] + at, rows[2] + at);
        };
        const auto corner = [&](std::size_t c) HWY_ATTR {
            const auto& rows = corners.at[c];
            return widened(rows[0] + in_group, rows[1] + in_group, rows[2] + in_group);
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
        const V u = difference(x[2], y[1], y[2], x[1]);
        const V v = difference(x[0], y[2], y[0], x[2]);
        const V w = difference(x[1], y[0], y[1], x[0]);
        const V det = hn::Add(hn::Add(u, v), w);
        const Vectors p0 = corner(0);
        const Vectors a = minus(corner(1), p0);
        const Vectors b = minus(corner(2), p0);
        const Vectors normal{difference(a.y, b.z, a.z, b.y), difference(a.z, b.x, a.x, b.z),
                             difference(a.x, b.y, a.y, b.x)};
        const Vectors direction = of_ray(p.direction);
        const V along = product(normal, direction);
        const V t = hn::Div(product(normal, minus(p0, of_ray(p.origin))), along);
        const auto near = hn::Load(df, p.least + at);
        const auto far = hn::Load(df, p.bound + at);
        // clamp_to()
        auto ts = hn::DemoteTo(df, t);
        ts = hn::IfThenElse(hn::Lt(ts, near), near, hn::IfThenElse(hn::Gt(ts, far), far, ts));
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
