// SPDX-License-Identifier: MIT
#include "renderer/stability/exact.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

namespace cobble::renderer {
namespace {

using math::DoubleDouble;
using math::Vec3d;

/// Beyond these products of three leave the range in which double-double is exact.
constexpr double kLargest = 0x1p300;
constexpr double kSmallest = 0x1p-300;
struct Wide3 {
    DoubleDouble x, y, z;
};

Wide3 minus(Vec3d a, Vec3d b) {
    return {math::two_sum(a.x, -b.x), math::two_sum(a.y, -b.y), math::two_sum(a.z, -b.z)};
}

/// A number and a bound on how far it is off.
struct Bounded {
    DoubleDouble value;
    double size = 0;  ///< sum of the sizes of its terms

    void add(DoubleDouble term) {
        value += term;
        size += std::fabs(term.hi);
    }
    [[nodiscard]] int sign(double rounding) const {
        if (value.hi > rounding * size) return 1;
        return value.hi < -rounding * size ? -1 : 0;
    }
};

/// d . (a x b).
Bounded volume(const Wide3& d, const Wide3& a, const Wide3& b) {
    Bounded sum;
    sum.add(d.x * a.y * b.z);
    sum.add(-d.x * a.z * b.y);
    sum.add(d.y * a.z * b.x);
    sum.add(-d.y * a.x * b.z);
    sum.add(d.z * a.x * b.y);
    sum.add(-d.z * a.y * b.x);
    return sum;
}

Bounded product(const Wide3& a, const Wide3& b) {
    Bounded sum;
    sum.add(a.x * b.x);
    sum.add(a.y * b.y);
    sum.add(a.z * b.z);
    return sum;
}

bool in_range(Vec3d p) {
    for (std::size_t i = 0; i < 3; ++i) {
        const double size = std::fabs(p[i]);
        if (size != 0 && !(size <= kLargest && size >= kSmallest)) return false;
    }
    return true;
}

}  // namespace

ExactMeeting meet_exactly(const Ray<double>& ray, const std::array<Vec3d, 3>& vertices,
                          double rounding) {
    if (!in_range(ray.origin) || !in_range(ray.direction) || !in_range(vertices[0]) ||
        !in_range(vertices[1]) || !in_range(vertices[2])) {
        return {};
    }
    const Wide3 d = minus(ray.direction, {});
    const Wide3 a = minus(vertices[0], ray.origin);
    const Wide3 b = minus(vertices[1], ray.origin);
    const Wide3 c = minus(vertices[2], ray.origin);
    const int u = volume(d, c, b).sign(rounding);
    const int v = volume(d, a, c).sign(rounding);
    const int w = volume(d, b, a).sign(rounding);
    // Two that surely differ: it passes by.
    if (u * v < 0 || v * w < 0 || w * u < 0) return {Meeting::kMisses, {}};
    if (u == 0 || v == 0 || w == 0) return {};
    // The plane's normal is (b - a) x (c - a); with the origin at 0 its product with a point of the
    // plane is the volume of the three corners.
    const Wide3 ab = minus(vertices[1], vertices[0]);
    const Wide3 ac = minus(vertices[2], vertices[0]);
    const Bounded above = volume(a, ab, ac);
    const Bounded along = volume(d, ab, ac);
    if (along.sign(rounding) == 0 || above.sign(rounding) == 0) return {};
    if (above.sign(rounding) != along.sign(rounding)) return {Meeting::kMisses, {}};
    return {Meeting::kMeets, above.value / along.value};
}

ExactMeeting meet_exactly(const Ray<double>& ray, const SphereKey<double>& sphere,
                          double rounding) {
    const Vec3d radius{sphere.radius, 0, 0};
    if (!in_range(ray.origin) || !in_range(ray.direction) || !in_range(sphere.center) ||
        !in_range(radius)) {
        return {};
    }
    // a t^2 + 2 b t + c = 0 for points o + t d.
    const Wide3 d = minus(ray.direction, {});
    const Wide3 o = minus(ray.origin, sphere.center);
    const Bounded a = product(d, d);
    const Bounded b = product(o, d);
    Bounded c = product(o, o);
    c.add(-(DoubleDouble(sphere.radius) * DoubleDouble(sphere.radius)));
    Bounded discriminant{b.value * b.value - a.value * c.value, b.size * b.size + a.size * c.size};
    if (a.sign(rounding) <= 0 || b.sign(rounding) == 0 || c.sign(rounding) == 0 ||
        discriminant.sign(rounding) == 0)
        return {};
    if (discriminant.sign(rounding) < 0) return {Meeting::kMisses, {}};
    const DoubleDouble root = math::sqrt(discriminant.value);
    // From inside the far side is met, from outside the near one, if it is ahead.
    if (c.sign(rounding) < 0) return {Meeting::kMeets, (root - b.value) / a.value};
    if (b.sign(rounding) > 0) return {Meeting::kMisses, {}};
    return {Meeting::kMeets, (-b.value - root) / a.value};
}

ExactMeeting meet_exactly(const Ray<double>& ray, const BoxBounds<double>& box, double rounding) {
    if (!in_range(ray.origin) || !in_range(ray.direction) || !in_range(box.lo) ||
        !in_range(box.hi)) {
        return {};
    }
    const Wide3 lo = minus(box.lo, ray.origin);
    const Wide3 hi = minus(box.hi, ray.origin);
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    DoubleDouble near(-kInfinity);
    DoubleDouble far(kInfinity);
    const auto clip = [&](double along, DoubleDouble a, DoubleDouble b) {
        if (along == 0) {
            // Above it, below it, or beside it for good.
            if (!(a.hi < 0 && b.hi > 0)) far = DoubleDouble(-kInfinity);
            return;
        }
        const DoubleDouble first = (along > 0 ? a : b) / DoubleDouble(along);
        const DoubleDouble last = (along > 0 ? b : a) / DoubleDouble(along);
        if (first > near) near = first;
        if (last < far) far = last;
    };
    clip(ray.direction.x, lo.x, hi.x);
    clip(ray.direction.y, lo.y, hi.y);
    clip(ray.direction.z, lo.z, hi.z);
    if (far.hi < 0 || near.hi > far.hi) return {Meeting::kMisses, {}};
    const DoubleDouble span = far - near;
    if (std::fabs(span.hi) <= rounding * std::fabs(far.hi)) return {};
    if (span.hi < 0) return {Meeting::kMisses, {}};
    return {Meeting::kMeets, near.hi > 0 ? near : far};
}

ExactMeeting meet_exactly(const Ray<double>& ray, const PlaneKey& plane, double rounding) {
    const Vec3d offset{plane.offset, 0, 0};
    if (!in_range(ray.origin) || !in_range(ray.direction) || !in_range(plane.normal) ||
        !in_range(offset)) {
        return {};
    }
    const Wide3 normal = minus(plane.normal, {});
    Bounded above = product(normal, minus(ray.origin, {}));
    above.add(-DoubleDouble(plane.offset));
    const Bounded along = product(normal, minus(ray.direction, {}));
    if (above.sign(rounding) == 0 || along.sign(rounding) == 0) return {};
    if (above.sign(rounding) == along.sign(rounding)) return {Meeting::kMisses, {}};
    return {Meeting::kMeets, -above.value / along.value};
}

}  // namespace cobble::renderer
