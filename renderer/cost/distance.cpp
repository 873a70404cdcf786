// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "ir/math/srgb.hpp"
#include "renderer/cost/parts.hpp"
#include "renderer/metrics/compare.hpp"

namespace cobble::renderer {
namespace {

Plane32 encoded(const Plane32& light) {
    Plane32 shown = light;
    for (float& value : shown.values) {
        value = static_cast<float>(math::linear_to_srgb(std::clamp<double>(value, 0, 1)));
    }
    return shown;
}

}  // namespace

Distance distance(const Studio& studio, const Plane32& a, const Plane32& b) {
    CompareOptions how;
    how.pixels_per_degree = studio.options().pixels_per_degree;
    how.threads = 0;
    const bool light = studio.options().light;
    const Comparison difference = light ? compare(encoded(a), encoded(b), how) : compare(a, b, how);
    return {std::sqrt(difference.mse), difference.flip, difference.maximum};
}

}  // namespace cobble::renderer
