// SPDX-License-Identifier: MIT
// Times several ways of doing one thing in turns, so that what disturbs the machine disturbs all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace cobble::bench {

/// One way of answering a set of rays.
struct Contestant {
    std::string core;      ///< as options name it: "cobble-avx2", "embree-robust-8"
    unsigned threads = 1;  ///< each takes every `threads`-th stretch of rays
    /// Called before each pass, on one thread; may be empty.
    std::function<void()> before;
    /// Answers rays [begin, end) and returns how many hit something. Sets the floating-point mode
    /// that it wants and restores what was.
    std::function<std::uint64_t(std::size_t begin, std::size_t end)> trace;
};

/// Seconds of each pass. Passes with one number are neighbours in time across contestants.
struct Timing {
    std::vector<double> wall;
    std::vector<double> cpu;  ///< of the one thread; empty if there are more
    std::uint64_t hits = 0;

    /// What counts: processor time of one thread, wall time of more.
    [[nodiscard]] const std::vector<double>& seconds() const { return cpu.empty() ? wall : cpu; }
};

struct Effort {
    std::size_t passes = 7;  ///< at least
    double seconds = 0;      ///< at least, for each contestant
};

/// One pass of each to warm up, then A B C A B C ... One entry for each contestant.
std::vector<Timing> measure(const std::vector<Contestant>& contestants, std::size_t rays,
                            Effort effort);

}  // namespace cobble::bench
