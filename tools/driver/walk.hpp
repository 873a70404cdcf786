// SPDX-License-Identifier: MIT
// From the paths of a command line to the scene files that they stand for.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cobble::driver {

struct SceneFiles {
    /// In the order of the command line, each folder's files sorted by name; no file twice. "-" is
    /// passed on.
    std::vector<std::string> paths;
    /// What could not be found or read: one message for each.
    std::vector<std::string> problems;
};

/// A named file is taken whatever its ending. A folder is walked: every `*.scene`, and every
/// `*.txt` whose first token is a top-level block name of any dialect; what .gitignore and
/// .cobbleignore leave out is left out, those of the folders above included up to the top of a Git
/// repository. Links to folders are not followed. A folder without any scene is a problem.
SceneFiles find_scenes(const std::vector<std::string>& arguments);

/// Whether the text begins, after byte-order mark, white space and comments, with the name of a
/// top-level block, with or without a brace glued to it.
bool begins_like_a_scene(std::string_view text);

}  // namespace cobble::driver
