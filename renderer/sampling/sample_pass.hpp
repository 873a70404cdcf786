// SPDX-License-Identifier: MIT
// Which samples of each pixel one pass over the picture takes, and which random numbers they use.
#pragma once

#include <cstdint>

#include "renderer/sampling/hash.hpp"

namespace cobble::renderer {

class PixelMask;

/// What draws numbers. Values are part of every picture's meaning: never renumber.
enum class Draw : std::uint8_t { kPixel = 1, kLens = 2, kTime = 3, kLight = 4 };

/// How the numbers of a set lie.
enum class Scatter : std::uint8_t {
    kSobol,   ///< spread evenly: what pictures are made of
    kRandom,  ///< independent of each other, for bounds that hold of such numbers only
};

struct SamplePass {
    std::uint64_t seed = 0;
    std::uint32_t first = 0;  ///< samples [first, first + count) of each pixel
    std::uint32_t count = 1;  ///< at least 1
    bool centred = false;     ///< the pixel's only sample goes through its centre
    Scatter scatter = Scatter::kSobol;
    /// Takes what draws of one kind use from other sets and leaves the rest as they are: 16 bits a
    /// kind, the first one's lowest. 0: the sets that `seed` names.
    std::uint64_t salts = 0;
    const PixelMask* active = nullptr;  ///< the pixels that take them; all if null

    void set_salt(Draw what, std::uint16_t salt) {
        const std::uint32_t shift = 16U * (static_cast<std::uint32_t>(what) - 1U);
        salts = (salts & ~(std::uint64_t{0xffff} << shift)) | std::uint64_t{salt} << shift;
    }
};

/// All samples of a picture in one pass.
inline SamplePass whole_pass(std::uint64_t seed, std::uint32_t samples) {
    SamplePass pass;
    pass.seed = seed;
    pass.count = samples == 0 ? 1 : samples;
    pass.centred = pass.count == 1;
    return pass;
}

/// The seed of the scramble `index` of several that are independent of each other.
inline std::uint64_t scramble_seed(std::uint64_t seed, std::uint32_t index) {
    constexpr std::uint64_t kScramble = 0x5c3a'6b1e'0000'0000U;  // unlike any seed's small number
    return combine(seed, kScramble + index);
}

}  // namespace cobble::renderer
