// SPDX-License-Identifier: MIT
// What trees are built of, laid out for the loops that read it once or twice a level.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "renderer/geometry/primitives.hpp"

namespace cobble::renderer {

/// A box by x, y, z and a number without meaning. The high corner is negated, so that the least is
/// looked for in all eight, and lo - minus_hi is twice the middle.
template <typename T>
struct alignas(8 * sizeof(T)) Extent {
    T lo[4], minus_hi[4];

    /// Inside out: adding to it gives what was added.
    static constexpr Extent none() {
        constexpr T kInfinity = std::numeric_limits<T>::infinity();
        return {{kInfinity, kInfinity, kInfinity, kInfinity},
                {kInfinity, kInfinity, kInfinity, kInfinity}};
    }
    constexpr void add(const Extent& other) {
        for (std::size_t i = 0; i < 4; ++i) {
            lo[i] = other.lo[i] < lo[i] ? other.lo[i] : lo[i];
            minus_hi[i] = other.minus_hi[i] < minus_hi[i] ? other.minus_hi[i] : minus_hi[i];
        }
    }
    [[nodiscard]] constexpr BoxBounds<T> box() const {
        return {{lo[0], lo[1], lo[2]}, {-minus_hi[0], -minus_hi[1], -minus_hi[2]}};
    }
};

/// One thing to put into a tree: its box, kind and number among those of its kind. The latter two
/// are kept as whole numbers in the lanes without meaning: loops that take all eight as numbers
/// meet none that is NaN or below the normal range, where arithmetic takes a hundred times as long.
template <typename T>
class BuildItem {
  public:
    BuildItem() = default;
    /// `bounds` are not empty and finite; `index` is the caller's.
    BuildItem(const BoxBounds<T>& bounds, PrimitiveKind kind, std::uint32_t index)
        : extent_{{bounds.lo.x, bounds.lo.y, bounds.lo.z, static_cast<T>(index & kLowMask)},
                  {-bounds.hi.x, -bounds.hi.y, -bounds.hi.z,
                   static_cast<T>(index >> kLowBits | static_cast<std::uint32_t>(kind)
                                                          << kHighBits)}} {}

    [[nodiscard]] const Extent<T>& extent() const { return extent_; }
    [[nodiscard]] BoxBounds<T> bounds() const { return extent_.box(); }
    [[nodiscard]] PrimitiveKind kind() const {
        return static_cast<PrimitiveKind>(static_cast<std::uint32_t>(extent_.minus_hi[3]) >>
                                          kHighBits);
    }
    [[nodiscard]] std::uint32_t index() const {
        const std::uint32_t high =
            static_cast<std::uint32_t>(extent_.minus_hi[3]) & ((1U << kHighBits) - 1);
        return high << kLowBits | static_cast<std::uint32_t>(extent_.lo[3]);
    }

  private:
    // The index in two halves, the kind above one of them: below the 24 bits that float has.
    static constexpr std::uint32_t kLowBits = 16;
    static constexpr std::uint32_t kHighBits = 16;
    static constexpr std::uint32_t kLowMask = (1U << kLowBits) - 1;

    Extent<T> extent_;
};
static_assert(sizeof(BuildItem<float>) == 32);

}  // namespace cobble::renderer
