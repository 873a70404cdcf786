// SPDX-License-Identifier: MIT
// A packet's beams: intervals of sixteen rays each, against a node's children and against a block
// of triangles.
//
// Read again for each instruction set, so that its guard is Highway's and not a pragma.
#if defined(COBBLE_BEAMS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef COBBLE_BEAMS_INL
#undef COBBLE_BEAMS_INL
#else
#define COBBLE_BEAMS_INL
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <limits>

#include "renderer/wide/packet-inl.hpp"
#include "renderer/wide/triangles-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

/// A number for each beam, again and again in every block of four lanes.
struct Extremes {
    hn::Vec<Packet::D> least, greatest;
};

/// Reduces a vector's blocks of four lanes to one, which every block then is.
template <class D, class V, typename Pick>
HWY_INLINE V fold_blocks(D d, V v, Pick pick) {
    if constexpr (hn::MaxLanes(D()) > 8) v = pick(v, hn::ReverseBlocks(d, v));
    if constexpr (hn::MaxLanes(D()) > 4) v = pick(v, hn::SwapAdjacentBlocks(v));
    return v;
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

/// The same for what is asked at nodes.
HWY_INLINE Extremes at_nodes(const Extremes& of) {
    if constexpr (!Packet::kOneAtNodes) return of;
    const Packet::D d;
    return {hn::MinOfLanes(d, of.least), hn::MaxOfLanes(d, of.greatest)};
}

/// Whose number each lane of a row of Beams has.
template <std::size_t kTimes>
struct BeamOfLane {
    alignas(64) std::int32_t beam[kBeams * kTimes];
    constexpr BeamOfLane() : beam() {
        for (std::size_t i = 0; i < kBeams * kTimes; ++i) {
            beam[i] = static_cast<std::int32_t>(i / kTimes);
        }
    }
};
template <std::size_t kTimes>
inline constexpr BeamOfLane<kTimes> kBeamOfLane;

/// Writes a row of Beams: each beam's number kTimes side by side.
template <std::size_t kTimes>
HWY_INLINE void spread(hn::Vec<Packet::D> of_beams, float* row) {
    const Packet::D d;
    for (std::size_t at = 0; at < kBeams * kTimes; at += Packet::kLanes) {
        const auto beams = hn::SetTableIndices(d, kBeamOfLane<kTimes>.beam + at);
        hn::Store(hn::TableLookupLanes(of_beams, beams), d, row + at);
    }
}
HWY_INLINE void spread_to_node(hn::Vec<Packet::D> of_beams, float* row) {
    spread<WideNode<float>::kWidth>(of_beams, row);
}

/// The middle of an interval as it happens to be rounded, and how far it is to the ends at most.
HWY_INLINE void spread_to_block(const Extremes& of, Beams& beams, std::size_t row) {
    const Packet::D d;
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

/// Fills in the beams of a gathered packet.
inline void gather_beams(Packet& p) {
    Beams& beams = p.beams;
    const Packet::D d;
    const auto slack = hn::Set(d, kFarSlack<float>);
    Extremes origin[3];
    for (std::size_t a = 0; a < 3; ++a) {
        const auto point = hn::Set(d, p.origin[a][0]);
        origin[a] = p.one_origin ? Extremes{point, point} : extremes_of(p.origin[a]);
        // Least of (plane - o) * inverse: with a positive inverse the greatest origin gives the
        // least difference, with a negative one the least origin gives the greatest.
        const bool negative = p.negative[a];
        const Extremes from = at_nodes(origin[a]);
        spread_to_node(negative ? from.least : from.greatest, beams.to_first[a]);
        spread_to_node(negative ? from.greatest : from.least, beams.to_last[a]);
        const Extremes inverse = at_nodes(extremes_of(p.inverse[a]));
        spread_to_node(inverse.least, beams.least_inverse[a]);
        spread_to_node(inverse.greatest, beams.greatest_inverse[a]);
        spread_to_node(hn::Mul(inverse.least, slack), beams.least_far[a]);
        spread_to_node(hn::Mul(inverse.greatest, slack), beams.greatest_far[a]);
    }
    spread_to_node(p.starts_at_0 ? hn::Zero(d) : at_nodes(extremes_of(p.t_min)).least, beams.t_min);
    spread_to_node(
        p.endless ? hn::Set(d, std::numeric_limits<float>::max()) : extremes_of(p.bound).greatest,
        beams.bound);
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
    constexpr std::size_t kEnd = Packet::kOneAtNodes ? kWidth : Beams::kOfNode;
    for (std::size_t at = 0; at < kEnd; at += kLanes) {
        if (!Packet::kOneAtNodes && (asked >> at & ((1U << kLanes) - 1)) == 0) continue;
        const auto bounds = [&](std::size_t row)
                                HWY_ATTR { return load_children(d, node.bounds[row], at); };
        auto near = hn::Load(d, b.t_min + at);
        auto far = Packet::kOneAtNodes ? hn::Set(d, greatest_bound(p)) : hn::Load(d, b.bound + at);
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
    return (Packet::kOneAtNodes ? bits * kAllBeams : bits) & asked;
}

/// Which triangles of a block any ray of a beam may meet: a bit for each triangle of the first
/// beam, then of the second and so on. `far_off`, for each of these: no edge function of these rays
/// errs by more.
///
/// With m the middles and r the radii of a beam's intervals, a sheared corner (C - o) - s (C_z -
/// o_z) is off from its middle's by at most r_o + |m_s| r_oz + r_s (|C_z - m_oz| + r_oz); of the
/// difference of two corners only r_s |C_z - B_z| is left. An edge function of corners c and b is
/// (c - b) x b: written so, what moves both corners alike does not count.
///
/// Rounding: with E what edge_errors() says of the greatest sizes and depths, a middle's edge
/// function errs by less than 3 E. The sizes may themselves be off by what E has room for, which
/// at most doubles its factors: a ray's own edge function errs by less than 4 E. A triangle is left
/// out where two edge functions have opposite signs by more than 8 E.
HWY_INLINE std::uint32_t beams_at_block(const TriangleBlock<float>& block, const Packet& p,
                                        float* far_off) {
    using D = Packet::D;
    using V = hn::Vec<D>;
    const D d;
    const Beams& b = p.beams;
    const auto zero = hn::Zero(d);
    std::uint32_t bits = 0;
    for (std::size_t at = 0; at < Beams::kOfBlock; at += Packet::kLanes) {
        const auto middle = [&](std::size_t row)
                                HWY_ATTR { return hn::Load(d, b.middle[row] + at); };
        const auto radius = [&](std::size_t row)
                                HWY_ATTR { return hn::Load(d, b.radius[row] + at); };
        const V rz = radius(2);
        struct Row {
            V slope, wide, always;
        };
        const auto row = [&](std::size_t of_origin, std::size_t of_slope) HWY_ATTR {
            const V slope = middle(of_slope);
            return Row{slope, radius(of_slope),
                       hn::Add(radius(of_origin), hn::Mul(hn::Abs(slope), rz))};
        };
        const Row rows[2] = {row(0, 3), row(1, 4)};
        V z[3];
        V c[3][2], off[3][2], reach[3][2];
        V size = zero;
        V depth = zero;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto corner = [&](std::size_t axis)
                                    HWY_ATTR { return hn::LoadDup128(d, block.vertices[i][axis]); };
            z[i] = hn::Sub(corner(p.kz), middle(2));
            const V deep = hn::Add(hn::Abs(z[i]), rz);
            depth = hn::Add(depth, deep);
            for (std::size_t a = 0; a < 2; ++a) {
                c[i][a] = hn::Sub(hn::Sub(corner(a == 0 ? p.kx : p.ky), middle(a)),
                                  hn::Mul(rows[a].slope, z[i]));
                off[i][a] = hn::Add(rows[a].always, hn::Mul(rows[a].wide, deep));
                reach[i][a] = hn::Add(hn::Abs(c[i][a]), off[i][a]);
                size = hn::Add(size, reach[i][a]);
            }
        }
        const V error = edge_errors(d, size, depth);
        const V twice = hn::Add(error, error);
        const V fourfold = hn::Add(twice, twice);
        const V enough = hn::Add(fourfold, fourfold);
        hn::Store(fourfold, d, far_off + at);
        // The least and the greatest that an edge function may be, over the three of them.
        V lowest = zero;
        V highest = zero;
        for (std::size_t i = 0; i < 3; ++i) {
            // u of the corners 2 and 1, v of 0 and 2, w of 1 and 0.
            const std::size_t from = i == 0 ? 1 : i == 1 ? 2 : 0;
            const std::size_t to = i == 0 ? 2 : i == 1 ? 0 : 1;
            const V dz = hn::Abs(hn::Sub(z[to], z[from]));
            const V ex = hn::Sub(c[to][0], c[from][0]);
            const V ey = hn::Sub(c[to][1], c[from][1]);
            const V off_x = hn::Mul(rows[0].wide, dz);
            const V off_y = hn::Mul(rows[1].wide, dz);
            const V value = hn::Sub(hn::Mul(ex, c[from][1]), hn::Mul(ey, c[from][0]));
            const V off_by = hn::Add(
                hn::Add(hn::Mul(hn::Abs(ex), off[from][1]), hn::Mul(off_x, reach[from][1])),
                hn::Add(hn::Mul(hn::Abs(ey), off[from][0]), hn::Mul(off_y, reach[from][0])));
            const V greatest = hn::Add(value, off_by);
            const V least = hn::Sub(value, off_by);
            lowest = i == 0 ? greatest : hn::Min(lowest, greatest);
            highest = i == 0 ? least : hn::Max(highest, least);
        }
        // Written so that what overflowed is met.
        const auto outside =
            hn::And(hn::Lt(lowest, hn::Sub(zero, enough)), hn::Gt(highest, enough));
        bits |= bits_of(d, hn::Not(outside)) << at;
    }
    return bits;
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
