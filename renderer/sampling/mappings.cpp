// SPDX-License-Identifier: MIT
#include "renderer/sampling/mappings.hpp"

#include <algorithm>
#include <cmath>

#include "ir/math/elementary.hpp"

namespace cobble::renderer {
namespace {

/// Inverse of the tent's cumulative distribution on [-1, 1].
double sample_tent(double u) { return u < 0.5 ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 * (1 - u)); }

}  // namespace

math::Vec2d sample_disk(Uniform2 u) {
    const double a = 2 * u.x - 1;
    const double b = 2 * u.y - 1;
    if (a == 0 && b == 0) return {0, 0};
    constexpr double kQuarter = math::kPi / 4;
    const bool wide = std::fabs(a) > std::fabs(b);
    const double radius = wide ? a : b;
    const double angle = wide ? kQuarter * (b / a) : 2 * kQuarter - kQuarter * (a / b);
    const math::SinCos turn = math::sincos(angle);
    return {radius * turn.cos, radius * turn.sin};
}

math::Vec2d sample_polygon(Uniform2 u, std::uint32_t sides) {
    // One number picks the triangle from the centre, and what is left of it the place inside.
    const double scaled = u.x * sides;
    const double triangle = std::min(std::floor(scaled), static_cast<double>(sides - 1));
    const double rest = scaled - triangle;
    const double step = 360.0 / sides;
    const math::SinCos first = math::sincos_degrees(90 + triangle * step);
    const math::SinCos second = math::sincos_degrees(90 + (triangle + 1) * step);
    const double radius = std::sqrt(u.y);
    const double b = radius * rest;
    const double a = radius - b;
    return {a * first.cos + b * second.cos, a * first.sin + b * second.sin};
}

math::Vec3d sample_cone(Uniform2 u, double one_minus_cos_half_angle) {
    const double one_minus_cos = u.x * one_minus_cos_half_angle;
    const double sine = std::sqrt(one_minus_cos * (2 - one_minus_cos));
    const math::SinCos turn = math::sincos(2 * math::kPi * u.y);
    return {sine * turn.cos, sine * turn.sin, 1 - one_minus_cos};
}

math::Vec2d sample_filter(Uniform2 u, PixelFilter filter) {
    switch (filter) {
        case PixelFilter::kTent:
            return {sample_tent(u.x), sample_tent(u.y)};
        case PixelFilter::kGaussian: {
            // Box and Muller's radius, cut: exp(-r^2 / (2 s^2)) runs from 1 down to exp(-4.5).
            constexpr double kSigma = 0.5;
            constexpr double kTail = 0.011108996538242306;  // exp(-4.5), at three sigmas
            const double radius = kSigma * std::sqrt(-2 * math::log(1 - u.x * (1 - kTail)));
            const math::SinCos turn = math::sincos(2 * math::kPi * u.y);
            return {radius * turn.cos, radius * turn.sin};
        }
        case PixelFilter::kBox:
            break;
    }
    return {u.x - 0.5, u.y - 0.5};
}

}  // namespace cobble::renderer
