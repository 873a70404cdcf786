// SPDX-License-Identifier: MIT
// Phong's model with the reflected view ray, as the language defines it.
#pragma once

#include "ir/math/elementary.hpp"
#include "ir/math/vec.hpp"

namespace cobble::renderer {

/// kd max(0, N.L) + specular max(0, R.L)^shininess, R the view ray reflected at N; the highlight
/// only where N.L > 0, shininess > 0 and `highlights` says so. Unit vectors; L points to the light.
template <typename T>
math::Vec3<T> phong(math::Vec3<T> normal, math::Vec3<T> to_light, math::Vec3<T> reflected_view,
                    math::Vec3<T> kd, math::Vec3<T> specular, double shininess, bool highlights) {
    const T lambert = math::dot(normal, to_light);
    if (!(lambert > T(0))) return {};
    math::Vec3<T> result = kd * lambert;
    if (highlights && shininess > 0) {
        const T along = math::dot(reflected_view, to_light);
        if (along > T(0)) {
            // Rounding may leave the cosine above 1, which a large shininess would blow up.
            const double base = along < T(1) ? static_cast<double>(along) : 1.0;
            result += specular * static_cast<T>(math::pow(base, shininess));
        }
    }
    return result;
}

}  // namespace cobble::renderer
