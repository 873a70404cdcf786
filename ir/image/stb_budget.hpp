// SPDX-License-Identifier: MIT
// A ceiling on the memory that one decoding may take: a compressed stream can claim a small picture
// and expand without end.
#pragma once

#include <cstddef>

namespace cobble::image {

/// While it lives, decoding on this thread may hold at most `bytes`; beyond, it fails.
class StbBudget {
  public:
    explicit StbBudget(std::size_t bytes);
    StbBudget(const StbBudget&) = delete;
    StbBudget& operator=(const StbBudget&) = delete;
    ~StbBudget();
};

}  // namespace cobble::image
