// SPDX-License-Identifier: MIT
// From rays in an array or in columns to a packet, and how many of them may be in one.
//
// Read again for each instruction set, so that its guard is Highway's and not a pragma.
#if defined(COBBLE_GATHER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef COBBLE_GATHER_INL
#undef COBBLE_GATHER_INL
#else
#define COBBLE_GATHER_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "renderer/query/query.hpp"
#include "renderer/wide/packet-inl.hpp"
#include "renderer/wide/transpose-inl.hpp"
#include "renderer/wide/wide.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

// read_column() reads whole registers of a packet that is worth beginning.
static_assert(kFewestTogether >= Packet::kLanes);

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

/// Of kLanes rays: they end at `t_max`, and no triangle is ahead.
HWY_INLINE void begin_bounds(hn::Vec<Packet::D> t_max, Packet& p, std::size_t at) {
    const Packet::D d;
    const hn::RebindToUnsigned<Packet::D> du;
    const auto most = hn::Set(d, std::numeric_limits<float>::max());
    const auto bound = hn::IfThenElse(hn::Lt(t_max, most), t_max, most);
    hn::Store(bound, d, p.bound + at);
    hn::Store(bound, d, p.least + at);
    hn::Store(hn::Set(du, Packet::kNoTriangle), du, p.ahead + at);
}

/// The first eight numbers of kLanes rays in columns from `at` on.
HWY_INLINE void transpose(const Ray<float>* rays, Packet& p, std::size_t at) {
    using D = Packet::D;
    using V = hn::Vec<D>;
    const D d;
    constexpr std::size_t kNumbers = 9;
    static_assert(sizeof(Ray<float>) == kNumbers * sizeof(float) &&
                  offsetof(Ray<float>, t_max) == 7 * sizeof(float));
    // Ray i of each four, one behind the other.
    const auto rows = [&](std::size_t i, std::size_t from) HWY_ATTR {
        return load_blocks(d, reinterpret_cast<const float*>(rays + i) + from, 4 * kNumbers);
    };
    const auto columns = [&](std::size_t from, V* to) HWY_ATTR {
        transpose_fours(d, rows(0, from), rows(1, from), rows(2, from), rows(3, from), to);
    };
    V v[8];
    columns(0, v);
    columns(4, v + 4);
    for (std::size_t a = 0; a < 3; ++a) {
        hn::Store(v[a], d, p.origin[a] + at);
        hn::Store(v[3 + a], d, p.direction[a] + at);
    }
    hn::Store(v[6], d, p.t_min + at);
    begin_bounds(v[7], p, at);
}

/// What rays leave in columns; false if none leaves anything.
HWY_INLINE bool transpose_excludes(const Exclude* excludes, Packet& p) {
    const hn::RebindToUnsigned<Packet::D> d;
    constexpr std::size_t kNumbers = 3;
    static_assert(sizeof(Exclude) == kNumbers * sizeof(std::uint32_t) &&
                  offsetof(Exclude, face) == sizeof(std::uint32_t) &&
                  offsetof(Exclude, goes_inside) == 2 * sizeof(std::uint32_t));
    // What is behind a flag in its number may be anything.
    const auto flag = hn::Set(d, 1U);
    const auto none = hn::Set(d, ir::ObjectId::kNone);
    auto nothing = hn::Eq(none, none);
    for (std::size_t at = 0; at < kPacketRays; at += Packet::kLanes) {
        auto object = none;
        auto face = none;
        auto flags = none;
        hn::LoadInterleaved3(d, reinterpret_cast<const std::uint32_t*>(excludes + at), object, face,
                             flags);
        nothing = hn::And(nothing, hn::Eq(object, none));
        hn::Store(object, d, p.excluded_object + at);
        hn::Store(face, d, p.excluded_face + at);
        const auto outward = hn::Eq(hn::And(flags, flag), hn::Zero(d));
        hn::Store(hn::IfThenElse(outward, object, none), d, p.excluded_closed + at);
    }
    return !hn::AllTrue(d, nothing);
}

/// Rays from an array; those that a packet lacks are its last one again, so that its beam is not
/// widened.
HWY_INLINE void read_array(const Ray<float>* rays, const Exclude* excludes, std::size_t count,
                           Packet& p) {
    p.times = &rays[0].time;
    p.time_step = sizeof(Ray<float>) / sizeof(float);
    p.one_origin = p.starts_at_0 = p.endless = false;
    if (count == kPacketRays) {
        for (std::size_t at = 0; at < kPacketRays; at += Packet::kLanes)
            transpose(rays + at, p, at);
        p.some_excluded = transpose_excludes(excludes, p);
        return;
    }
    const std::size_t whole = count - count % Packet::kLanes;
    for (std::size_t at = 0; at < whole; at += Packet::kLanes) transpose(rays + at, p, at);
    Ray<float> last[Packet::kLanes];
    for (std::size_t i = 0; i < Packet::kLanes; ++i) {
        last[i] = rays[whole + i < count ? whole + i : count - 1];
    }
    for (std::size_t at = whole; at < kPacketRays; at += Packet::kLanes) {
        transpose(last, p, at);
        if (at == whole) std::fill_n(last, Packet::kLanes, rays[count - 1]);
    }
    Exclude all_excludes[kPacketRays];
    std::copy_n(excludes, count, all_excludes);
    std::fill(all_excludes + count, all_excludes + kPacketRays, excludes[count - 1]);
    p.some_excluded = transpose_excludes(all_excludes, p);
}

/// kLanes numbers of a column of `count`, at least as many as lanes; behind the last, that again.
template <class D>
HWY_INLINE hn::Vec<D> read_column(D d, const hn::TFromD<D>* from, std::size_t at,
                                  std::size_t count) {
    if (HWY_LIKELY(at + Packet::kLanes <= count)) return hn::LoadU(d, from + at);
    const std::size_t first = count - Packet::kLanes;
    alignas(64) std::int32_t lanes[Packet::kLanes];
    for (std::size_t i = 0; i < Packet::kLanes; ++i) {
        lanes[i] = static_cast<std::int32_t>((at + i < count ? at + i : count - 1) - first);
    }
    return hn::TableLookupLanes(hn::LoadU(d, from + first), hn::SetTableIndices(d, lanes));
}

/// The same from columns.
HWY_INLINE void read_columns(const RayColumns<float>& rays, std::size_t count, Packet& p) {
    using D = Packet::D;
    const D d;
    const hn::RebindToUnsigned<D> du;
    const hn::RebindToSigned<D> di;
    p.times = rays.time;
    p.time_step = 1;
    p.one_origin = rays.one_origin;
    p.starts_at_0 = true;
    p.endless = rays.t_max == nullptr && count == kPacketRays;
    p.some_excluded = rays.object != nullptr;
    const auto none = hn::Set(du, ir::ObjectId::kNone);
    for (std::size_t at = 0; at < kPacketRays; at += Packet::kLanes) {
        for (std::size_t a = 0; a < 3; ++a) {
            hn::Store(read_column(d, rays.origin[a], at, count), d, p.origin[a] + at);
            hn::Store(read_column(d, rays.direction[a], at, count), d, p.direction[a] + at);
        }
        hn::Store(hn::Zero(d), d, p.t_min + at);
        begin_bounds(rays.t_max == nullptr ? hn::Set(d, std::numeric_limits<float>::max())
                                           : read_column(d, rays.t_max, at, count),
                     p, at);
        if (p.some_excluded) {
            const auto object = read_column(du, rays.object, at, count);
            hn::Store(object, du, p.excluded_object + at);
            hn::Store(read_column(du, rays.face, at, count), du, p.excluded_face + at);
            const auto outward = hn::Ne(read_column(di, rays.outward, at, count), hn::Zero(di));
            hn::Store(hn::IfThenElse(hn::RebindMask(du, outward), object, none), du,
                      p.excluded_closed + at);
        } else {
            hn::Store(none, du, p.excluded_object + at);
            hn::Store(none, du, p.excluded_closed + at);
        }
    }
}

/// The answers of rays that do not end and meet nothing, as many as a register has lanes.
struct NothingAhead {
    alignas(64) Hit<float> hits[Packet::kLanes];
    constexpr NothingAhead() {
        for (Hit<float>& hit : hits) hit.t = std::numeric_limits<float>::max();
    }
};
inline constexpr NothingAhead kNothingAhead;

/// From registers that are read once: of a loop that reads and writes g++ makes std::memcpy(), and
/// of that a loop of the processor's, which begins slowly.
HWY_INLINE void set_nothing_ahead(Hit<float>* best) {
    const Packet::D d;
    const auto* const from = reinterpret_cast<const float*>(kNothingAhead.hits);
    auto* const to = reinterpret_cast<float*>(best);
    constexpr std::size_t kParts = sizeof(Hit<float>) / sizeof(float);
    static_assert(kPacketRays % Packet::kLanes == 0);
    hn::Vec<Packet::D> parts[kParts];
    for (std::size_t i = 0; i < kParts; ++i) parts[i] = hn::Load(d, from + i * Packet::kLanes);
    for (std::size_t at = 0; at < kPacketRays * kParts; at += kParts * Packet::kLanes) {
        for (std::size_t i = 0; i < kParts; ++i) {
            hn::StoreU(parts[i], d, to + at + i * Packet::kLanes);
        }
    }
}

/// Whether no ray of a whole packet ends.
HWY_INLINE bool all_endless(const Packet& p) {
    if (p.endless) return true;
    const Packet::D d;
    const auto most = hn::Set(d, std::numeric_limits<float>::max());
    auto endless = hn::Eq(most, most);
    for (std::size_t at = 0; at < kPacketRays; at += Packet::kLanes) {
        endless = hn::And(endless, hn::Eq(hn::Load(d, p.bound + at), most));
    }
    return hn::AllTrue(d, endless);
}

/// The axes of the first ray, by RayShear's rule.
HWY_INLINE void find_axes(Packet& p) {
    const auto along = [&](std::size_t axis) { return std::fabs(p.direction[axis][0]); };
    const float x = along(0), y = along(1), z = along(2);
    p.kz = x > y ? (x > z ? 0U : 2U) : (y > z ? 1U : 2U);
    p.kx = p.kz == 2 ? 0 : p.kz + 1;
    p.ky = p.kx == 2 ? 0 : p.kx + 1;
    if (p.direction[p.kz][0] < 0) std::swap(p.kx, p.ky);
}

/// How many rays from the first on go the same way, none along an axis: if not all, nothing is to
/// be done with the packet. The arithmetic of RaySlabs and RayShear.
template <bool kAny>
std::size_t gather(const WideQuery<float>& q, std::size_t first_ray, std::size_t count,
                   Hit<float>* best, Packet& p) {
    p.best = best;
    p.box_tests = 0;
    p.primitive_tests = 0;
    p.asked_groups = 0;
    p.met_rays = 0;
    p.leaf_groups = 0;
    p.leaf_rays = 0;
    p.count = count;
    if (q.rays != nullptr) {
        read_array(q.rays + first_ray, q.excludes + first_ray, count, p);
    } else {
        read_columns(q.columns->from(first_ray), count, p);
    }
    for (std::size_t i = count; i < kPacketRays; ++i) {
        p.bound[i] = std::numeric_limits<float>::lowest();
        p.least[i] = p.bound[i];
    }
    find_axes(p);
    constexpr float kMost = std::numeric_limits<float>::max();
    const Packet::D d;
    const auto zero = hn::Zero(d);
    const auto most = hn::Set(d, kMost);
    std::uint64_t others = 0;
    for (std::size_t a = 0; a < 3; ++a) {
        p.negative[a] = p.direction[a][0] < 0;
        for (std::size_t at = 0; at < kPacketRays; at += Packet::kLanes) {
            const auto direction = hn::Load(d, p.direction[a] + at);
            const auto inverse = hn::Div(hn::Set(d, 1.0F), direction);
            const auto inverse_far = hn::Mul(inverse, hn::Set(d, kFarSlack<float>));
            const auto ahead = p.negative[a] ? hn::Lt(direction, zero) : hn::Gt(direction, zero);
            const auto fine = hn::And(ahead, hn::Le(hn::Abs(inverse_far), most));
            others |= std::uint64_t{bits_of(d, hn::Not(fine))} << at;
            hn::Store(inverse, d, p.inverse[a] + at);
            hn::Store(inverse_far, d, p.inverse_far[a] + at);
        }
    }
    if (others != 0) return std::min(count, hwy::Num0BitsBelowLS1Bit_Nonzero64(others));
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
            if (a == p.kz) continue;
            const auto shorter = wins_ties ? hn::Gt(longest, other) : hn::Ge(longest, other);
            others |= std::uint64_t{bits_of(d, hn::Not(shorter))} << at;
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
    if (others != 0) return std::min(count, hwy::Num0BitsBelowLS1Bit_Nonzero64(others));
    if (count != kPacketRays || (!kAny && !all_endless(p))) {
        for (std::size_t i = 0; i < count; ++i) best[i] = {p.bound[i], {}, 0, 0, 0};
    } else {
        // Of rays that ask for any hit nothing but the object means anything.
        set_nothing_ahead(best);
    }
    p.bounds_pay = true;
    return count;
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
