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

#include <cstddef>
#include <cstdint>

#include "renderer/accel/wide_tree.hpp"
#include "renderer/query/query.hpp"
#include "renderer/wide/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

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
    const auto a = hn::Set(d, dot(along, along));
    const auto zero = hn::Zero(d);
    const auto dot_of = [&](auto x0, auto y0, auto z0, auto x1, auto y1, auto z1) HWY_ATTR {
        return hn::Add(hn::Add(hn::Mul(x0, x1), hn::Mul(y0, y1)), hn::Mul(z0, z1));
    };
    std::uint32_t bits = 0;
    for (std::size_t part = 0; part < kBlockLanes; part += kLanes) {
        const auto relative = [&](std::size_t axis) HWY_ATTR {
            return hn::Sub(hn::Set(d, double{ray.shear.origin[axis]}),
                           hn::PromoteTo(d, hn::Load(df, block.center[axis] + part)));
        };
        const auto fx = relative(0);
        const auto fy = relative(1);
        const auto fz = relative(2);
        const auto r = hn::PromoteTo(d, hn::Load(df, block.radius + part));
        const auto b = hn::Sub(zero, dot_of(fx, fy, fz, dx, dy, dz));
        const auto q = hn::Div(b, a);
        const auto lx = hn::Add(fx, hn::Mul(dx, q));
        const auto ly = hn::Add(fy, hn::Mul(dy, q));
        const auto lz = hn::Add(fz, hn::Mul(dz, q));
        const auto rest = hn::Sub(hn::Mul(r, r), dot_of(lx, ly, lz, lx, ly, lz));
        bits |= bits_of(d, hn::Ge(rest, zero)) << part;
    }
    return bits;
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
