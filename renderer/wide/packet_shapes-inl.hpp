// SPDX-License-Identifier: MIT
// Spheres and boxes of a tree against a group of a packet's rays, a lane each.
//
// Read again for each instruction set, so that its guard is Highway's and not a pragma.
#if defined(COBBLE_PACKET_SHAPES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef COBBLE_PACKET_SHAPES_INL
#undef COBBLE_PACKET_SHAPES_INL
#else
#define COBBLE_PACKET_SHAPES_INL
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <limits>

#include "renderer/scene/geometry.hpp"
#include "renderer/wide/box_slots-inl.hpp"
#include "renderer/wide/settle-inl.hpp"
#include "renderer/wide/spheres-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

/// Search::offer() for a ray of a packet.
template <bool kAny>
HWY_INLINE void offer(const WideTree<float>& tree, Packet& p, std::size_t ray, float t,
                      ir::ObjectId object, std::uint32_t face) {
    if (!(t > p.t_min[ray])) return;
    Hit<float>& best = p.best[ray];
    if constexpr (kAny) {
        if (!(t < p.bound[ray])) return;
        best.object = object;
        p.bound[ray] = std::numeric_limits<float>::lowest();
        p.least[ray] = p.bound[ray];
        return;
    }
    if (p.ahead[ray] != Packet::kNoTriangle) {
        if (t < p.least[ray]) {
            p.ahead[ray] = Packet::kNoTriangle;
        } else {
            settle(tree, p, ray);
        }
    }
    const bool before =
        t < best.t || (t == best.t && best.object.valid() &&
                       (object < best.object || (object == best.object && face < best.face)));
    if (!before) return;
    best = {t, object, face, 0, 0};
    p.bound[ray] = t;
    p.least[ray] = t;
}

/// What a group's rays span of a box, not clipped by where they start or end: slab_span().
struct GroupSpans {
    hn::Vec<Packet::D> near, far;
};
HWY_INLINE GroupSpans group_spans(const BoxBounds<float>& box, const Packet& p, std::size_t group) {
    const Packet::D d;
    const std::size_t at = group * Packet::kLanes;
    GroupSpans spans{hn::Set(d, std::numeric_limits<float>::lowest()),
                     hn::Set(d, std::numeric_limits<float>::max())};
    for (std::size_t a = 0; a < 3; ++a) {
        const bool negative = p.negative[a];
        const auto o = hn::Load(d, p.origin[a] + at);
        const auto first = hn::Sub(hn::Set(d, negative ? box.hi[a] : box.lo[a]), o);
        const auto last = hn::Sub(hn::Set(d, negative ? box.lo[a] : box.hi[a]), o);
        spans.near = hn::Max(spans.near, hn::Mul(first, hn::Load(d, p.inverse[a] + at)));
        spans.far = hn::Min(spans.far, hn::Mul(last, hn::Load(d, p.inverse_far[a] + at)));
    }
    return spans;
}

/// Which of a group's rays may meet a sphere, ahead and before what they have met: all others
/// surely do not.
///
/// With the names of guess_spheres(), v(t) = a t^2 + 2 b t + c is below 0 inside, and float has it
/// within 24 u (a t^2 + f^2 + r^2). The line misses where b^2 - a c is below 0. Where v(0) is above
/// 0 by more than that, and grows, the sphere is behind. Where v is at the best t and still falls
/// there, it is beyond, and by more than any rounding of its t.
class MayMeet {
  public:
    MayMeet(const Packet& p, std::size_t group) : p_(p), at_(group * Packet::kLanes) {
        const D d;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            origin_[axis] = hn::Load(d, p.origin[axis] + at_);
            direction_[axis] = hn::Load(d, p.direction[axis] + at_);
        }
        const auto& v = direction_;
        a_ = dot_lanes(d, v[0], v[1], v[2], v[0], v[1], v[2]);
        unbounded_ =
            ~bits_of(d, hn::And(hn::Ge(a_, hn::Set(d, 0x1p-40F)), hn::Le(a_, hn::Set(d, 0x1p40F))));
    }

    HWY_INLINE std::uint32_t operator()(const SphereBlock<float>& block, std::size_t lane) const {
        const D d;
        const auto relative = [&](std::size_t axis) HWY_ATTR {
            return hn::Sub(origin_[axis], hn::Set(d, block.center[axis][lane]));
        };
        const auto fx = relative(0);
        const auto fy = relative(1);
        const auto fz = relative(2);
        const auto b = dot_lanes(d, fx, fy, fz, direction_[0], direction_[1], direction_[2]);
        const auto square = hn::Set(d, block.radius[lane] * block.radius[lane]);
        const auto far = dot_lanes(d, fx, fy, fz, fx, fy, fz);
        const auto sum = hn::Add(far, square);
        const auto c = hn::Sub(far, square);
        const auto slack = hn::Set(d, 64 * kRounding<float>);
        // What underflows is below it, if the direction's length is not extreme.
        const auto tiny = hn::Set(d, 0x1p-80F);
        const auto least = hn::Mul(a_, hn::Sub(c, hn::Add(hn::Mul(slack, sum), tiny)));
        const auto toward = hn::Min(b, hn::Zero(d));
        const auto missed_or_behind = hn::Gt(least, hn::Mul(toward, toward));
        // Where this is too much for a float, it says nothing.
        const auto bound = hn::Load(d, p_.bound + at_);
        const auto to_bound = hn::Mul(a_, bound);
        const auto twice = hn::Add(b, b);
        const auto there = hn::Add(hn::Mul(hn::Add(to_bound, twice), bound), c);
        const auto sum_there = hn::Add(hn::Mul(hn::Add(to_bound, hn::Abs(twice)), bound), sum);
        const auto beyond = hn::And(hn::Lt(hn::Add(to_bound, b), hn::Zero(d)),
                                    hn::Gt(there, hn::Add(hn::Mul(slack, sum_there), tiny)));
        auto out = hn::And(hn::Or(missed_or_behind, beyond), hn::Le(sum, hn::Set(d, 0x1p80F)));
        std::uint32_t bits = bits_of(d, out) & ~unbounded_;
        if (p_.some_excluded) bits |= excluded(p_.excluded_closed, block.object[lane]);
        return ~bits;
    }
    /// The rays that have just left the sphere.
    HWY_INLINE std::uint32_t left(ir::ObjectId object) const {
        return p_.some_excluded ? excluded(p_.excluded_object, object) : 0;
    }

  private:
    using D = Packet::D;
    HWY_INLINE std::uint32_t excluded(const std::uint32_t* objects, ir::ObjectId object) const {
        const hn::RebindToUnsigned<D> d;
        return bits_of(d, hn::Eq(hn::Load(d, objects + at_), hn::Set(d, object.value)));
    }

    const Packet& p_;
    std::size_t at_;
    hn::Vec<D> origin_[3], direction_[3], a_;
    std::uint32_t unbounded_;
};

/// Each lane's quadratic as intersect_sphere() has it, bit for bit: a t^2 - 2 b t + c, and what is
/// left of the radius' square where the line comes nearest, below 0 where it misses.
template <class V>
struct SphereTerms {
    V a, b, rest, c;
};

/// f: from the centre to the origin; `r`: the radius.
template <class D, class V = hn::Vec<D>>
HWY_INLINE SphereTerms<V> sphere_terms(D d, V fx, V fy, V fz, V dx, V dy, V dz, V r) {
    SphereTerms<V> terms;
    terms.a = dot_lanes(d, dx, dy, dz, dx, dy, dz);
    terms.b = hn::Sub(hn::Zero(d), dot_lanes(d, fx, fy, fz, dx, dy, dz));
    const V q = hn::Div(terms.b, terms.a);
    const V lx = hn::Add(fx, hn::Mul(dx, q));
    const V ly = hn::Add(fy, hn::Mul(dy, q));
    const V lz = hn::Add(fz, hn::Mul(dz, q));
    const V square = hn::Mul(r, r);
    terms.rest = hn::Sub(square, dot_lanes(d, lx, ly, lz, lx, ly, lz));
    terms.c = hn::Sub(dot_lanes(d, fx, fy, fz, fx, fy, fz), square);
    return terms;
}

/// The rays of a group that meet a sphere, and where: intersect_sphere() and what test_sphere()
/// makes of it, bit for bit.
struct SphereHits {
    alignas(64) float near[Packet::kLanes];
    alignas(64) float far[Packet::kLanes];
};
HWY_INLINE std::uint32_t meet_sphere(const SphereBlock<float>& block, std::size_t lane,
                                     const Packet& p, std::size_t group, std::uint32_t rays,
                                     SphereHits& hits) {
    using D = hn::CappedTag<double, 8>;
    const D d;
    const hn::Rebind<float, D> df;
    constexpr std::size_t kLanes = hn::MaxLanes(D());
    const auto zero = hn::Zero(d);
    const auto r = hn::Set(d, double{block.radius[lane]});
    std::uint32_t bits = 0;
    for (std::size_t part = 0; part < Packet::kLanes; part += kLanes) {
        if ((rays >> part & ((1U << kLanes) - 1)) == 0) continue;
        const std::size_t at = group * Packet::kLanes + part;
        const auto along = [&](std::size_t axis) HWY_ATTR {
            return hn::PromoteTo(d, hn::Load(df, p.direction[axis] + at));
        };
        const auto relative = [&](std::size_t axis) HWY_ATTR {
            return hn::Sub(hn::PromoteTo(d, hn::Load(df, p.origin[axis] + at)),
                           hn::Set(d, double{block.center[axis][lane]}));
        };
        const auto terms =
            sphere_terms(d, relative(0), relative(1), relative(2), along(0), along(1), along(2), r);
        const auto [a, b, rest, c] = terms;
        const std::uint32_t met = bits_of(d, hn::Ge(rest, zero));
        if (met == 0) continue;
        bits |= met << part;
        // stable_roots()
        const auto root = hn::Sqrt(hn::Mul(a, rest));
        const auto sum = hn::IfThenElse(hn::Lt(b, zero), hn::Sub(b, root), hn::Add(b, root));
        const auto first = hn::Div(sum, a);
        const auto some = hn::Or(hn::Gt(sum, zero), hn::Lt(sum, zero));
        const auto second = hn::IfThenElseZero(some, hn::Div(c, sum));
        const auto in_order = hn::Lt(first, second);
        hn::Store(hn::DemoteTo(df, hn::IfThenElse(in_order, first, second)), df, hits.near + part);
        hn::Store(hn::DemoteTo(df, hn::IfThenElse(in_order, second, first)), df, hits.far + part);
    }
    bits &= rays;
    if (bits == 0) return 0;
    const Packet::D of_rays;
    const GroupSpans spans = group_spans(
        bounds_of(
            math::Vec3<float>{block.center[0][lane], block.center[1][lane], block.center[2][lane]},
            block.radius[lane]),
        p, group);
    const auto clamped = [&](const float* t) HWY_ATTR {
        const auto v = hn::Load(of_rays, t);
        return hn::IfThenElse(hn::Lt(v, spans.near), spans.near,
                              hn::IfThenElse(hn::Gt(v, spans.far), spans.far, v));
    };
    hn::Store(clamped(hits.near), of_rays, hits.near);
    hn::Store(clamped(hits.far), of_rays, hits.far);
    return bits & bits_of(of_rays, hn::Le(spans.near, spans.far));
}

/// Search::offer() of a sphere to a group: `t` for each of the `rays`.
template <bool kAny>
HWY_INLINE void offer_sphere(const WideTree<float>& tree, Packet& p, std::size_t group,
                             hn::Vec<Packet::D> t, std::uint32_t rays, ir::ObjectId object) {
    const Packet::D d;
    const hn::RebindToUnsigned<Packet::D> du;
    const std::size_t at = group * Packet::kLanes;
    const auto bound = hn::Load(d, p.bound + at);
    const auto ahead = hn::Gt(t, hn::Load(d, p.t_min + at));
    std::uint32_t closer = rays & bits_of(d, hn::And(ahead, hn::Lt(t, bound)));
    std::uint32_t others = rays & bits_of(d, hn::And(ahead, hn::Eq(t, bound)));
    if constexpr (!kAny) {
        const std::uint32_t waiting =
            bits_of(du, hn::Ne(hn::Load(du, p.ahead + at), hn::Set(du, Packet::kNoTriangle)));
        others |= closer & waiting;
        closer &= ~waiting;
    }
    alignas(64) float of_ray[Packet::kLanes];
    hn::Store(t, d, of_ray);
    if (closer != 0) {
        const auto mask = mask_of(d, closer);
        const auto now = kAny ? hn::Set(d, std::numeric_limits<float>::lowest()) : t;
        hn::BlendedStore(now, mask, d, p.bound + at);
        hn::BlendedStore(now, mask, d, p.least + at);
        for (; closer != 0; closer &= closer - 1) {
            const auto i = hwy::Num0BitsBelowLS1Bit_Nonzero32(closer);
            if constexpr (kAny) {
                p.best[at + i].object = object;
            } else {
                p.best[at + i] = {of_ray[i], object, 0, 0, 0};
            }
        }
    }
    for (; others != 0; others &= others - 1) {
        const auto i = hwy::Num0BitsBelowLS1Bit_Nonzero32(others);
        offer<kAny>(tree, p, at + i, of_ray[i], object, 0);
    }
}

/// A block of spheres against the `rays` of a group.
template <bool kAny>
HWY_INLINE void test_sphere_group(const Geometry<float>& g, ChildRef at, std::uint32_t rays,
                                  Packet& p, std::size_t group) {
    const SphereBlock<float>& block = g.wide.spheres[at.index()];
    const Packet::D d;
    const auto t_min = hn::Load(d, p.t_min + group * Packet::kLanes);
    const MayMeet may_meet(p, group);
    for (std::size_t lane = 0; lane < kSphereLanes && block.object[lane].valid(); ++lane) {
        p.primitive_tests += Packet::kLanes;
        const std::uint32_t open = rays & may_meet(block, lane);
        if (open == 0) continue;
        SphereHits hits;
        const std::uint32_t bits = meet_sphere(block, lane, p, group, open, hits);
        if (bits == 0) continue;
        const ir::ObjectId object = block.object[lane];
        const auto near = hn::Load(d, hits.near);
        const auto enters = hn::AndNot(mask_of(d, may_meet.left(object)), hn::Gt(near, t_min));
        const auto t = hn::IfThenElse(enters, near, hn::Load(d, hits.far));
        offer_sphere<kAny>(g.wide, p, group, t, bits, object);
    }
}

/// A box of the scene in a node's slot.
template <bool kAny>
HWY_NOINLINE void test_box_slot(const Geometry<float>& g, const WideNode<float>& node,
                                std::size_t slot, Packet& p, std::size_t ray) {
    settle(g.wide, p, ray);
    Search<float> search = begin_search<kAny>(p, ray);
    test_box(forms_of(p, ray), slot_bounds(node, slot), box_object(node.child[slot]), search);
    p.primitive_tests += 1;
    end_search<kAny>(search, p, ray);
}

/// The same for the `rays` of a group. Where they surely meet the box ahead of them, what they
/// span of it is what test_box() computes.
template <bool kAny>
HWY_INLINE void test_box_group(const Geometry<float>& g, const WideNode<float>& node,
                               std::size_t slot, std::uint32_t rays, Packet& p, std::size_t group) {
    const Packet::D d;
    const std::size_t at = group * Packet::kLanes;
    const BoxBounds<float> box = slot_bounds(node, slot);
    const ir::ObjectId object = box_object(node.child[slot]);
    const GroupSpans spans = group_spans(box, p, group);
    const auto sure = hn::And(hn::Gt(spans.near, hn::Load(d, p.t_min + at)),
                              hn::Le(spans.near, hn::Mul(spans.far, hn::Set(d, kNarrowed<float>))));
    // The first axis on which the span begins, as intersect_box() finds it.
    const auto begins = [&](std::size_t a) HWY_ATTR {
        const float first = p.negative[a] ? box.hi[a] : box.lo[a];
        return hn::Eq(hn::Mul(hn::Sub(hn::Set(d, first), hn::Load(d, p.origin[a] + at)),
                              hn::Load(d, p.inverse[a] + at)),
                      spans.near);
    };
    const std::uint32_t sure_bits = bits_of(d, sure);
    const std::uint32_t on_x = bits_of(d, begins(0));
    const std::uint32_t on_y = bits_of(d, begins(1));
    alignas(64) float near[Packet::kLanes];
    hn::Store(spans.near, d, near);
    while (rays != 0) {
        const auto i = hwy::Num0BitsBelowLS1Bit_Nonzero32(rays);
        rays &= rays - 1;
        const std::size_t ray = at + i;
        const Exclude exclude = exclude_of(p, ray);
        const bool left = object == exclude.object;
        if (left && !exclude.goes_inside) continue;
        if (HWY_UNLIKELY(left || (sure_bits >> i & 1) == 0)) {
            test_box_slot<kAny>(g, node, slot, p, ray);
            continue;
        }
        ++p.primitive_tests;
        const std::uint32_t axis = (on_x >> i & 1) != 0 ? 0 : (on_y >> i & 1) != 0 ? 1 : 2;
        offer<kAny>(g.wide, p, ray, near[i], object, 2 * axis + (p.negative[axis] ? 1 : 0));
    }
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
