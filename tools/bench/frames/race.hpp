// SPDX-License-Identifier: MIT
// All programs on one picture, in turns.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/bench/frames/programs.hpp"

namespace cobble::bench {

struct FrameResult {
    std::string picture, program;
    unsigned samples = 1, threads = 1;
    bool failed = false;
    Phases phases;                ///< medians
    double wall = 0;              ///< median, of the whole program
    double cpu = 0;               ///< median, of all its threads
    double peak_mb = 0;           ///< the most of all passes
    std::vector<double> renders;  ///< seconds of rendering, by pass
    /// Processor seconds of rendering, by pass; empty unless asked for. Of a program that does not
    /// say: beyond those for a picture of 16 x 16 pixels, so rendering and writing.
    std::vector<double> render_cpus;
    std::optional<double> rays_a_pixel;  ///< from the camera, if the program says
    /// Rendering: how many times as long as Cobble on the same picture; median of passes.
    std::optional<double> times_cobble, times_cobble_cpu;
    std::optional<double> difference;  ///< from Cobble's picture, mean of channels, 0 to 1
};

struct RaceOptions {
    unsigned threads = 1;
    std::size_t passes = 3;
    bool render_cpu = false;  ///< each program runs once more for each pass
};

/// One result for each program that can, in their order; the first program is what others are
/// compared with. Pictures stay in the plan's folder as PICTURE-PROGRAM-SAMPLES.png. Every program
/// runs once for each pass; one that fails does not run again.
std::vector<FrameResult> race(const Input& input, const ScenePlan& plan, const RaceOptions& options,
                              const std::vector<Program>& programs);

}  // namespace cobble::bench
