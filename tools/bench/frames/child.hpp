// SPDX-License-Identifier: MIT
// Runs another program and says what it cost.
#pragma once

#include <string>
#include <vector>

namespace cobble::bench {

struct ChildResult {
    bool ran = false;    ///< it could be started and ended with 0
    std::string text;    ///< what it wrote to standard output and standard error
    double wall = 0;     ///< seconds, from start to end
    double cpu = 0;      ///< seconds of all its threads, in it and in the kernel
    double peak_mb = 0;  ///< most memory held at once, in megabytes
};

/// `arguments[0]` is looked up in PATH. Waits for its end.
ChildResult run_child(const std::vector<std::string>& arguments);

/// Whether PATH, or the path itself, leads to a program.
bool is_installed(const std::string& program);

}  // namespace cobble::bench
