// SPDX-License-Identifier: MIT
// A packet through a wide tree.
//
// A node is first tried with intervals that hold all rays: eight children in one step. The slabs'
// arithmetic is monotone in the origin and in the inverse, so that the intervals' answer covers
// each ray's own. Only then groups of rays, a lane each, are tested against the children that are
// left.
//
// Read again for each instruction set, so that its guard is Highway's and not a pragma.
#if defined(COBBLE_PACKET_WALK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef COBBLE_PACKET_WALK_INL
#undef COBBLE_PACKET_WALK_INL
#else
#define COBBLE_PACKET_WALK_INL
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <limits>

#include "renderer/scene/geometry.hpp"
#include "renderer/wide/packet_shapes-inl.hpp"
#include "renderer/wide/settle-inl.hpp"
#include "renderer/wide/single-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

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
    const ShearLanes<hn::Vec<D>> shear{
        hn::Load(d, p.origin[p.kx] + at), hn::Load(d, p.origin[p.ky] + at),
        hn::Load(d, p.origin[p.kz] + at), hn::Load(d, p.sx + at), hn::Load(d, p.sy + at)};
    const auto edges = edges_of(d, shear, p.kx, p.ky, p.kz, corner);
    const auto open = hn::Not(surely_outside(d, edges.u, edges.v, edges.w, edges.error));
    if (hn::AllFalse(d, open)) return;

    auto near = hn::Set(d, std::numeric_limits<float>::lowest());
    auto far = hn::Set(d, std::numeric_limits<float>::max());
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
    const std::uint32_t sure_bits = bits_of(d, surely_inside(d, edges.u, edges.v, edges.w));
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
    const WideNode<float>* parent;  ///< the node whose slot it is
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
    stack[waiting++] = {p.least_t_min, ChildRef::inner(0), nullptr, 0, 0};
    float bound = greatest_bound(p);
    std::uint64_t steps = 0;
    while (waiting != 0) {
        const WaitingPart at = stack[--waiting];
        if (at.near > bound) continue;
        if (at.child.is_inner()) {
            const WideNode<float>& node = at.child.node_in(tree.nodes.data());
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
                const WaitingPart next{begins[slot], node.child[slot], &node,
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
        const WideNode<float>& parent = *at.parent;
        for (std::size_t group = at.group; group < Packet::kGroups; ++group) {
            std::uint32_t bits = group_hits(parent, at.slot, p, group);
            if (bits == 0) continue;
            if (at.child.kind() == PrimitiveKind::kTriangle) {
                ++p.leaf_groups;
                p.leaf_rays += hwy::PopCount(bits);
                p.primitive_tests += Packet::kLanes * at.child.count();
                const std::uint32_t first = at.child.index() * std::uint32_t{kBlockLanes};
                for (std::uint32_t i = 0; i < at.child.count(); ++i) {
                    test_triangle_group<kAny>(tree, first + i, p, group);
                }
                continue;
            }
            if (at.child.kind() == PrimitiveKind::kSphere) {
                test_sphere_group<kAny>(g, at.child, bits, p, group);
                continue;
            }
            if (at.child.kind() == PrimitiveKind::kBox) {
                test_box_group<kAny>(g, parent, at.slot, bits, p, group);
                continue;
            }
            while (bits != 0) {
                const auto i = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
                bits &= bits - 1;
                test_others<kAny>(g, at.child, p, group * Packet::kLanes + i);
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
