// SPDX-License-Identifier: MIT
#include "renderer/accel/tree_limits.hpp"

#include <cinttypes>
#include <cstdio>

namespace cobble::renderer {

TooManyThings::TooManyThings(std::uint64_t things) : text_() {
    std::snprintf(text_.data(), text_.size(),
                  "a tree of %" PRIu64 " triangles and other shapes: at most %" PRIu64
                  " can be held",
                  things, kMostThings);
}

void require_room(std::uint64_t things) {
    if (things > kMostThings) throw TooManyThings(things);
}

}  // namespace cobble::renderer
