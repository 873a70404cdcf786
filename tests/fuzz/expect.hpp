// SPDX-License-Identifier: MIT
// What a fuzz program demands of the code it runs: a broken demand ends it with the input saved.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace cobble::fuzz {

inline void expect(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "expected: %s\n", what);
    std::abort();
}

}  // namespace cobble::fuzz
