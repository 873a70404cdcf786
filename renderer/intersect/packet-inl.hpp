// SPDX-License-Identifier: MIT
// Rays that go much the same way, through a wide tree together; compiled once for each instruction
// set, and for float alone.
//
// A node is first tried with intervals that hold all rays: eight children in one step. The slabs'
// arithmetic is monotone in the origin and in the inverse, so that the intervals' answer covers
// each ray's own. Only then groups of rays, a lane each, are tested against the children that are
// left.
//
// A triangle's t is computed in twice the precision, but lies by definition in what the triangle's
// own box spans: as long as these spans do not overlap, they order two hits, and only the last one
// of each ray needs its t.
#if defined(COBBLE_PACKET_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef COBBLE_PACKET_INL
#undef COBBLE_PACKET_INL
#else
#define COBBLE_PACKET_INL
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <limits>

#include "renderer/intersect/wide-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

inline constexpr std::size_t kPacketRays = 64;

struct Extremes {
    float least, greatest;
};

struct Packet {
    using D = hn::CappedTag<float, 16>;
    static constexpr std::size_t kLanes = hn::MaxLanes(D());
    static constexpr std::size_t kGroups = kPacketRays / kLanes;
    static constexpr std::uint32_t kNoTriangle = ~0U;

    alignas(64) float origin[3][kPacketRays];
    alignas(64) float direction[3][kPacketRays];  ///< 0 along a slope that vanishes
    alignas(64) float inverse[3][kPacketRays];
    alignas(64) float inverse_far[3][kPacketRays];
    alignas(64) float sx[kPacketRays];
    alignas(64) float sy[kPacketRays];
    alignas(64) float t_min[kPacketRays];
    /// What still counts begins at or before it: below t_min for rays that are through.
    alignas(64) float bound[kPacketRays];

    /// The span of the triangle that is ahead but whose t is not computed yet.
    float ahead_near[kPacketRays];
    std::uint32_t ahead[kPacketRays];  ///< block and lane, or kNoTriangle

    /// Of all rays: the axis and the planes that come first.
    std::size_t kx, ky, kz;
    bool negative[3];
    /// Over all rays.
    Extremes of_origin[3], of_inverse[3], of_inverse_far[3];
    float least_t_min;

    const Ray<float>* rays;
    const Exclude* excludes;
    std::size_t count;
    Hit<float>* best;  ///< of each ray; where a triangle is ahead, what it leaves behind
    std::uint64_t box_tests, primitive_tests;
};

HWY_INLINE Extremes extremes_of(const float* values) {
    const Packet::D d;
    auto least = hn::Load(d, values);
    auto greatest = least;
    for (std::size_t at = Packet::kLanes; at < kPacketRays; at += Packet::kLanes) {
        const auto v = hn::Load(d, values + at);
        least = hn::Min(least, v);
        greatest = hn::Max(greatest, v);
    }
    return {hn::GetLane(hn::MinOfLanes(d, least)), hn::GetLane(hn::MaxOfLanes(d, greatest))};
}

/// False if the rays do not all go the same way, or along an axis: then nothing is to be done with
/// the packet. The arithmetic of RaySlabs and RayShear.
inline bool gather(const Ray<float>* rays, const Exclude* excludes, std::size_t count,
                   Hit<float>* best, Packet& p) {
    p.best = best;
    p.box_tests = 0;
    p.primitive_tests = 0;
    p.rays = rays;
    p.excludes = excludes;
    p.count = count;
    const RayShear<float> first(rays[0].origin, rays[0].direction);
    p.kx = first.kx;
    p.ky = first.ky;
    p.kz = first.kz;
    for (std::size_t i = 0; i < kPacketRays; ++i) {
        const Ray<float>& ray = rays[i < count ? i : 0];
        for (std::size_t a = 0; a < 3; ++a) {
            p.origin[a][i] = ray.origin[a];
            p.direction[a][i] = ray.direction[a];
        }
        p.t_min[i] = ray.t_min;
    }
    const Packet::D d;
    for (std::size_t a = 0; a < 3; ++a) {
        const Extremes direction = extremes_of(p.direction[a]);
        p.negative[a] = direction.greatest < 0;
        if (!(direction.least > 0) && !p.negative[a]) return false;
        for (std::size_t at = 0; at < kPacketRays; at += Packet::kLanes) {
            const auto inverse = hn::Div(hn::Set(d, 1.0F), hn::Load(d, p.direction[a] + at));
            hn::Store(inverse, d, p.inverse[a] + at);
            hn::Store(hn::Mul(inverse, hn::Set(d, kFarSlack<float>)), d, p.inverse_far[a] + at);
        }
        p.of_origin[a] = extremes_of(p.origin[a]);
        p.of_inverse[a] = extremes_of(p.inverse[a]);
        p.of_inverse_far[a] = extremes_of(p.inverse_far[a]);
        const float most = std::numeric_limits<float>::max();
        if (!(p.of_inverse[a].greatest <= most && p.of_inverse[a].least >= -most)) return false;
    }
    p.least_t_min = extremes_of(p.t_min).least;
    const auto least_slope = hn::Set(d, detail::kEdgeThreshold<float>);
    for (std::size_t at = 0; at < kPacketRays; at += Packet::kLanes) {
        const auto z = hn::Load(d, p.direction[p.kz] + at);
        const auto x = hn::Load(d, p.direction[p.kx] + at);
        const auto y = hn::Load(d, p.direction[p.ky] + at);
        // The same axis is the longest for all, and by RayShear's rule for equals.
        const auto longest = hn::Abs(z);
        for (std::size_t a = 0; a < 3; ++a) {
            const auto other = hn::Abs(hn::Load(d, p.direction[a] + at));
            const bool wins_ties = a > p.kz;
            if (a != p.kz &&
                !hn::AllTrue(d, wins_ties ? hn::Gt(longest, other) : hn::Ge(longest, other))) {
                return false;
            }
        }
        const auto slope = [&](hn::Vec<Packet::D> of) HWY_ATTR {
            const auto s = hn::Div(of, z);
            return hn::IfThenElseZero(hn::Ge(hn::Abs(s), least_slope), s);
        };
        const auto sx = slope(x);
        const auto sy = slope(y);
        hn::Store(sx, d, p.sx + at);
        hn::Store(sy, d, p.sy + at);
        const auto zero = hn::Zero(d);
        hn::Store(hn::IfThenZeroElse(hn::Eq(sx, zero), x), d, p.direction[p.kx] + at);
        hn::Store(hn::IfThenZeroElse(hn::Eq(sy, zero), y), d, p.direction[p.ky] + at);
    }
    for (std::size_t i = 0; i < kPacketRays; ++i) {
        p.bound[i] = std::numeric_limits<float>::lowest();
        p.ahead[i] = Packet::kNoTriangle;
    }
    for (std::size_t i = 0; i < count; ++i) {
        constexpr float kMost = std::numeric_limits<float>::max();
        p.bound[i] = rays[i].t_max < kMost ? rays[i].t_max : kMost;
        best[i] = {p.bound[i], {}, 0, 0, 0};
    }
    return true;
}

/// Children that any of the rays may meet, and a t that none of them meets the child before.
HWY_INLINE std::uint32_t interval_hits(const WideNode<float>& node, const Packet& p, float bound,
                                       float* begins) {
    using D = SlabLanes<float>::D;
    const D d;
    constexpr std::size_t kLanes = hn::MaxLanes(D());
    std::uint32_t bits = 0;
    for (std::size_t part = 0; part < WideNode<float>::kWidth; part += kLanes) {
        auto near = hn::Set(d, p.least_t_min);
        auto far = hn::Set(d, bound);
        for (std::size_t a = 0; a < 3; ++a) {
            const bool negative = p.negative[a];
            const auto first = hn::Load(d, node.bounds[negative ? a + 3 : a] + part);
            const auto last = hn::Load(d, node.bounds[negative ? a : a + 3] + part);
            // Least of (first - o) * inverse: with a positive inverse the greatest origin gives the
            // least difference, with a negative one the least origin gives the greatest.
            const auto to_first = hn::Sub(
                first, hn::Set(d, negative ? p.of_origin[a].least : p.of_origin[a].greatest));
            const auto to_last = hn::Sub(
                last, hn::Set(d, negative ? p.of_origin[a].greatest : p.of_origin[a].least));
            near = hn::Max(near, hn::Min(hn::Mul(to_first, hn::Set(d, p.of_inverse[a].least)),
                                         hn::Mul(to_first, hn::Set(d, p.of_inverse[a].greatest))));
            far = hn::Min(far, hn::Max(hn::Mul(to_last, hn::Set(d, p.of_inverse_far[a].least)),
                                       hn::Mul(to_last, hn::Set(d, p.of_inverse_far[a].greatest))));
        }
        hn::Store(near, d, begins + part);
        bits |= bits_of(d, hn::Le(near, far)) << part;
    }
    return bits;
}

/// The rays of a group that meet the box in a slot of a node.
HWY_INLINE std::uint32_t group_hits(const WideNode<float>& node, std::size_t slot, const Packet& p,
                                    std::size_t group) {
    using D = Packet::D;
    const D d;
    const std::size_t at = group * Packet::kLanes;
    auto near = hn::Load(d, p.t_min + at);
    auto far = hn::Load(d, p.bound + at);
    for (std::size_t a = 0; a < 3; ++a) {
        const bool negative = p.negative[a];
        const auto o = hn::Load(d, p.origin[a] + at);
        const auto first = hn::Set(d, node.bounds[negative ? a + 3 : a][slot]);
        const auto last = hn::Set(d, node.bounds[negative ? a : a + 3][slot]);
        near = hn::Max(near, hn::Mul(hn::Sub(first, o), hn::Load(d, p.inverse[a] + at)));
        far = hn::Min(far, hn::Mul(hn::Sub(last, o), hn::Load(d, p.inverse_far[a] + at)));
    }
    return bits_of(d, hn::Le(near, far));
}

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
    return RayForms<float>(p.rays[ray].origin, p.rays[ray].direction);
}

/// Computes t, u and v of the triangle that is ahead, if there is one.
HWY_NOINLINE void settle(const WideTree<float>& tree, Packet& p, std::size_t ray) {
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
HWY_NOINLINE void settle_all(const WideTree<float>& tree, Packet& p) {
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

/// One ray and one triangle that its edge functions and its box leave open; `sure` if the line
/// meets it in any case.
template <bool kAny>
inline void meet(const WideTree<float>& tree, Packet& p, std::size_t ray, std::uint32_t triangle,
                 bool sure, float near, float far) {
    const TriangleBlock<float>& block = tree.triangles[triangle / kBlockLanes];
    const std::size_t lane = triangle % kBlockLanes;
    const Exclude& exclude = p.excludes[ray];
    if (block.object[lane] == exclude.object && block.face[lane] == exclude.face) return;
    const bool inside = sure && near > p.t_min[ray];
    if constexpr (kAny) {
        if (inside && far < p.best[ray].t) {
            p.best[ray].object = block.object[lane];
            p.bound[ray] = std::numeric_limits<float>::lowest();
            return;
        }
    } else {
        const bool waits = p.ahead[ray] != Packet::kNoTriangle;
        const float least = waits ? p.ahead_near[ray] : p.best[ray].t;
        if (inside && far < least) {
            p.ahead[ray] = triangle;
            p.ahead_near[ray] = near;
            p.bound[ray] = far;
            return;
        }
        // Whether this one is sure or not: it may turn out to lie before the one that waits.
        settle(tree, p, ray);
    }
    const auto one = lane_of(block, lane);
    Search<float> search = begin_search(p, ray);
    test_triangle(forms_of(p, ray), one.vertices, one.object, one.face, search);
    end_search<kAny>(search, p, ray);
}

/// One triangle against a group of rays.
template <bool kAny>
HWY_INLINE void test_triangle_group(const WideTree<float>& tree, std::uint32_t index, Packet& p,
                                    std::size_t group) {
    using D = Packet::D;
    const D d;
    const TriangleBlock<float>& block = tree.triangles[index / kBlockLanes];
    const std::size_t lane = index % kBlockLanes;
    const std::size_t at = group * Packet::kLanes;
    const auto corner = [&](std::size_t i, std::size_t axis)
                            HWY_ATTR { return hn::Set(d, block.vertices[i][axis][lane]); };
    const auto ox = hn::Load(d, p.origin[p.kx] + at);
    const auto oy = hn::Load(d, p.origin[p.ky] + at);
    const auto oz = hn::Load(d, p.origin[p.kz] + at);
    const auto sx = hn::Load(d, p.sx + at);
    const auto sy = hn::Load(d, p.sy + at);
    const auto az = hn::Sub(corner(0, p.kz), oz);
    const auto bz = hn::Sub(corner(1, p.kz), oz);
    const auto cz = hn::Sub(corner(2, p.kz), oz);
    const auto ax = hn::Sub(hn::Sub(corner(0, p.kx), ox), hn::Mul(sx, az));
    const auto bx = hn::Sub(hn::Sub(corner(1, p.kx), ox), hn::Mul(sx, bz));
    const auto cx = hn::Sub(hn::Sub(corner(2, p.kx), ox), hn::Mul(sx, cz));
    const auto ay = hn::Sub(hn::Sub(corner(0, p.ky), oy), hn::Mul(sy, az));
    const auto by = hn::Sub(hn::Sub(corner(1, p.ky), oy), hn::Mul(sy, bz));
    const auto cy = hn::Sub(hn::Sub(corner(2, p.ky), oy), hn::Mul(sy, cz));
    const auto u = hn::Sub(hn::Mul(cx, by), hn::Mul(cy, bx));
    const auto v = hn::Sub(hn::Mul(ax, cy), hn::Mul(ay, cx));
    const auto w = hn::Sub(hn::Mul(bx, ay), hn::Mul(by, ax));
    const auto au = hn::Abs(u);
    const auto av = hn::Abs(v);
    const auto aw = hn::Abs(w);
    const auto least = hn::Set(d, detail::kEdgeThreshold<float>);
    const auto most = hn::Set(d, std::numeric_limits<float>::max());
    const auto zero = hn::Zero(d);
    // Written so that NaN and infinity are "not sure".
    const auto sure =
        hn::And(hn::And(hn::Ge(au, least), hn::Ge(av, least)),
                hn::And(hn::Ge(aw, least), hn::Le(hn::Add(hn::Add(au, av), aw), most)));
    const auto below = hn::Or(hn::Or(hn::Lt(u, zero), hn::Lt(v, zero)), hn::Lt(w, zero));
    const auto above = hn::Or(hn::Or(hn::Gt(u, zero), hn::Gt(v, zero)), hn::Gt(w, zero));
    const auto open = hn::Not(hn::And(sure, hn::And(below, above)));
    if (hn::AllFalse(d, open)) return;

    auto near = hn::Set(d, std::numeric_limits<float>::lowest());
    auto far = most;
    for (std::size_t a = 0; a < 3; ++a) {
        float lo = block.vertices[0][a][lane];
        float hi = lo;
        for (std::size_t i = 1; i < 3; ++i) {
            const float c = block.vertices[i][a][lane];
            lo = c < lo ? c : lo;
            hi = c > hi ? c : hi;
        }
        const auto o = hn::Load(d, p.origin[a] + at);
        const bool negative = p.negative[a];
        near = hn::Max(near, hn::Mul(hn::Sub(hn::Set(d, negative ? hi : lo), o),
                                     hn::Load(d, p.inverse[a] + at)));
        far = hn::Min(far, hn::Mul(hn::Sub(hn::Set(d, negative ? lo : hi), o),
                                   hn::Load(d, p.inverse_far[a] + at)));
    }
    const auto min = hn::Load(d, p.t_min + at);
    const auto bound = hn::Load(d, p.bound + at);
    const auto left =
        hn::And(hn::And(open, hn::Le(near, far)), hn::And(hn::Gt(far, min), hn::Le(near, bound)));
    std::uint32_t bits = bits_of(d, left);
    if (bits == 0) return;
    const std::uint32_t sure_bits = bits_of(d, sure);
    alignas(64) float nears[Packet::kLanes];
    alignas(64) float fars[Packet::kLanes];
    hn::Store(near, d, nears);
    hn::Store(far, d, fars);
    do {
        const auto i = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
        bits &= bits - 1;
        meet<kAny>(tree, p, at + i, index, (sure_bits >> i & 1) != 0, nears[i], fars[i]);
    } while (bits != 0);
}

/// Everything else, one ray at a time.
template <bool kAny>
HWY_NOINLINE void test_others(const Geometry<float>& g, ChildRef at, Packet& p, std::size_t ray) {
    settle(g.wide, p, ray);
    Search<float> search = begin_search(p, ray);
    test_leaf<kAny>(g, at, forms_of(p, ray), search);
    p.primitive_tests += search.primitive_tests;
    end_search<kAny>(search, p, ray);
}

/// A box of the scene in a node's slot.
template <bool kAny>
HWY_NOINLINE void test_box_slot(const Geometry<float>& g, const WideNode<float>& node,
                                std::size_t slot, Packet& p, std::size_t ray) {
    settle(g.wide, p, ray);
    Search<float> search = begin_search(p, ray);
    test_box(forms_of(p, ray), slot_bounds(node, slot), g.box_objects[node.child[slot].index()],
             search);
    p.primitive_tests += 1;
    end_search<kAny>(search, p, ray);
}

template <bool kAny>
void test_planes(const Geometry<float>& g, Packet& p) {
    for (const MovingPrimitive& plane : g.planes) {
        for (std::size_t ray = 0; ray < p.count; ++ray) {
            Search<float> search = begin_search(p, ray);
            test_plane(g, forms_of(p, ray), plane, search);
            end_search<kAny>(search, p, ray);
        }
        p.primitive_tests += p.count;
    }
}

struct WaitingPart {
    float near;
    ChildRef child;
    std::uint32_t parent;  ///< the node whose slot it is
    std::uint8_t slot;
    std::uint8_t group;  ///< no group before this one meets it
};

inline float greatest_bound(const Packet& p) {
    using D = Packet::D;
    const D d;
    auto most = hn::Load(d, p.bound);
    for (std::size_t g = 1; g < Packet::kGroups; ++g) {
        most = hn::Max(most, hn::Load(d, p.bound + g * Packet::kLanes));
    }
    return hn::GetLane(hn::MaxOfLanes(d, most));
}

template <bool kAny>
HWY_NOINLINE void walk_packet(const Geometry<float>& g, Packet& p) {
    const WideTree<float>& tree = g.wide;
    if (tree.nodes.empty()) return;
    constexpr std::size_t kWidth = WideNode<float>::kWidth;
    WaitingPart stack[kMaxTreeDepth * (kWidth - 1) + kWidth];
    std::size_t waiting = 0;
    stack[waiting++] = {p.least_t_min, ChildRef::inner(0), 0, 0, 0};
    float bound = greatest_bound(p);
    std::uint64_t steps = 0;
    while (waiting != 0) {
        const WaitingPart at = stack[--waiting];
        if (at.near > bound) continue;
        if (at.child.is_inner()) {
            const WideNode<float>& node = tree.nodes[at.child.index()];
            ++steps;
            alignas(64) float begins[kWidth];
            std::uint32_t bits = interval_hits(node, p, bound, begins);
            const std::size_t base = waiting;
            while (bits != 0) {
                const auto slot = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
                bits &= bits - 1;
                std::size_t group = at.group;
                while (group < Packet::kGroups && group_hits(node, slot, p, group) == 0) ++group;
                if (group == Packet::kGroups) continue;
                const WaitingPart next{begins[slot], node.child[slot], at.child.index(),
                                       static_cast<std::uint8_t>(slot),
                                       static_cast<std::uint8_t>(group)};
                std::size_t place = waiting++;
                while (place > base && stack[place - 1].near < next.near) {
                    stack[place] = stack[place - 1];
                    --place;
                }
                stack[place] = next;
            }
            continue;
        }
        const WideNode<float>& parent = tree.nodes[at.parent];
        for (std::size_t group = at.group; group < Packet::kGroups; ++group) {
            std::uint32_t bits = group_hits(parent, at.slot, p, group);
            if (bits == 0) continue;
            if (at.child.kind() == PrimitiveKind::kTriangle) {
                p.primitive_tests += Packet::kLanes * at.child.count();
                const std::uint32_t first = at.child.index() * std::uint32_t{kBlockLanes};
                for (std::uint32_t i = 0; i < at.child.count(); ++i) {
                    test_triangle_group<kAny>(tree, first + i, p, group);
                }
                continue;
            }
            while (bits != 0) {
                const auto i = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
                bits &= bits - 1;
                const std::size_t ray = group * Packet::kLanes + i;
                if (at.child.kind() == PrimitiveKind::kBox) {
                    test_box_slot<kAny>(g, parent, at.slot, p, ray);
                } else {
                    test_others<kAny>(g, at.child, p, ray);
                }
            }
        }
        bound = greatest_bound(p);
        if (kAny && bound == std::numeric_limits<float>::lowest()) break;
    }
    if constexpr (!kAny) settle_all(tree, p);
    p.box_tests += steps * kWidth;
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
