// SPDX-License-Identifier: MIT
// A block of spheres at once.
//
// Read again for each instruction set, so that its guard is Highway's and not a pragma.
#if defined(COBBLE_SPHERES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef COBBLE_SPHERES_INL
#undef COBBLE_SPHERES_INL
#else
#define COBBLE_SPHERES_INL
#endif

#include <hwy/highway.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "renderer/accel/wide_tree.hpp"
#include "renderer/query/query.hpp"
#include "renderer/wide/lanes-inl.hpp"
#include "renderer/wide/ray_rows-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

/// Each lane's quadratic as intersect_sphere() has it, bit for bit: a t^2 - 2 b t + c, and what is
/// left of the radius' square where the line comes nearest, below 0 where it misses.
template <class V>
struct SphereTerms {
    V a, b, rest, c;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE V dot_lanes(D, V x0, V y0, V z0, V x1, V y1, V z1) {
    return hn::Add(hn::Add(hn::Mul(x0, x1), hn::Mul(y0, y1)), hn::Mul(z0, z1));
}

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

/// The lanes that the line of the ray meets: the discriminant of intersect_sphere(), bit for bit.
HWY_INLINE std::uint32_t met_spheres(const SphereBlock<float>& block, const RayForms<float>& ray) {
    using D = hn::CappedTag<double, kBlockLanes>;
    const D d;
    const hn::Rebind<float, D> df;
    constexpr std::size_t kLanes = hn::MaxLanes(D());
    const math::Vec3d along = widen(ray.shear.direction);
    const auto dx = hn::Set(d, along.x);
    const auto dy = hn::Set(d, along.y);
    const auto dz = hn::Set(d, along.z);
    std::uint32_t bits = 0;
    for (std::size_t part = 0; part < kBlockLanes; part += kLanes) {
        const auto relative = [&](std::size_t axis) HWY_ATTR {
            return hn::Sub(hn::Set(d, double{ray.shear.origin[axis]}),
                           hn::PromoteTo(d, hn::Load(df, block.center[axis] + part)));
        };
        const auto r = hn::PromoteTo(d, hn::Load(df, block.radius + part));
        const auto rest =
            sphere_terms(d, relative(0), relative(1), relative(2), dx, dy, dz, r).rest;
        bits |= bits_of(d, hn::Ge(rest, hn::Zero(d))) << part;
    }
    return bits;
}

/// The lanes that may hold a better hit: all others are surely missed, lie behind or too far, or
/// are what the ray leaves for the outside. In float, with room for what float rounds away.
///
/// With f from the centre to the origin, u half the distance from 1 to the next number, and l from
/// the centre to where the line comes nearest: f is off by 1 u of itself, the nearest t by 7 u of
/// |f| over the direction's length, so that l is off by less than 24 u |f| and its square by less
/// than 51 u f^2.
HWY_INLINE std::uint32_t open_spheres(const SphereBlock<float>& block, const RayLanes<float>& ray,
                                      const Search<float>& search) {
    using D = hn::CappedTag<float, kBlockLanes>;
    const D d;
    constexpr std::size_t kLanes = hn::MaxLanes(D());
    constexpr float kSlack = 64 * kRounding<float>;
    const float* const v = ray.direction;
    const float square = (v[0] * v[0] + v[1] * v[1]) + v[2] * v[2];
    // Beyond these the bounds above do not hold.
    if (!(square >= 0x1p-100F && square <= 0x1p100F)) return (1U << kBlockLanes) - 1;
    const auto inverse = hn::Set(d, 1 / square);
    const auto inverse_length = hn::Set(d, 1 / std::sqrt(square));
    const auto dx = hn::Set(d, v[0]);
    const auto dy = hn::Set(d, v[1]);
    const auto dz = hn::Set(d, v[2]);
    const auto slack = hn::Set(d, kSlack);
    std::uint32_t bits = 0;
    for (std::size_t part = 0; part < kBlockLanes; part += kLanes) {
        const auto relative = [&](std::size_t axis) HWY_ATTR {
            return hn::Sub(hn::Set(d, ray.origin[axis]), hn::Load(d, block.center[axis] + part));
        };
        const auto fx = relative(0);
        const auto fy = relative(1);
        const auto fz = relative(2);
        const auto r = hn::Load(d, block.radius + part);
        const auto q = hn::Mul(hn::Neg(dot_lanes(d, fx, fy, fz, dx, dy, dz)), inverse);
        const auto lx = hn::Add(fx, hn::Mul(dx, q));
        const auto ly = hn::Add(fy, hn::Mul(dy, q));
        const auto lz = hn::Add(fz, hn::Mul(dz, q));
        const auto surplus = hn::Sub(dot_lanes(d, lx, ly, lz, lx, ly, lz),
                                     hn::Mul(slack, dot_lanes(d, fx, fy, fz, fx, fy, fz)));
        const auto reach = hn::Add(hn::Mul(hn::Add(hn::Set(d, 1.0F), slack), hn::Mul(r, r)),
                                   hn::Set(d, std::numeric_limits<float>::min()));
        auto missed = hn::And(hn::Gt(surplus, reach),
                              hn::Le(surplus, hn::Set(d, std::numeric_limits<float>::max())));
        // Where the line is inside, if it is at all, and a little around that.
        const auto half = hn::Mul(r, inverse_length);
        const auto wide = hn::Add(half, hn::Mul(slack, hn::Add(hn::Abs(q), hn::Add(half, half))));
        missed = hn::Or(missed, hn::Gt(hn::Sub(q, wide), hn::Set(d, search.best.t)));
        missed = hn::Or(missed, hn::Lt(hn::Add(q, wide), hn::Set(d, search.t_min)));
        bits |= bits_of(d, hn::Not(missed)) << part;
    }
    if (search.exclude.goes_inside) return bits;
    for (std::uint32_t i = 0; i < kBlockLanes; ++i) {
        if (block.object[i] == search.exclude.object) bits &= ~(1U << i);
    }
    return bits;
}

/// True if any hit is asked for and found.
template <bool kAny, typename T>
HWY_INLINE bool test_spheres(const SphereBlock<T>& block, std::uint32_t count,
                             const RayLanes<T>& ray, FormsOnDemand<T>& forms, Search<T>& search) {
    std::uint32_t bits = (1U << count) - 1;
    if constexpr (sizeof(T) == sizeof(float)) {
        bits &= open_spheres(block, ray, search);
        // With several left most are missed by little, and four roots cost no more than one.
        if ((bits & (bits - 1)) != 0) bits &= met_spheres(block, forms.get());
    }
    while (bits != 0) {
        const auto i = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
        bits &= bits - 1;
        test_sphere(forms.get(), {block.center[0][i], block.center[1][i], block.center[2][i]},
                    block.radius[i], block.object[i], search);
        if (kAny && search.best.object.valid()) return true;
    }
    return false;
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
