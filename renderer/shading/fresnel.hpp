// SPDX-License-Identifier: MIT
// What a smooth surface does to a ray: where it goes, and how much goes there.
#pragma once

#include <cmath>

#include "ir/math/vec.hpp"

namespace cobble::renderer {

/// d - 2 (d . n) n, of unit length again. The sign of `normal` does not matter.
template <typename T>
math::Vec3<T> reflect(math::Vec3<T> direction, math::Vec3<T> normal) {
    return math::normalize(direction - (T(2) * math::dot(direction, normal)) * normal);
}

template <typename T>
struct Refraction {
    bool total = false;       ///< total internal reflection: nothing goes through
    math::Vec3<T> direction;  ///< unit; meaningless if total
    T reflectance = 1;        ///< in [0, 1]; the rest, 1 - reflectance, goes through
};

/// Snell's law and Schlick's approximation (Computer Graphics Forum 13(3), 1994) with the cosine
/// taken on the side of the lower index, as the language defines it. `direction` and `normal` are
/// unit; the normal's sign does not matter; indices are positive. Worked in double, so
/// that it is as continuous near the critical angle as numbers of type T are. With equal indices
/// the direction keeps its bits.
template <typename T>
Refraction<T> refract(math::Vec3<T> direction, math::Vec3<T> normal, T index_from, T index_to) {
    const auto d = direction.template to<double>();
    const auto n = normal.template to<double>();
    const auto from = static_cast<double>(index_from);
    const auto to = static_cast<double>(index_to);
    // Rounding may leave |d . n| a little above 1.
    const double signed_cosine = math::dot(d, n);
    const double magnitude = std::fabs(signed_cosine);
    const double cosine = magnitude < 1.0 ? magnitude : 1.0;
    const double side = signed_cosine < 0 ? -1.0 : 1.0;
    const math::Vec3d inward = n * side;
    const double eta = from / to;
    const double radicand = 1 - eta * eta * ((1 - cosine) * (1 + cosine));
    const bool straight = from == to;
    const double root = std::sqrt(radicand);
    const double cosine_through = straight ? cosine : root;
    // The part along the surface first: it is what eta stretches, and nothing cancels at eta's
    // size.
    const math::Vec3d along = d - cosine * inward;
    const math::Vec3<T> bent =
        math::normalize(eta * along + cosine_through * inward).template to<T>();
    const double ratio = (to - from) / (to + from);
    const double head_on = ratio * ratio;
    const double through_at_most_1 = cosine_through < 1.0 ? cosine_through : 1.0;
    const double rest = 1 - (from <= to ? cosine : through_at_most_1);
    const double rest2 = rest * rest;
    const T reflectance = static_cast<T>(head_on + (1 - head_on) * (rest2 * rest2 * rest));
    Refraction<T> result;
    result.total = !(radicand >= 0);  // NaN too: an index ratio that overflows
    result.direction = {straight ? direction.x : bent.x, straight ? direction.y : bent.y,
                        straight ? direction.z : bent.z};
    result.reflectance = result.total ? T(1) : reflectance;
    return result;
}

/// A direction that should be on the normal's side but is not (a bent normal sent it through the
/// surface), reflected once more, at the surface itself. Continuous, and keeps its length.
template <typename T>
math::Vec3<T> keep_above(math::Vec3<T> direction, math::Vec3<T> geometric_normal) {
    const T height = math::dot(direction, geometric_normal);
    if (!(height < T(0))) return direction;
    return direction - (T(2) * height) * geometric_normal;
}

/// A bent normal that the viewer sees from behind, although the surface itself faces the viewer,
/// turned back until it is seen edge-on. `geometric_normal` faces the viewer.
template <typename T>
math::Vec3<T> facing(math::Vec3<T> normal, math::Vec3<T> geometric_normal,
                     math::Vec3<T> direction) {
    const T away = math::dot(normal, direction);
    if (!(away > T(0))) return normal;
    const math::Vec3<T> turned = normal - away * direction;
    // Nothing to turn to if it points straight away.
    constexpr T kStraight = T(1e-6);  // squared sine: far above rounding, far below seeing
    return math::dot(turned, turned) > kStraight ? math::normalize(turned) : geometric_normal;
}

}  // namespace cobble::renderer
