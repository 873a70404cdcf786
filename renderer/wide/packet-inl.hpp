// SPDX-License-Identifier: MIT
// Rays that go much the same way, side by side; in float alone.
//
// Read again for each instruction set, so that its guard is Highway's and not a pragma.
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

#include "renderer/accel/wide_tree.hpp"
#include "renderer/query/query.hpp"
#include "renderer/wide/lanes-inl.hpp"

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
    /// At leaves of triangles: groups that came, and rays in them that meet the leaf.
    std::uint64_t leaf_groups, leaf_rays;

    /// Whether going together was worth it for rays that ask for any hit: where each meets leaves
    /// of its own, they are faster alone.
    [[nodiscard]] bool stayed_together() const { return leaf_rays * 6 >= leaf_groups * kLanes; }
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
    p.leaf_groups = 0;
    p.leaf_rays = 0;
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

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
