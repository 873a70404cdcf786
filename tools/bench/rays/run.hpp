// SPDX-License-Identifier: MIT
// One input through every kind of ray and core that was chosen.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/bench/inputs/input.hpp"
#include "tools/bench/rays/measure.hpp"
#include "tools/bench/rays/ray_sets.hpp"
#include "tools/bench/rays/report.hpp"

namespace cobble::bench {

struct Choice {
    std::vector<std::string> kinds;  ///< names of kRayKinds, and "build"
    std::vector<std::string> cores;  ///< any of these within the core's name; empty: all
    std::vector<unsigned> threads{1, 2};
    PictureSize size;
    Effort effort;
};

/// Returns how many answers of the fast core differ from the reference's. T is float or double.
template <typename T>
std::uint64_t run_input(const Input& input, const Choice& choice, Report& report);

}  // namespace cobble::bench
