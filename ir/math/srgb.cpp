// SPDX-License-Identifier: MIT
#include "ir/math/srgb.hpp"

#include <cmath>

#include "ir/math/elementary.hpp"

namespace cobble::math {

double srgb_to_linear(double display) {
    const double v = std::fabs(display);
    const double light = v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
    return display < 0 ? -light : light;
}

Vec3d srgb_to_linear(Vec3d display) {
    return {srgb_to_linear(display.x), srgb_to_linear(display.y), srgb_to_linear(display.z)};
}

double linear_to_srgb(double light) {
    const double v = std::fabs(light);
    const double display = v <= 0.0031308 ? v * 12.92 : 1.055 * pow(v, 1 / 2.4) - 0.055;
    return light < 0 ? -display : display;
}

}  // namespace cobble::math
