// SPDX-License-Identifier: MIT
// Phong's model with the reflected view ray, as the language defines it.
#pragma once

#include "ir/math/elementary.hpp"
#include "ir/math/vec.hpp"

namespace cobble::renderer {

/// kd max(0, N.L). Unit vectors; L points to the light.
template <typename T>
math::Vec3<T> lambert(math::Vec3<T> normal, math::Vec3<T> to_light, math::Vec3<T> kd) {
    const T cosine = math::dot(normal, to_light);
    return cosine > T(0) ? kd * cosine : math::Vec3<T>{};
}

/// Whether a surface has a highlight at all. Nothing black adds anything, at the price of a power.
template <typename T>
bool has_highlight(math::Vec3<T> specular, double shininess) {
    return shininess > 0 && !(specular == math::Vec3<T>{});
}

/// max(0, R.L)^shininess, R the view ray reflected at N; 0 unless N.L > 0.
template <typename T>
T highlight(math::Vec3<T> normal, math::Vec3<T> to_light, math::Vec3<T> reflected_view,
            double shininess) {
    if (!(math::dot(normal, to_light) > T(0))) return 0;
    const T along = math::dot(reflected_view, to_light);
    if (!(along > T(0))) return 0;
    // Rounding may leave the cosine above 1, which a large shininess would blow up.
    const double base = along < T(1) ? static_cast<double>(along) : 1.0;
    return static_cast<T>(math::pow(base, shininess));
}

/// kd max(0, N.L) + specular max(0, R.L)^shininess, R the view ray reflected at N; the highlight
/// only where N.L > 0, shininess > 0 and `highlights` says so. Only a highlight looks at R.
template <typename T>
math::Vec3<T> phong(math::Vec3<T> normal, math::Vec3<T> to_light, math::Vec3<T> reflected_view,
                    math::Vec3<T> kd, math::Vec3<T> specular, double shininess, bool highlights) {
    math::Vec3<T> result = lambert(normal, to_light, kd);
    if (highlights && has_highlight(specular, shininess)) {
        result += specular * highlight(normal, to_light, reflected_view, shininess);
    }
    return result;
}

}  // namespace cobble::renderer
