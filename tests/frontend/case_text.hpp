// SPDX-License-Identifier: MIT
// Findings as text, as the expectations beside the case files hold them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "frontend/source/diagnostic.hpp"

namespace cobble::test {

/// One line a finding, `line:column-end severity code: message` (columns in code points, the end
/// exclusive), and below it, indented, its notes, related places and fixes with their edits.
std::string describe(std::string_view text, const std::vector<source::Diagnostic>& diagnostics);

/// The whole file, or an empty text if there is none.
std::string read_file(const std::string& path);

/// The files in `folder` with this ending, sorted; folders below it too.
std::vector<std::string> files_in(const std::string& folder, std::string_view ending);

}  // namespace cobble::test
