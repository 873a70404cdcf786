// SPDX-License-Identifier: MIT
#include "renderer/compat/pictures.hpp"

#include <algorithm>
#include <cmath>

namespace cobble::renderer {

Plane32 compat_depth_picture(const Plane32& depth, ir::Compat compat, double min, double max) {
    Plane32 result = depth;
    for (float& value : result.values) {
        const auto t = static_cast<double>(value);
        // Far enough for every miss; a range without extent is a step.
        const double range = max > min ? max - min : 1e-300;
        const double far = std::clamp((std::min(t, 1e300) - min) / range, 0.0, 1.0);
        const double near = std::clamp((max - std::min(t, 1e300)) / range, 0.0, 1.0);
        value = static_cast<float>(compat == ir::Compat::kFa2016 ? far : near);
    }
    return result;
}

Plane32 compat_normals_picture(const Plane32& normals, ir::Compat compat) {
    Plane32 result = normals;
    for (float& value : result.values) {
        value = compat == ir::Compat::kFa2016 ? (value + 1.0F) / 2.0F : std::fabs(value);
    }
    return result;
}

}  // namespace cobble::renderer
