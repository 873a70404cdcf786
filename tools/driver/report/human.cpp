// SPDX-License-Identifier: MIT
// `--format human`: place, message, the line with carets under it, notes, other places, fixes.
#include <fmt/core.h>

#include <string>
#include <utility>
#include <vector>

#include "tools/driver/report/excerpt.hpp"
#include "tools/driver/report/formats.hpp"
#include "tools/driver/report/positions.hpp"
#include "tools/driver/text.hpp"

namespace cobble::driver {
namespace {

constexpr std::string_view kBold = "1";
constexpr std::string_view kBlue = "34";
constexpr std::string_view kGreen = "32";

std::string_view color_of(source::Severity severity) {
    switch (severity) {
        case source::Severity::kError:
            return "1;31";
        case source::Severity::kWarning:
            return "1;35";
        case source::Severity::kInfo:
            return "1;36";
    }
    return "0";
}

std::string write(const source::Diagnostic& diagnostic, std::string_view path_without_span,
                  Positions& positions, const ReportStyle& style) {
    const auto paint = [&style](std::string_view code, std::string_view text) {
        return painted(code, text, style);
    };
    const auto excerpt = [&positions, &style](source::Span span, std::string_view caret_color) {
        return excerpt_of(span, positions, style, caret_color);
    };
    const auto where = [&positions, path_without_span](source::Span span) {
        if (!span.valid()) return printable(path_without_span);
        const source::LineColumn place = positions.start(span);
        // An image has no lines: its path is all that can be said.
        if (span.begin == span.end && positions.lines(span.source).line_text(1).empty() &&
            positions.lines(span.source).line_count() == 1) {
            return printable(positions.path(span));
        }
        return fmt::format("{}:{}:{}", printable(positions.path(span)), place.line, place.column);
    };
    const std::string_view color = color_of(diagnostic.severity);
    std::string text =
        fmt::format("{}: {}: {} [{}]\n", paint(kBold, where(diagnostic.span)),
                    paint(color, name_of(diagnostic.severity)),
                    paint(kBold, printable(diagnostic.message)), diagnostic.code->code);
    if (diagnostic.span.valid()) text += excerpt(diagnostic.span, color);
    for (const std::string& note : diagnostic.notes) {
        text += fmt::format("  {} {}\n", paint(kBold, "note:"), printable(note));
    }
    for (const source::Related& place : diagnostic.related) {
        text += fmt::format("  {}: {} {}\n", where(place.span), paint(kBold, "note:"),
                            printable(place.message));
        if (place.span.valid()) text += excerpt(place.span, kBlue);
    }
    for (const source::Fix& fix : diagnostic.fixes) {
        text += fmt::format("  {} {}{}\n", paint(kGreen, "fix:"), printable(fix.title),
                            fix.safe ? "" : " (unsafe)");
    }
    return text;
}

class HumanReporter : public Reporter {
  public:
    HumanReporter(const ReportStyle& style, Sink sink) : style_(style), sink_(std::move(sink)) {}

    void file(const FileReport& report) override {
        Positions positions(*report.sources);
        for (const source::Diagnostic& diagnostic : report.diagnostics) {
            sink_(write(diagnostic, report.sources->path(report.scene), positions, style_));
        }
    }

    void finish(const Summary& /*summary*/) override {}

  private:
    ReportStyle style_;
    Sink sink_;
};

}  // namespace

std::string_view name_of(source::Severity severity) {
    switch (severity) {
        case source::Severity::kError:
            return "error";
        case source::Severity::kWarning:
            return "warning";
        case source::Severity::kInfo:
            return "info";
    }
    return "info";
}

std::unique_ptr<Reporter> make_human_reporter(const ReportStyle& style, Sink sink) {
    return std::make_unique<HumanReporter>(style, std::move(sink));
}

}  // namespace cobble::driver
