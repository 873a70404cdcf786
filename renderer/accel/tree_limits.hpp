// SPDX-License-Identifier: MIT
// How many things a tree may hold, and what is thrown before memory is taken for more.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <new>

#include "renderer/accel/wide_tree.hpp"

namespace cobble::renderer {

/// Each thing may have a block of its own, and each but one of them may need a node of its own.
inline constexpr std::uint64_t kMostThings = std::min<std::uint64_t>(
    std::uint64_t{ChildRef::kMostIndex} + 1, std::uint64_t{ChildRef::kMostNode} + 1);

/// A tree that its own numbers can not reach into all of. Treated as if memory had run out, which
/// it would have on most machines: some 200 bytes for each thing.
class TooManyThings : public std::bad_alloc {
  public:
    explicit TooManyThings(std::uint64_t things);
    /// "a tree of 100000000 triangles and other shapes: at most 76695845 can be held"
    [[nodiscard]] const char* what() const noexcept override { return text_.data(); }

  private:
    std::array<char, 128> text_;
};

/// Throws TooManyThings if one tree can not hold so many.
void require_room(std::uint64_t things);

}  // namespace cobble::renderer
