// SPDX-License-Identifier: MIT
// The original programs' command lines.
#pragma once

#include <string>
#include <vector>

namespace cobble {

/// Rewrites `-input F -output F -size W H -depth MIN MAX F -normals F -bounces N -shadows -jitter
/// -filter -casting -blurry F -pixelated` into options that the parser knows, within `render`. A
/// command line that begins with one of them is `render` with the original's defaults: 100x100
/// pixels, 4 bounces, and `--compat project` unless it says otherwise. Others stay as they are.
/// Gives "" or what is missing after which word.
std::string rewrite_old_spellings(std::vector<std::string>& arguments);

}  // namespace cobble
