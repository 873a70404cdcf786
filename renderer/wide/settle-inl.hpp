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

/// The shear of a ray, from what the packet has of it.
inline RayShear<float> shear_of(const Packet& p, std::size_t ray) {
    return {p.rays[ray].origin, p.rays[ray].direction, p.kx, p.ky, p.kz, p.sx[ray], p.sy[ray]};
}

/// What a single test asks and answers.
inline Search<float> begin_search(const Packet& p, std::size_t ray) {
    Search<float> search;
    search.best = p.best[ray];
    search.t_min = p.t_min[ray];
    search.time = p.rays[ray].time;
    search.exclude = p.excludes[ray];
    return search;
}

template <bool kAny>
inline void end_search(const Search<float>& search, Packet& p, std::size_t ray) {
    p.best[ray] = search.best;
    const bool through = kAny && search.best.object.valid();
    p.bound[ray] = through ? std::numeric_limits<float>::lowest() : search.best.t;
    p.box_tests += search.box_tests;
}

inline RayForms<float> forms_of(const Packet& p, std::size_t ray) {
    const auto row = [ray](const float(&rows)[3][kPacketRays]) {
        return math::Vec3<float>{rows[0][ray], rows[1][ray], rows[2][ray]};
    };
    return {{p.rays[ray].origin, row(p.inverse), row(p.inverse_far)}, shear_of(p, ray)};
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
    const Span<float> span{p.ahead_near[ray], p.bound[ray]};
    p.best[ray] = {clamp_to(span, hit->t), triangle.object, triangle.face, hit->u, hit->v};
    p.bound[ray] = p.best[ray].t;
}

/// settle() of all rays: the same arithmetic, a lane each. Every lane is computed, those that no
/// triangle waits for with that of another ray.
HWY_NOINLINE inline void settle_all(const WideTree<float>& tree, Packet& p) {
    std::size_t some = p.count;
    for (std::size_t i = 0; i < p.count; ++i) {
        if (p.ahead[i] != Packet::kNoTriangle) some = i;
    }
    if (some == p.count) return;
    alignas(64) float corners[3][3][kPacketRays];
    for (std::size_t i = 0; i < kPacketRays; ++i) {
        const bool waits = i < p.count && p.ahead[i] != Packet::kNoTriangle;
        const std::uint32_t ahead = p.ahead[waits ? i : some];
        const TriangleBlock<float>& block = tree.triangles[ahead / kBlockLanes];
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t a = 0; a < 3; ++a) {
                corners[c][a][i] = block.vertices[c][a][ahead % kBlockLanes];
            }
        }
    }
    using D = hn::CappedTag<double, 8>;
    using V = hn::Vec<D>;
    const D d;
    const hn::Rebind<float, D> df;
    constexpr std::size_t kLanes = hn::MaxLanes(D());
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
    for (std::size_t at = 0; at < p.count; at += kLanes) {
        const auto load = [&](const float(*rows)[kPacketRays]) HWY_ATTR {
            return Vectors{hn::PromoteTo(d, hn::Load(df, rows[0] + at)),
                           hn::PromoteTo(d, hn::Load(df, rows[1] + at)),
                           hn::PromoteTo(d, hn::Load(df, rows[2] + at))};
        };
        V x[3], y[3];
        const auto sx = hn::Load(df, p.sx + at);
        const auto sy = hn::Load(df, p.sy + at);
        for (std::size_t c = 0; c < 3; ++c) {
            const auto relative = [&](std::size_t axis) HWY_ATTR {
                return hn::Sub(hn::Load(df, corners[c][axis] + at),
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
        const Vectors p0 = load(corners[0]);
        const Vectors a = minus(load(corners[1]), p0);
        const Vectors b = minus(load(corners[2]), p0);
        const Vectors normal{difference(a.y, b.z, a.z, b.y), difference(a.z, b.x, a.x, b.z),
                             difference(a.x, b.y, a.y, b.x)};
        const Vectors direction = load(p.direction);
        const V along = product(normal, direction);
        const V t = hn::Div(product(normal, minus(p0, load(p.origin))), along);
        alignas(64) float ts[kLanes], us[kLanes], vs[kLanes];
        hn::Store(hn::DemoteTo(df, t), df, ts);
        hn::Store(hn::DemoteTo(df, hn::Div(v, det)), df, us);
        hn::Store(hn::DemoteTo(df, hn::Div(w, det)), df, vs);
        const std::uint32_t edge_on = bits_of(d, hn::Eq(along, hn::Zero(d)));
        for (std::size_t i = 0; i < kLanes && at + i < p.count; ++i) {
            const std::size_t ray = at + i;
            if (p.ahead[ray] == Packet::kNoTriangle) continue;
            if ((edge_on >> i & 1) != 0) {
                settle(tree, p, ray);
                continue;
            }
            const std::uint32_t ahead = p.ahead[ray];
            const TriangleBlock<float>& block = tree.triangles[ahead / kBlockLanes];
            const Span<float> span{p.ahead_near[ray], p.bound[ray]};
            p.best[ray] = {clamp_to(span, ts[i]), block.object[ahead % kBlockLanes],
                           block.face[ahead % kBlockLanes], us[i], vs[i]};
        }
    }
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
