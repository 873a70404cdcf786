// SPDX-License-Identifier: MIT
// What figures were measured on, and what else it was doing.
#pragma once

#include <fmt/format.h>
#include <stdlib.h>

#include <fstream>
#include <string>

namespace cobble::bench {

/// The load over one, five and fifteen minutes.
inline std::string load_now() {
    double load[3] = {};
    if (getloadavg(load, 3) != 3) return "unknown";
    return fmt::format("{:.2f} {:.2f} {:.2f}", load[0], load[1], load[2]);
}

inline std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    return "unknown processor";
}

}  // namespace cobble::bench
