// SPDX-License-Identifier: MIT
#include "ir/assets/transfer.hpp"

#include <array>

#include "ir/math/srgb.hpp"

namespace cobble::ir {

void decode_to_linear(Image& image) {
    if (image.tag != ColorTag::kDisplay) return;
    std::array<float, 256> table;
    for (std::size_t i = 0; i < table.size(); ++i) {
        table[i] = static_cast<float>(math::srgb_to_linear(static_cast<double>(i) / 255));
    }
    image.floats.resize(image.bytes.size());
    for (std::size_t i = 0; i < image.bytes.size(); ++i) image.floats[i] = table[image.bytes[i]];
    image.bytes = {};
    image.tag = ColorTag::kLinear;
}

}  // namespace cobble::ir
