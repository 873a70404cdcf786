// SPDX-License-Identifier: MIT
// Findings as text: for people, for programs, for code review.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/source/diagnostic.hpp"
#include "frontend/source/source_map.hpp"

namespace cobble::driver {

enum class ReportFormat : std::uint8_t { kHuman, kJson, kJsonLines, kSarif, kGithub };

/// The format of this name (human, json, jsonl, sarif, github), or nothing.
std::optional<ReportFormat> report_format(std::string_view name);

/// The findings of one scene, sorted; their spans may lie in other files of `sources` too.
struct FileReport {
    source::SourceId scene;
    const source::SourceMap* sources = nullptr;
    std::vector<source::Diagnostic> diagnostics;
};

struct Summary {
    std::uint64_t files = 0;
    std::uint64_t errors = 0;
    std::uint64_t warnings = 0;
};

/// "checked 2 scenes: 1 error, 3 warnings"
std::string to_text(const Summary& summary);

struct ReportStyle {
    bool color = false;      ///< human only
    unsigned columns = 100;  ///< human only: longer source lines are cut around the place
};

/// Takes one scene after the other and passes text on as soon as the format allows.
class Reporter {
  public:
    Reporter() = default;
    Reporter(const Reporter&) = delete;
    Reporter& operator=(const Reporter&) = delete;
    virtual ~Reporter() = default;

    virtual void file(const FileReport& report) = 0;
    /// After the last file; gives the totals to the formats that hold them.
    virtual void finish(const Summary& summary) = 0;
};

using Sink = std::function<void(std::string_view)>;

std::unique_ptr<Reporter> make_reporter(ReportFormat format, const ReportStyle& style, Sink sink);

}  // namespace cobble::driver
