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
    /// With four lanes a node takes two steps a beam: then all rays are one beam at nodes.
    static constexpr bool kOneAtNodes = kLanes < WideNode<float>::kWidth;
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

    /// Of ray i at times[i * time_step].
    const float* times;
    std::size_t time_step;
    /// All rays come from the same point, start at 0 and do not end, as far as is known.
    bool one_origin, starts_at_0, endless;
    bool some_excluded;
    alignas(64) std::uint32_t excluded_object[kPacketRays];
    alignas(64) std::uint32_t excluded_face[kPacketRays];
    /// The same object, or none for a ray that goes inside it.
    alignas(64) std::uint32_t excluded_closed[kPacketRays];
    /// Whether bounding triangles by beams has paid lately.
    bool bounds_pay;
    std::size_t count;
    Hit<float>* best;  ///< of each ray; where a triangle is ahead, what it leaves behind
    std::uint64_t box_tests, primitive_tests;
    /// At leaves of triangles: groups that came, and rays in them that meet the leaf.
    std::uint64_t leaf_groups, leaf_rays;
    /// At whatever is no node: groups that were asked, and rays in them that meet its box.
    std::uint64_t asked_groups, met_rays;

    /// Whether going together was worth it for rays that ask for any hit: where each meets leaves
    /// of its own, they are faster alone.
    [[nodiscard]] bool stayed_together() const { return leaf_rays * 10 >= leaf_groups * kLanes; }
    /// Whether it is to be given up: among things far smaller than what is between its rays nearly
    /// all of what the packet comes by is met by no ray.
    [[nodiscard]] bool is_astray() const {
        constexpr std::uint64_t kEnough = 256;
        return asked_groups >= kEnough && met_rays * 64 < asked_groups * kLanes;
    }
};

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
