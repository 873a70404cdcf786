// SPDX-License-Identifier: MIT
// A packet through a wide tree.
//
// Rays go in beams of neighbours. A node is tried with intervals that hold a beam's rays, eight
// children and several beams in one step; so are triangles, four and all beams in one step. Only
// what is left at leaves is tested with groups of rays, a lane each.
//
// Read again for each instruction set, so that its guard is Highway's and not a pragma.
#if defined(COBBLE_PACKET_WALK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef COBBLE_PACKET_WALK_INL
#undef COBBLE_PACKET_WALK_INL
#else
#define COBBLE_PACKET_WALK_INL
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "renderer/scene/geometry.hpp"
#include "renderer/wide/beams-inl.hpp"
#include "renderer/wide/packet_shapes-inl.hpp"
#include "renderer/wide/settle-inl.hpp"
#include "renderer/wide/single-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

/// The rays of a group that have just left the triangle in a lane of a block.
HWY_INLINE hn::Mask<Packet::D> left_behind(const TriangleBlock<float>& block, std::size_t lane,
                                           const Packet& p, std::size_t at) {
    const hn::RebindToUnsigned<Packet::D> d;
    const auto object =
        hn::Eq(hn::Load(d, p.excluded_object + at), hn::Set(d, block.object[lane].value));
    const auto face = hn::Eq(hn::Load(d, p.excluded_face + at), hn::Set(d, block.face[lane]));
    return hn::RebindMask(Packet::D(), hn::And(object, face));
}

/// One ray and one triangle of which groups of rays leave something open: it may be missed, or its
/// place is not clear.
template <bool kAny>
HWY_NOINLINE void meet(const WideTree<float>& tree, Packet& p, std::size_t ray,
                       std::uint32_t triangle) {
    const auto one = lane_of(tree.triangles[triangle / kBlockLanes], triangle % kBlockLanes);
    if (!kAny) settle(tree, p, ray);
    Search<float> search = begin_search<kAny>(p, ray);
    test_triangle(forms_of(p, ray), one.vertices, one.object, one.face, search);
    end_search<kAny>(search, p, ray);
}

/// One triangle against a group of rays; true if a bound has changed. `far_off`: no edge function
/// errs by more; only if kKnown.
template <bool kAny, bool kKnown>
HWY_INLINE bool test_triangle_group(const WideTree<float>& tree, std::uint32_t index, float far_off,
                                    Packet& p, std::size_t group) {
    using D = Packet::D;
    const D d;
    const TriangleBlock<float>& block = tree.triangles[index / kBlockLanes];
    const std::size_t lane = index % kBlockLanes;
    const std::size_t at = group * Packet::kLanes;
    const auto corner = [&](std::size_t i, std::size_t axis)
                            HWY_ATTR { return hn::Set(d, block.vertices[i][axis][lane]); };
    const ShearLanes<hn::Vec<D>> shear{
        hn::Load(d, p.origin[p.kx] + at), hn::Load(d, p.origin[p.ky] + at),
        hn::Load(d, p.origin[p.kz] + at), hn::Load(d, p.sx + at), hn::Load(d, p.sy + at)};
    const auto edges = edges_of(d, shear, p.kx, p.ky, p.kz, corner);
    const auto least = hn::Min(hn::Min(edges.u, edges.v), edges.w);
    const auto most = hn::Max(hn::Max(edges.u, edges.v), edges.w);
    const auto error = kKnown ? hn::Set(d, far_off) : edges.error;
    auto outside = hn::And(hn::Lt(least, hn::Neg(error)), hn::Gt(most, error));
    if (hn::AllTrue(d, outside)) return false;
    if (p.some_excluded) {
        outside = hn::Or(outside, left_behind(block, lane, p, at));
        if (hn::AllTrue(d, outside)) return false;
    }

    auto near = hn::Set(d, std::numeric_limits<float>::lowest());
    auto far = hn::Set(d, std::numeric_limits<float>::max());
    for (std::size_t a = 0; a < 3; ++a) {
        const float* const c0 = &block.vertices[0][a][lane];
        const float* const c1 = &block.vertices[1][a][lane];
        const float* const c2 = &block.vertices[2][a][lane];
        float lo = *c0 < *c1 ? *c0 : *c1;
        lo = *c2 < lo ? *c2 : lo;
        float hi = *c0 > *c1 ? *c0 : *c1;
        hi = *c2 > hi ? *c2 : hi;
        const auto o = hn::Load(d, p.origin[a] + at);
        const bool negative = p.negative[a];
        near = hn::Max(near, hn::Mul(hn::Sub(hn::Set(d, negative ? hi : lo), o),
                                     hn::Load(d, p.inverse[a] + at)));
        far = hn::Min(far, hn::Mul(hn::Sub(hn::Set(d, negative ? lo : hi), o),
                                   hn::Load(d, p.inverse_far[a] + at)));
    }
    const auto min = hn::Load(d, p.t_min + at);
    auto left = hn::And(hn::And(hn::Not(outside), hn::Le(near, far)),
                        hn::And(hn::Gt(far, min), hn::Le(near, hn::Load(d, p.bound + at))));
    if (hn::AllFalse(d, left)) return false;
    const auto sure = surely_inside(d, edges.u, edges.v, edges.w);
    if (kKnown && !hn::AllFalse(d, hn::AndNot(sure, left))) {
        left = hn::AndNot(surely_outside(d, edges.u, edges.v, edges.w, edges.error), left);
    }
    std::uint32_t bits = bits_of(d, left);
    // Those that it surely comes before all else for; of any hit: that it surely ends.
    const auto first = hn::And(hn::And(left, sure),
                               hn::And(hn::Gt(near, min), hn::Lt(far, hn::Load(d, p.least + at))));
    std::uint32_t done = bits_of(d, first) & bits;
    bits &= ~done;
    if (done != 0) {
        const auto mask = mask_of(d, done);
        if constexpr (kAny) {
            const auto through = hn::Set(d, std::numeric_limits<float>::lowest());
            hn::BlendedStore(through, mask, d, p.bound + at);
            hn::BlendedStore(through, mask, d, p.least + at);
            for (; done != 0; done &= done - 1) {
                p.best[at + hwy::Num0BitsBelowLS1Bit_Nonzero32(done)].object = block.object[lane];
            }
        } else {
            const hn::RebindToUnsigned<D> du;
            hn::BlendedStore(hn::Set(du, index), hn::RebindMask(du, mask), du, p.ahead + at);
            hn::BlendedStore(near, mask, d, p.least + at);
            hn::BlendedStore(far, mask, d, p.bound + at);
        }
    }
    if (HWY_UNLIKELY(bits != 0)) {
        if constexpr (!kAny) {
            // Where a surface turns away from the rays, they meet two neighbours at once.
            const auto ahead = hn::And(sure, hn::Gt(near, min));
            const std::uint32_t both = bits & bits_of(d, ahead) & waiting_rays(p, group);
            if (both != 0) {
                alignas(64) float begins[Packet::kLanes];
                alignas(64) float ends[Packet::kLanes];
                hn::Store(near, d, begins);
                hn::Store(far, d, ends);
                bits &= ~both;
                bits |= put_in_order(tree, p, group, both, index, begins, ends);
            }
        }
        for (; bits != 0; bits &= bits - 1) {
            meet<kAny>(tree, p, at + hwy::Num0BitsBelowLS1Bit_Nonzero32(bits), index);
        }
    }
    return true;
}

/// Everything else, one ray at a time.
template <bool kAny>
HWY_NOINLINE void test_others(const Geometry<float>& g, ChildRef at, Packet& p, std::size_t ray) {
    settle(g.wide, p, ray);
    Search<float> search = begin_search<kAny>(p, ray);
    test_leaf<kAny>(g, at, forms_of(p, ray), search);
    p.primitive_tests += search.primitive_tests;
    end_search<kAny>(search, p, ray);
}

template <bool kAny>
void test_planes(const Geometry<float>& g, Packet& p) {
    for (const MovingPrimitive& plane : g.planes) {
        for (std::size_t ray = 0; ray < p.count; ++ray) {
            Search<float> search = begin_search<kAny>(p, ray);
            test_plane(g, forms_of(p, ray), plane, search);
            end_search<kAny>(search, p, ray);
        }
        p.primitive_tests += p.count;
    }
}

/// So few are faster tested with triangles one by one than bounded.
inline constexpr std::size_t kFewGroups = 2;

/// The groups of rays that meet a leaf of triangles against what is in it; a bit for each group
/// whose bounds have changed.
template <bool kAny>
HWY_INLINE std::uint32_t test_triangle_leaf(const WideTree<float>& tree, ChildRef at,
                                            std::uint32_t groups, Packet& p) {
    const std::uint32_t first = at.index() * std::uint32_t{kBlockLanes};
    const std::uint32_t count = at.count();
    std::uint32_t changed = 0;
    p.primitive_tests += hwy::PopCount(groups) * Packet::kLanes * count;
    if (!p.bounds_pay && hwy::PopCount(groups) <= kFewGroups) {
        for (; groups != 0; groups &= groups - 1) {
            const auto group = hwy::Num0BitsBelowLS1Bit_Nonzero32(groups);
            for (std::uint32_t i = 0; i < count; ++i) {
                const bool c = test_triangle_group<kAny, false>(tree, first + i, 0, p, group);
                changed |= std::uint32_t{c} << group;
            }
        }
        return changed;
    }
    alignas(64) float far_off[Beams::kOfBlock];
    const std::uint32_t met = beams_at_block(tree.triangles[at.index()], p, far_off);
    std::uint32_t tested = 0;
    const auto asked = static_cast<std::uint32_t>(hwy::PopCount(groups)) * count;
    for (; groups != 0; groups &= groups - 1) {
        const auto group = hwy::Num0BitsBelowLS1Bit_Nonzero32(groups);
        const std::size_t beam = group / Packet::kBeamGroups;
        std::uint32_t triangles = met >> (beam * kBlockLanes) & ((1U << count) - 1);
        tested += static_cast<std::uint32_t>(hwy::PopCount(triangles));
        for (; triangles != 0; triangles &= triangles - 1) {
            const auto i =
                static_cast<std::uint32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(triangles));
            const bool c = test_triangle_group<kAny, true>(
                tree, first + i, far_off[beam * kBlockLanes + i], p, group);
            changed |= std::uint32_t{c} << group;
        }
    }
    p.bounds_pay = tested * 2 <= asked;
    return changed;
}

/// The groups of the asked-for beams that meet a slot's box, and what is in it; true if bounds have
/// changed.
template <bool kAny>
HWY_INLINE bool test_slot(const Geometry<float>& g, const WideNode<float>& parent, std::size_t slot,
                          std::uint32_t beams, Packet& p) {
    const ChildRef child = parent.child[slot];
    std::uint32_t groups = 0;
    for (std::size_t group = 0; group < Packet::kGroups; ++group) {
        if ((beams >> (8 * (group / Packet::kBeamGroups)) & 1) == 0) continue;
        std::uint32_t bits = group_hits(parent, slot, p, group);
        ++p.asked_groups;
        p.met_rays += hwy::PopCount(bits);
        if (bits == 0) continue;
        groups |= 1U << group;
        switch (child.kind()) {
            case PrimitiveKind::kTriangle:
                ++p.leaf_groups;
                p.leaf_rays += hwy::PopCount(bits);
                break;
            case PrimitiveKind::kSphere:
                test_sphere_group<kAny>(g, child, bits, p, group);
                break;
            case PrimitiveKind::kBox:
                test_box_group<kAny>(g, parent, slot, bits, p, group);
                break;
            default:
                for (; bits != 0; bits &= bits - 1) {
                    const auto i = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
                    test_others<kAny>(g, child, p, group * Packet::kLanes + i);
                }
        }
    }
    if (groups == 0) return false;
    if (child.kind() == PrimitiveKind::kTriangle) {
        groups = test_triangle_leaf<kAny>(g.wide, child, groups, p);
    }
    constexpr std::uint32_t kOfBeam = (1U << Packet::kBeamGroups) - 1;
    for (std::size_t beam = 0; beam < kBeams; ++beam) {
        if ((groups >> (beam * Packet::kBeamGroups) & kOfBeam) != 0) update_bound(p, beam);
    }
    return groups != 0;
}

/// Which of the asked-for beams meet a slot's box: those before the first of which a ray surely
/// does are left out.
HWY_INLINE std::uint32_t first_beams(const WideNode<float>& node, std::size_t slot,
                                     std::uint32_t beams, const Packet& p) {
    for (; beams != 0; beams &= beams - 1) {
        const std::size_t beam = hwy::Num0BitsBelowLS1Bit_Nonzero32(beams) / 8;
        for (std::size_t i = 0; i < Packet::kBeamGroups; ++i) {
            if (group_hits(node, slot, p, beam * Packet::kBeamGroups + i) != 0) return beams;
        }
    }
    return 0;
}

/// Asks for what a child leads to, before it is needed.
HWY_INLINE void prefetch_child(const WideTree<float>& tree, ChildRef child) {
    if (child.is_inner()) {
        // Two rows a line of the cache.
        const auto& bounds = child.node_in(tree.nodes.data()).bounds;
        for (std::size_t row = 0; row < 6; row += 2) hwy::Prefetch(bounds[row]);
        hwy::Prefetch(bounds[5]);
    } else if (child.kind() == PrimitiveKind::kTriangle) {
        const auto* const block = &tree.triangles[child.index()];
        hwy::Prefetch(block->vertices[0][0]);
        hwy::Prefetch(block->vertices[1][1]);
        hwy::Prefetch(block->vertices[2][2]);
    }
}

/// A child that waits, in two numbers: what is put together from smaller ones in memory and read
/// back as one would have to wait until all of it is written.
class WaitingPart {
  public:
    WaitingPart() = default;  // no values of their own: a stack of hundreds is made for each packet
    /// `beams`: those that may meet it, as in kAllBeams.
    WaitingPart(float near, std::uint32_t node, std::uint32_t slot, std::uint32_t beams)
        : front_(std::bit_cast<std::uint32_t>(near) | std::uint64_t{node} << 32),
          back_(slot << kSlotShift | beams) {}

    /// Before this no ray meets it.
    [[nodiscard]] float near() const {
        return std::bit_cast<float>(static_cast<std::uint32_t>(front_));
    }
    /// Whose slot it is, in units of a node's alignment.
    [[nodiscard]] std::size_t node() const { return front_ >> 32; }
    [[nodiscard]] std::uint32_t slot() const {
        return static_cast<std::uint32_t>(back_) >> kSlotShift & 7;
    }
    [[nodiscard]] std::uint32_t beams() const {
        return static_cast<std::uint32_t>(back_) & kAllBeams;
    }

  private:
    static constexpr std::uint32_t kSlotShift = 1;
    static_assert((7U << kSlotShift & kAllBeams) == 0 && WideNode<float>::kWidth == 8);

    std::uint64_t front_;
    std::uint64_t back_;  // as wide as what it is copied with: see above
};

/// False if the packet was given up: its rays' hits mean nothing.
template <bool kAny>
HWY_NOINLINE bool walk_packet(const Geometry<float>& g, Packet& p) {
    const WideTree<float>& tree = g.wide;
    if (tree.nodes.empty()) return true;
    constexpr std::size_t kWidth = WideNode<float>::kWidth;
    constexpr std::size_t kUnit = alignof(WideNode<float>);
    gather_beams(p);
    WaitingPart stack[kMaxTreeDepth * (kWidth - 1) + kWidth];
    std::size_t waiting = 0;
    const WideNode<float>* const nodes = tree.nodes.data();
    const auto* const first_byte = reinterpret_cast<const char*>(nodes);
    const WideNode<float>* node = nodes;
    std::uint32_t beams = kAllBeams;
    float bound = greatest_bound(p);
    std::uint64_t steps = 0;
    while (node != nullptr) {
        ++steps;
        alignas(64) float begins[kWidth];
        const std::uint32_t hits = beam_hits(*node, p, beams, begins);
        const auto place_of_node = static_cast<std::uint32_t>(
            static_cast<std::size_t>(reinterpret_cast<const char*>(node) - first_byte) / kUnit);
        const std::size_t base = waiting;
        std::uint32_t bits = (hits | hits >> 16) & 0xffff;
        bits = (bits | bits >> 8) & 0xff;
        for (; bits != 0; bits &= bits - 1) {
            const auto slot = static_cast<std::uint32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(bits));
            std::uint32_t of_child = hits >> slot & kAllBeams;
            // Shadow rays begin all over the place; where they meet leaves together nonetheless,
            // this costs more than it saves.
            if (Packet::kOneAtNodes ||
                (kAny && p.leaf_rays * 2 <= p.leaf_groups * Packet::kLanes)) {
                of_child = first_beams(*node, slot, of_child, p);
                if (of_child == 0) continue;
            }
            prefetch_child(tree, node->child[slot]);
            const WaitingPart next(begins[slot], place_of_node, slot, of_child);
            // The nearest first; any hit may be anywhere, and mostly is not where rays begin.
            std::size_t place = waiting++;
            while (!kAny && place > base && stack[place - 1].near() < begins[slot]) {
                stack[place] = stack[place - 1];
                --place;
            }
            stack[place] = next;
        }
        node = nullptr;
        while (waiting != 0 && node == nullptr) {
            const WaitingPart at = stack[--waiting];
            if (at.near() > bound) continue;
            const auto& parent =
                *reinterpret_cast<const WideNode<float>*>(first_byte + at.node() * kUnit);
            const ChildRef child = parent.child[at.slot()];
            if (child.is_inner()) {
                node = &child.node_in(nodes);
                beams = at.beams();
            } else if (test_slot<kAny>(g, parent, at.slot(), at.beams(), p)) {
                bound = greatest_bound(p);
                if (kAny && bound == std::numeric_limits<float>::lowest()) break;
            } else if (HWY_UNLIKELY(p.is_astray())) {
                p.box_tests += steps * kWidth;
                return false;
            }
        }
    }
    if constexpr (!kAny) settle_all(tree, p);
    p.box_tests += steps * kWidth;
    return true;
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
