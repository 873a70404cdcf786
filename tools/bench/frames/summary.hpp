// SPDX-License-Identifier: MIT
// What a race says in one number each, and what it is to say.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/bench/frames/race.hpp"

namespace cobble::bench {

/// How many times as long as Cobble another program renders, or one thread as several.
struct Ratio {
    std::string what;
    unsigned samples = 1, threads = 1;
    double by_wall = 0;
    std::optional<double> by_cpu;  ///< by processor time, which others disturb less
    std::optional<double> wanted;  ///< at least this much is the aim
};

/// Everything that `results` have figures for. Blocks are compared in each program's faster form.
std::vector<Ratio> ratios_of(const std::vector<FrameResult>& results);

/// The median of processor seconds for the picture alone, if they were asked for.
std::optional<double> render_cpu(const FrameResult& result);

}  // namespace cobble::bench
