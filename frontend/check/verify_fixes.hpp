// SPDX-License-Identifier: MIT
// Only fixes that work. Input: a checked scene. Output: the same without the fixes that, applied to
// the file, leave their finding in place or add another; but what stands in a block whose name
// becomes one by the change is looked at for the first time then, and may have its own findings.
// Invariant: nothing but fixes changes.
//
// Each fix costs one more check of the whole file, so there is a budget: at most 100 fixes of a
// file and 4 MB of text checked again (about a tenth of a second); a fix beyond it, and every fix
// of a file above 4 MB, is dropped unseen.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "frontend/check/check.hpp"

namespace cobble::frontend {

inline constexpr std::size_t kMostVerifications = 100;
inline constexpr std::size_t kMostVerifiedBytes = std::size_t{4} << 20;
inline constexpr std::size_t kLargestVerifiedFile = std::size_t{4} << 20;

/// The block of the scene `changed` by `fix` that was not looked at before, since its name differed
/// in case or held a character that cannot be seen; an empty range if there is none.
ByteRange newly_read(const CheckedScene& scene, const source::Diagnostic& diagnostic,
                     const source::Fix& fix, const CheckedScene& changed);

void verify_fixes(CheckedScene& scene);

/// check() as it is before its fixes are verified.
CheckedScene check_unverified(source::SourceId source, std::string_view text);

/// `text` with the edits of one fix applied, or nothing if they overlap or leave the text. Edits
/// of other sources are no edits here.
std::optional<std::string> apply(std::string_view text, source::SourceId source,
                                 const source::Fix& fix);

}  // namespace cobble::frontend
