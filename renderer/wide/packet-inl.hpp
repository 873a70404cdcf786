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

/// Neighbours in a packet, bounded together.
inline constexpr std::size_t kBeams = 4;
inline constexpr std::size_t kBeamRays = kPacketRays / kBeams;

/// Intervals that hold each beam's rays. Rows for a node have a beam's number eight times side by
/// side, one for each child; rows for a block of triangles four times.
struct Beams {
    static constexpr std::size_t kOfNode = kBeams * WideNode<float>::kWidth;
    static constexpr std::size_t kOfBlock = kBeams * kBlockLanes;

    /// By axis. The origin that comes nearest to the first plane of a slab, and to the last.
    alignas(64) float to_first[3][kOfNode];
    alignas(64) float to_last[3][kOfNode];
    alignas(64) float least_inverse[3][kOfNode];
    alignas(64) float greatest_inverse[3][kOfNode];
    alignas(64) float least_far[3][kOfNode];
    alignas(64) float greatest_far[3][kOfNode];
    alignas(64) float t_min[kOfNode];
    alignas(64) float bound[kOfNode];  ///< the greatest of its rays

    /// Of the origin along kx, ky, kz, and of the slopes sx and sy.
    alignas(64) float middle[5][kOfBlock];
    alignas(64) float radius[5][kOfBlock];
};

/// A bit for each beam, where the bits for its children begin.
inline constexpr std::uint32_t kAllBeams = 0x01010101;

struct Packet {
    using D = hn::CappedTag<float, 16>;
    static constexpr std::size_t kLanes = hn::MaxLanes(D());
    static constexpr std::size_t kGroups = kPacketRays / kLanes;
    static constexpr std::size_t kBeamGroups = kBeamRays / kLanes;
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

    /// What a triangle must surely lie before to be the one ahead: the best t, or where the span
    /// begins of the triangle that is ahead but whose t is not computed yet.
    alignas(64) float least[kPacketRays];
    alignas(64) std::uint32_t ahead[kPacketRays];  ///< block and lane, or kNoTriangle

    /// Of all rays: the axis and the planes that come first.
    std::size_t kx, ky, kz;
    bool negative[3];
    Beams beams;

    const Ray<float>* rays;
    const Exclude* excludes;
    bool some_excluded;
    alignas(64) std::uint32_t excluded_object[kPacketRays];  ///< only if some_excluded
    alignas(64) std::uint32_t excluded_face[kPacketRays];
    /// Whether bounding triangles by beams has paid lately.
    bool bounds_pay;
    std::size_t count;
    Hit<float>* best;  ///< of each ray; where a triangle is ahead, what it leaves behind
    std::uint64_t box_tests, primitive_tests;
    /// At leaves of triangles: groups that came, and rays in them that meet the leaf.
    std::uint64_t leaf_groups, leaf_rays;

    /// Whether going together was worth it for rays that ask for any hit: where each meets leaves
    /// of its own, they are faster alone.
    [[nodiscard]] bool stayed_together() const { return leaf_rays * 6 >= leaf_groups * kLanes; }
};

/// A number for each beam.
using BeamTag = hn::FixedTag<float, kBeams>;

struct Extremes {
    hn::Vec<BeamTag> least, greatest;
};

/// What is left of a vector when its blocks of four lanes are reduced to one.
template <class D, class V, typename Pick>
HWY_INLINE auto fold_blocks(D, V v, Pick pick) {
    if constexpr (hn::MaxLanes(D()) > 4) {
        const hn::Half<D> half;
        return fold_blocks(half, pick(hn::LowerHalf(half, v), hn::UpperHalf(half, v)), pick);
    } else {
        return v;
    }
}

/// Blocks of four lanes, the first from `from` and each next one `stride` numbers behind.
template <class D>
HWY_INLINE hn::Vec<D> load_blocks(D d, const float* from, std::size_t stride) {
    if constexpr (hn::MaxLanes(D()) > 4) {
        const hn::Half<D> half;
        constexpr std::size_t kBlocks = hn::MaxLanes(D()) / 8;
        return hn::Combine(d, load_blocks(half, from + kBlocks * stride, stride),
                           load_blocks(half, from, stride));
    } else {
        return hn::LoadU(d, from);
    }
}

/// Of a number of each ray, by beams: lanes are reduced while they are transposed.
HWY_INLINE Extremes extremes_of(const float* values) {
    const Packet::D d;
    const auto reduce = [&](auto pick) HWY_ATTR {
        hn::Vec<Packet::D> v[kBeams];
        for (std::size_t b = 0; b < kBeams; ++b) {
            v[b] = hn::Load(d, values + b * kBeamRays);
            for (std::size_t at = Packet::kLanes; at < kBeamRays; at += Packet::kLanes) {
                v[b] = pick(v[b], hn::Load(d, values + b * kBeamRays + at));
            }
        }
        const auto even =
            pick(hn::InterleaveLower(d, v[0], v[2]), hn::InterleaveUpper(d, v[0], v[2]));
        const auto odd =
            pick(hn::InterleaveLower(d, v[1], v[3]), hn::InterleaveUpper(d, v[1], v[3]));
        const auto all = pick(hn::InterleaveLower(d, even, odd), hn::InterleaveUpper(d, even, odd));
        return fold_blocks(d, all, pick);
    };
    return {reduce([](auto a, auto b) HWY_ATTR { return hn::Min(a, b); }),
            reduce([](auto a, auto b) HWY_ATTR { return hn::Max(a, b); })};
}

/// Writes a row of Beams: each beam's number kTimes side by side.
template <std::size_t kTimes>
HWY_INLINE void spread(hn::Vec<BeamTag> of_beams, float* row) {
    const hn::CappedTag<float, kTimes> d;
    constexpr std::size_t kLanes = hn::MaxLanes(hn::CappedTag<float, kTimes>());
    alignas(16) float numbers[kBeams];
    hn::Store(of_beams, BeamTag(), numbers);
    for (std::size_t b = 0; b < kBeams; ++b) {
        for (std::size_t at = 0; at < kTimes; at += kLanes) {
            hn::Store(hn::Set(d, numbers[b]), d, row + b * kTimes + at);
        }
    }
}
HWY_INLINE void spread_to_node(hn::Vec<BeamTag> of_beams, float* row) {
    spread<WideNode<float>::kWidth>(of_beams, row);
}

/// The middle of an interval as it happens to be rounded, and how far it is to the ends at most.
HWY_INLINE void spread_to_block(const Extremes& of, Beams& beams, std::size_t row) {
    const BeamTag d;
    const auto half = hn::Set(d, 0.5F);
    const auto middle = hn::Add(hn::Mul(of.least, half), hn::Mul(of.greatest, half));
    const auto radius = hn::Mul(hn::Max(hn::Sub(of.greatest, middle), hn::Sub(middle, of.least)),
                                hn::Set(d, 1 + 4 * std::numeric_limits<float>::epsilon()));
    spread<kBlockLanes>(middle, beams.middle[row]);
    spread<kBlockLanes>(radius, beams.radius[row]);
}

/// Each beam's greatest bound, after rays of it have found something.
HWY_INLINE void update_bound(Packet& p, std::size_t beam) {
    const Packet::D d;
    auto most = hn::Load(d, p.bound + beam * kBeamRays);
    for (std::size_t at = Packet::kLanes; at < kBeamRays; at += Packet::kLanes) {
        most = hn::Max(most, hn::Load(d, p.bound + beam * kBeamRays + at));
    }
    most = hn::MaxOfLanes(d, most);
    constexpr std::size_t kWidth = WideNode<float>::kWidth;
    const hn::CappedTag<float, kWidth> row;
    for (std::size_t at = 0; at < kWidth; at += hn::Lanes(row)) {
        hn::Store(hn::Set(row, hn::GetLane(most)), row, p.beams.bound + beam * kWidth + at);
    }
}

/// The greatest bound of all beams.
inline float greatest_bound(const Packet& p) {
    float most = p.beams.bound[0];
    for (std::size_t b = 1; b < kBeams; ++b) {
        const float other = p.beams.bound[b * WideNode<float>::kWidth];
        most = other > most ? other : most;
    }
    return most;
}

/// The first eight numbers of kLanes rays in columns.
HWY_INLINE void transpose(const Ray<float>* rays, Packet& p, std::size_t at) {
    using D = Packet::D;
    using V = hn::Vec<D>;
    const D d;
    const hn::Repartition<double, D> pairs;
    constexpr std::size_t kNumbers = 9;
    static_assert(sizeof(Ray<float>) == kNumbers * sizeof(float) &&
                  offsetof(Ray<float>, t_max) == 7 * sizeof(float));
    // Ray i of each four, one behind the other.
    const auto rows = [&](std::size_t i, std::size_t from) HWY_ATTR {
        return load_blocks(d, reinterpret_cast<const float*>(rays + at + i) + from, 4 * kNumbers);
    };
    const auto columns = [&](std::size_t from, V* to) HWY_ATTR {
        const V r0 = rows(0, from), r1 = rows(1, from), r2 = rows(2, from), r3 = rows(3, from);
        const auto low = hn::BitCast(pairs, hn::InterleaveLower(d, r0, r1));
        const auto low2 = hn::BitCast(pairs, hn::InterleaveLower(d, r2, r3));
        const auto high = hn::BitCast(pairs, hn::InterleaveUpper(d, r0, r1));
        const auto high2 = hn::BitCast(pairs, hn::InterleaveUpper(d, r2, r3));
        to[0] = hn::BitCast(d, hn::InterleaveLower(pairs, low, low2));
        to[1] = hn::BitCast(d, hn::InterleaveUpper(pairs, low, low2));
        to[2] = hn::BitCast(d, hn::InterleaveLower(pairs, high, high2));
        to[3] = hn::BitCast(d, hn::InterleaveUpper(pairs, high, high2));
    };
    V v[8];
    columns(0, v);
    columns(4, v + 4);
    for (std::size_t a = 0; a < 3; ++a) {
        hn::Store(v[a], d, p.origin[a] + at);
        hn::Store(v[3 + a], d, p.direction[a] + at);
    }
    hn::Store(v[6], d, p.t_min + at);
    const auto most = hn::Set(d, std::numeric_limits<float>::max());
    const auto bound = hn::IfThenElse(hn::Lt(v[7], most), v[7], most);
    hn::Store(bound, d, p.bound + at);
    hn::Store(bound, d, p.least + at);
    const hn::RebindToUnsigned<D> du;
    hn::Store(hn::Set(du, Packet::kNoTriangle), du, p.ahead + at);
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
    constexpr float kMost = std::numeric_limits<float>::max();
    if (count == kPacketRays) {
        for (std::size_t at = 0; at < kPacketRays; at += Packet::kLanes) {
            transpose(rays, p, at);
        }
    } else {
        // Filled up with the last one, so that its beam is not widened.
        Ray<float> all[kPacketRays];
        for (std::size_t i = 0; i < kPacketRays; ++i) all[i] = rays[i < count ? i : count - 1];
        for (std::size_t at = 0; at < kPacketRays; at += Packet::kLanes) {
            transpose(all, p, at);
        }
        for (std::size_t i = count; i < kPacketRays; ++i) {
            p.bound[i] = std::numeric_limits<float>::lowest();
            p.least[i] = p.bound[i];
        }
    }
    const Packet::D d;
    const auto zero = hn::Zero(d);
    const auto most = hn::Set(d, kMost);
    for (std::size_t a = 0; a < 3; ++a) {
        p.negative[a] = rays[0].direction[a] < 0;
        auto fine = hn::Eq(zero, zero);
        for (std::size_t at = 0; at < kPacketRays; at += Packet::kLanes) {
            const auto direction = hn::Load(d, p.direction[a] + at);
            const auto inverse = hn::Div(hn::Set(d, 1.0F), direction);
            const auto ahead = p.negative[a] ? hn::Lt(direction, zero) : hn::Gt(direction, zero);
            fine = hn::And(fine, hn::And(ahead, hn::Le(hn::Abs(inverse), most)));
            hn::Store(inverse, d, p.inverse[a] + at);
            hn::Store(hn::Mul(inverse, hn::Set(d, kFarSlack<float>)), d, p.inverse_far[a] + at);
        }
        if (!hn::AllTrue(d, fine)) return false;
    }
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
        hn::Store(hn::IfThenZeroElse(hn::Eq(sx, zero), x), d, p.direction[p.kx] + at);
        hn::Store(hn::IfThenZeroElse(hn::Eq(sy, zero), y), d, p.direction[p.ky] + at);
    }
    std::uint32_t none = ir::ObjectId::kNone;
    for (std::size_t i = 0; i < count; ++i) {
        none &= excludes[i].object.value;
        best[i] = {p.bound[i], {}, 0, 0, 0};
    }
    p.some_excluded = none != ir::ObjectId::kNone;
    if (p.some_excluded) {
        for (std::size_t i = 0; i < kPacketRays; ++i) {
            const Exclude& exclude = excludes[i < count ? i : 0];
            p.excluded_object[i] = exclude.object.value;
            p.excluded_face[i] = exclude.face;
        }
    }
    p.bounds_pay = true;
    return true;
}

/// Fills in the beams of a gathered packet.
inline void gather_beams(Packet& p) {
    Beams& beams = p.beams;
    const BeamTag d;
    const auto slack = hn::Set(d, kFarSlack<float>);
    Extremes origin[3];
    for (std::size_t a = 0; a < 3; ++a) {
        origin[a] = extremes_of(p.origin[a]);
        // Least of (plane - o) * inverse: with a positive inverse the greatest origin gives the
        // least difference, with a negative one the least origin gives the greatest.
        const bool negative = p.negative[a];
        spread_to_node(negative ? origin[a].least : origin[a].greatest, beams.to_first[a]);
        spread_to_node(negative ? origin[a].greatest : origin[a].least, beams.to_last[a]);
        const Extremes inverse = extremes_of(p.inverse[a]);
        spread_to_node(inverse.least, beams.least_inverse[a]);
        spread_to_node(inverse.greatest, beams.greatest_inverse[a]);
        spread_to_node(hn::Mul(inverse.least, slack), beams.least_far[a]);
        spread_to_node(hn::Mul(inverse.greatest, slack), beams.greatest_far[a]);
    }
    spread_to_node(extremes_of(p.t_min).least, beams.t_min);
    spread_to_node(extremes_of(p.bound).greatest, beams.bound);
    spread_to_block(origin[p.kx], beams, 0);
    spread_to_block(origin[p.ky], beams, 1);
    spread_to_block(origin[p.kz], beams, 2);
    spread_to_block(extremes_of(p.sx), beams, 3);
    spread_to_block(extremes_of(p.sy), beams, 4);
}

/// A row of a node for the lanes from `at` on of a row of Beams.
template <class D>
HWY_INLINE hn::Vec<D> load_children(D d, const float* row, std::size_t at) {
    constexpr std::size_t kWidth = WideNode<float>::kWidth;
    if constexpr (hn::MaxLanes(D()) > kWidth) {
        const hn::Half<D> half;
        const auto once = hn::Load(half, row);
        return hn::Combine(d, once, once);
    } else {
        return hn::Load(d, row + at % kWidth);
    }
}

/// The least by child of a number for each child and beam.
template <class D>
HWY_INLINE void store_least(D d, hn::Vec<D> v, float* to) {
    if constexpr (hn::MaxLanes(D()) > WideNode<float>::kWidth) {
        const hn::Half<D> half;
        hn::Store(hn::Min(hn::LowerHalf(half, v), hn::UpperHalf(half, v)), half, to);
    } else {
        hn::Store(v, d, to);
    }
}

/// Children that any of the rays of a beam may meet, a bit for each child of the first beam, then
/// of the second and so on; and a t that none of the rays meets the child before. `beams`: those
/// that are asked for, as in kAllBeams. The slabs' arithmetic is monotone in the origin and in the
/// inverse, so that the intervals' answer covers each ray's own.
HWY_INLINE std::uint32_t beam_hits(const WideNode<float>& node, const Packet& p,
                                   std::uint32_t beams, float* begins) {
    using D = Packet::D;
    const D d;
    constexpr std::size_t kLanes = Packet::kLanes;
    constexpr std::size_t kWidth = WideNode<float>::kWidth;
    constexpr std::size_t kRows = kLanes < kWidth ? kWidth / kLanes : 1;
    const Beams& b = p.beams;
    const auto never = hn::Set(d, std::numeric_limits<float>::max());
    hn::Vec<D> earliest[kRows];
    for (std::size_t i = 0; i < kRows; ++i) earliest[i] = never;
    const std::uint32_t asked = beams * 255;
    std::uint32_t bits = 0;
    for (std::size_t at = 0; at < Beams::kOfNode; at += kLanes) {
        if ((asked >> at & ((1U << kLanes) - 1)) == 0) continue;
        const auto bounds = [&](std::size_t row)
                                HWY_ATTR { return load_children(d, node.bounds[row], at); };
        auto near = hn::Load(d, b.t_min + at);
        auto far = hn::Load(d, b.bound + at);
        for (std::size_t a = 0; a < 3; ++a) {
            const bool negative = p.negative[a];
            const auto first =
                hn::Sub(bounds(negative ? a + 3 : a), hn::Load(d, b.to_first[a] + at));
            const auto last = hn::Sub(bounds(negative ? a : a + 3), hn::Load(d, b.to_last[a] + at));
            near = hn::Max(near, hn::Min(hn::Mul(first, hn::Load(d, b.least_inverse[a] + at)),
                                         hn::Mul(first, hn::Load(d, b.greatest_inverse[a] + at))));
            far = hn::Min(far, hn::Max(hn::Mul(last, hn::Load(d, b.least_far[a] + at)),
                                       hn::Mul(last, hn::Load(d, b.greatest_far[a] + at))));
        }
        const auto met = hn::Le(near, far);
        auto& least = earliest[at / kLanes % kRows];
        least = hn::Min(least, hn::IfThenElse(met, near, never));
        bits |= bits_of(d, met) << at;
    }
    for (std::size_t i = 0; i < kRows; ++i) {
        store_least(d, earliest[i], begins + i * kLanes);
    }
    return bits & asked;
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
