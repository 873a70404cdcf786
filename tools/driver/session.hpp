// SPDX-License-Identifier: MIT
// One scene through the front end, with its files from the disk: what every command begins with.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/check/check.hpp"
#include "frontend/source/diagnostic.hpp"
#include "frontend/source/file_source.hpp"
#include "frontend/source/source_map.hpp"
#include "ir/lower.hpp"

namespace cobble::driver {

/// What a path's text is, or why there is none.
struct ReadText {
    std::string text;
    std::string problem;  ///< "cannot read PATH: REASON"; empty if it was read
};

/// Reads a whole file; a scene is at most 4 GiB less 2 bytes, as offsets are 32-bit numbers.
ReadText read_text(const std::string& path);

/// Reads standard input to its end, within the same limit.
ReadText read_standard_input();

/// Codes that the command line treats differently from their default.
struct SeverityRules {
    std::set<std::string, std::less<>> denied;   ///< these are errors
    std::set<std::string, std::less<>> allowed;  ///< these are dropped
};

/// One scene, all its findings, and the texts that they speak of. Not to be moved: views into
/// `sources` are held by `checked`.
struct Session {
    /// With kUnverified, fixes are listed that may not help: for callers who check again anyway.
    enum class Fixes : unsigned char { kVerified, kUnverified };
    explicit Session(std::string path, std::string text, Fixes fixes = Fixes::kVerified);
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    source::SourceMap sources;
    source::SourceId scene;
    frontend::CheckedScene checked;
};

/// Drops and raises findings as `rules` say.
void apply(const SeverityRules& rules, std::vector<source::Diagnostic>& diagnostics);

/// Sorts by place: the scene itself first, other files after it, findings without a place last.
/// Findings at one place keep their order.
void sort_by_place(std::vector<source::Diagnostic>& diagnostics, source::SourceId scene);

/// Everything that `cobble lint` says about a scene: syntax, checks, assets; sorted by place.
std::vector<source::Diagnostic> lint(Session& session, source::FileSource& files,
                                     const SeverityRules& rules);

bool has_errors(const std::vector<source::Diagnostic>& diagnostics);

}  // namespace cobble::driver
