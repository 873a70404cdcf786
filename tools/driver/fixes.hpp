// SPDX-License-Identifier: MIT
// Applying the fixes that diagnostics offer.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "frontend/source/diagnostic.hpp"
#include "frontend/source/file_source.hpp"
#include "tools/driver/session.hpp"

namespace cobble::driver {

/// The text with the first applicable fix of each diagnostic applied, in order; fixes that overlap
/// one applied before are left for another round. Only fixes whose edits all lie in `scene` count,
/// and unsafe ones only with `unsafe`. `count` gets the number of fixes applied.
std::string apply_fixes(std::string_view text, source::SourceId scene,
                        const std::vector<source::Diagnostic>& diagnostics, bool unsafe,
                        std::size_t& count);

struct Fixed {
    std::string text;
    std::size_t applied = 0;
    /// There are more findings than are kept, so that it cannot be seen whether fixes help: those
    /// that are left were not applied.
    bool too_many = false;
};

/// Lints and fixes round after round until nothing is left to fix. Each round must leave fewer
/// findings than it met: where all fixes together do not, they are tried one by one, and one that
/// makes nothing better is given up.
Fixed fix_until_stable(const std::string& path, std::string text, source::FileSource& files,
                       const SeverityRules& rules, bool unsafe);

}  // namespace cobble::driver
