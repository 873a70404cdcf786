// SPDX-License-Identifier: MIT
// The renderers that are compared: how each is started, and how it says what its phases took.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tools/bench/frames/child.hpp"
#include "tools/bench/frames/scene_files.hpp"

namespace cobble::bench {

/// Wall seconds; what a program does not tell apart is in the phase before.
struct Phases {
    double parse = 0;    ///< reading and checking the scene
    double prepare = 0;  ///< building the acceleration structure
    double render = 0;   ///< tracing and shading, without writing the picture
    /// Processor seconds of the same, and rays from the camera, if the program says.
    std::optional<double> render_cpu, camera_rays;
};

struct Program {
    std::string name;
    std::string executable;
    bool refracts = true;  ///< its picture of glass is comparable
    bool renders_glass = true;
    /// Writes the scene; "" if that fails.
    std::function<std::string(const Input&, const ScenePlan&)> write;
    /// Renders `scene` to `picture`, a PNG.
    std::function<std::vector<std::string>(const std::string& scene, const std::string& picture,
                                           const ScenePlan&, unsigned threads)>
        command;
    /// From what it wrote, and beside the picture; nothing if it does not say.
    std::function<std::optional<Phases>(const ChildResult&, const std::string& picture)> phases;
    /// The picture is this many times as wide and high as asked for, to have so many samples.
    std::function<unsigned(const ScenePlan&)> enlargement;
};

struct ProgramPaths {
    std::string cobble, povray = "povray", tachyon = "tachyon-nox";
    std::string self;  ///< this program, which renders with Embree if it was built with it
};

/// Those that are installed, Cobble first.
std::vector<Program> find_programs(const ProgramPaths& paths);

/// What this program prints as the Embree renderer, for phases() above.
std::string phases_text(const Phases& phases);

}  // namespace cobble::bench
