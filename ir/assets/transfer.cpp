// SPDX-License-Identifier: MIT
#include "ir/assets/transfer.hpp"

#include <array>
#include <cmath>

#include "ir/math/elementary.hpp"

namespace cobble::ir {

double srgb_to_linear(double value) {
    const double v = std::fabs(value);
    // The constants of the standard's transfer function.
    const double linear = v <= 0.04045 ? v / 12.92 : math::pow((v + 0.055) / 1.055, 2.4);
    return value < 0 ? -linear : linear;
}

math::Vec3d srgb_to_linear(math::Vec3d color) {
    return {srgb_to_linear(color.x), srgb_to_linear(color.y), srgb_to_linear(color.z)};
}

void decode_to_linear(Image& image) {
    if (image.tag != ColorTag::kDisplay) return;
    std::array<float, 256> table;
    for (std::size_t i = 0; i < table.size(); ++i) {
        table[i] = static_cast<float>(srgb_to_linear(static_cast<double>(i) / 255));
    }
    image.floats.resize(image.bytes.size());
    for (std::size_t i = 0; i < image.bytes.size(); ++i) image.floats[i] = table[image.bytes[i]];
    image.bytes = {};
    image.tag = ColorTag::kLinear;
}

}  // namespace cobble::ir
