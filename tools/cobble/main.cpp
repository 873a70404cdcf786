// SPDX-License-Identifier: MIT
#include <fmt/core.h>

int main() {
    fmt::print("cobble {}\n", COBBLE_VERSION);
    return 0;
}
