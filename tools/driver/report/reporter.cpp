// SPDX-License-Identifier: MIT
#include "tools/driver/report/reporter.hpp"

#include <fmt/core.h>

#include <utility>

#include "tools/driver/report/formats.hpp"

namespace cobble::driver {

std::optional<ReportFormat> report_format(std::string_view name) {
    if (name == "human") return ReportFormat::kHuman;
    if (name == "json") return ReportFormat::kJson;
    if (name == "jsonl") return ReportFormat::kJsonLines;
    if (name == "sarif") return ReportFormat::kSarif;
    if (name == "github") return ReportFormat::kGithub;
    return std::nullopt;
}

std::string to_text(const Summary& summary) {
    const auto count = [](std::uint64_t n, std::string_view noun) {
        return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s");
    };
    return fmt::format("checked {}: {}, {}", count(summary.files, "scene"),
                       count(summary.errors, "error"), count(summary.warnings, "warning"));
}

std::unique_ptr<Reporter> make_reporter(ReportFormat format, const ReportStyle& style, Sink sink) {
    switch (format) {
        case ReportFormat::kHuman:
            return make_human_reporter(style, std::move(sink));
        case ReportFormat::kJson:
            return make_json_reporter(std::move(sink));
        case ReportFormat::kJsonLines:
            return make_json_lines_reporter(std::move(sink));
        case ReportFormat::kSarif:
            return make_sarif_reporter(std::move(sink));
        case ReportFormat::kGithub:
            return make_github_reporter(std::move(sink));
    }
    return nullptr;
}

}  // namespace cobble::driver
