// SPDX-License-Identifier: MIT
// A block of triangles against a packet's beams.
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

#include "renderer/wide/packet-inl.hpp"
#include "renderer/wide/triangles-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

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
