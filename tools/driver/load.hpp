// SPDX-License-Identifier: MIT
// From a path to a scene that can be rendered.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "frontend/source/diagnostic.hpp"
#include "ir/lower.hpp"
#include "tools/driver/session.hpp"

namespace cobble::driver {

struct LoadedScene {
    std::unique_ptr<Session> session;  ///< null if the file could not be read
    ir::Lowered lowered;
    std::vector<source::Diagnostic> diagnostics;  ///< of all phases, sorted by place
    std::string problem;                          ///< why there is no session
    std::vector<std::string> files;  ///< all that was read: the scene, its meshes and pictures
    double read_seconds = 0, check_seconds = 0, lower_seconds = 0;
};

/// Reads, checks and lowers one scene; "-" is standard input, which is taken to stand at
/// `stdin_path` if that is not empty. A scene with errors is lowered all the same: whether to use
/// it is the caller's choice.
LoadedScene load_scene(const std::string& path, const std::string& stdin_path,
                       const ir::LowerOptions& options);

/// The text and path of a scene as load_scene() takes them, checked but not lowered.
LoadedScene check_scene(const std::string& path, const std::string& stdin_path);

}  // namespace cobble::driver
