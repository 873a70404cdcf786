// SPDX-License-Identifier: MIT
// Which slot of a wide node each child gets: the one that lies in its direction, so that slots in
// the order of their numbers, each turned by exclusive or with a bit for each axis along which the
// ray runs forward, come from far to near, more or less, for any ray (Ylitie, Karras and Laine,
// Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs, 2017).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "renderer/geometry/primitives.hpp"

namespace cobble::renderer {

inline constexpr std::size_t kSlots = 8;

/// Slot s lies to the high side of axis a if bit a of s is set. The child whose middle is farthest
/// from the node's chooses first; of equal slots the first is taken. Gives each child's slot.
/// `children`: at most kSlots.
template <typename T>
std::array<std::uint8_t, kSlots> slots_by_corner(const BoxBounds<T>& node,
                                                 std::span<const BoxBounds<T>> children) {
    std::array<math::Vec3<float>, kSlots> off;
    std::array<float, kSlots> distance{};
    std::array<std::size_t, kSlots> farthest_first{};
    for (std::size_t i = 0; i < children.size(); ++i) {
        off[i] = ((children[i].lo - node.lo) + (children[i].hi - node.hi)).template to<float>();
        const float far = std::fabs(off[i].x) + std::fabs(off[i].y) + std::fabs(off[i].z);
        std::size_t place = i;
        for (; place > 0 && distance[place - 1] < far; --place) {
            distance[place] = distance[place - 1];
            farthest_first[place] = farthest_first[place - 1];
        }
        distance[place] = far;
        farthest_first[place] = i;
    }
    std::array<std::uint8_t, kSlots> slots{};
    std::uint32_t taken = 0;
    for (std::size_t i = 0; i < children.size(); ++i) {
        const std::size_t child = farthest_first[i];
        const math::Vec3<float>& o = off[child];
        float best = -std::numeric_limits<float>::infinity();
        std::uint32_t slot = kSlots;
        for (std::uint32_t s = 0; s < kSlots; ++s) {
            const float along = ((s & 1) != 0 ? o.x : -o.x) + ((s & 2) != 0 ? o.y : -o.y) +
                                ((s & 4) != 0 ? o.z : -o.z);
            if ((taken >> s & 1) != 0 || (slot < kSlots && !(along > best))) continue;
            best = along;
            slot = s;
        }
        slots[child] = static_cast<std::uint8_t>(slot);
        taken |= 1U << slot;
    }
    return slots;
}

}  // namespace cobble::renderer
