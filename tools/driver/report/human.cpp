// SPDX-License-Identifier: MIT
// `--format human`: place, message, the line with carets under it, notes, other places, fixes.
#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tools/driver/report/formats.hpp"
#include "tools/driver/report/positions.hpp"
#include "tools/driver/text.hpp"

namespace cobble::driver {
namespace {

constexpr unsigned kTabStop = 4;
// Even in a narrow terminal a line shows some of what is around the place.
constexpr unsigned kMinColumns = 40;
// A character takes at most four bytes in UTF-8: that many for each column that can be shown are
// looked at on each side of a place, since lines can be as long as the file.
constexpr std::size_t kBytesPerColumn = 4;
constexpr std::string_view kCut = "...";

struct Paint {
    bool on;
    [[nodiscard]] std::string operator()(std::string_view code, std::string_view text) const {
        return on ? fmt::format("\x1b[{}m{}\x1b[0m", code, text) : std::string(text);
    }
};

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

// One cell of a shown line: what it prints and how many columns it takes.
struct Cell {
    std::string text;
    unsigned width = 1;
    bool marked = false;
};

// The shown cells of the line around [begin, end), tabs opened up to their stops.
std::vector<Cell> cells_of(std::string_view line, std::size_t begin, std::size_t end) {
    std::vector<Cell> cells;
    unsigned column = 0;
    for (std::size_t at = 0; at < line.size();) {
        const CodePoint point = next_code_point(line.substr(at));
        Cell cell;
        if (point.value == '\t') {
            cell.width = kTabStop - column % kTabStop;
            cell.text.assign(cell.width, ' ');
        } else {
            cell.text = printable(line.substr(at, point.bytes));
            cell.width = width_of(point.value);
        }
        cell.marked = at >= begin && at < std::max(end, begin + 1);
        column += cell.width;
        at += point.bytes;
        cells.push_back(std::move(cell));
    }
    // The end of the line is a place too: something is missing there.
    if (begin >= line.size()) cells.push_back({" ", 1, true});
    return cells;
}

// True for the second and later bytes of a character in UTF-8.
bool is_continuation(char byte) { return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80U; }

struct Shown {
    std::string line;
    std::string carets;
};

// At most `columns` columns of the cells, those marked first of all.
Shown fit(const std::vector<Cell>& cells, unsigned columns, bool cut_before, bool cut_after) {
    const auto is_marked = [](const Cell& cell) { return cell.marked; };
    std::size_t first = static_cast<std::size_t>(
        std::find_if(cells.begin(), cells.end(), is_marked) - cells.begin());
    std::size_t last = first;
    unsigned used = 0;
    const auto take = [&](std::size_t i) {
        if (used + cells[i].width > columns) return false;
        used += cells[i].width;
        return true;
    };
    while (last < cells.size() && cells[last].marked && take(last)) ++last;
    // Then what stands before, which tells more than what stands after, then that.
    while (first > 0 && take(first - 1)) --first;
    while (last < cells.size() && take(last)) ++last;
    Shown shown;
    if (cut_before || first > 0) {
        shown.line += kCut;
        shown.carets.append(kCut.size(), ' ');
    }
    for (std::size_t i = first; i < last; ++i) {
        shown.line += cells[i].text;
        shown.carets.append(cells[i].width, cells[i].marked ? '^' : ' ');
    }
    if (cut_after || last < cells.size()) shown.line += kCut;
    shown.line.erase(shown.line.find_last_not_of(' ') + 1);
    shown.carets.erase(shown.carets.find_last_not_of(' ') + 1);
    return shown;
}

class Excerpts {
  public:
    Excerpts(Positions& positions, const ReportStyle& style)
        : positions_(positions),
          columns_(std::max(style.columns, kMinColumns)),
          paint_{style.color} {}

    // "  6 |     angles 30" and the carets below, or nothing for a place without text.
    [[nodiscard]] std::string around(source::Span span, std::string_view caret_color) const {
        const source::LineIndex& lines = positions_.lines(span.source);
        const source::LineColumn place = positions_.start(span);
        const std::string_view line = lines.line_text(place.line);
        if (line.empty() && span.begin == 0 && span.end == 0) return {};
        const std::uint32_t start = lines.offset({place.line, 1});
        std::size_t begin = std::min<std::size_t>(span.begin - start, line.size());
        std::size_t end = std::min<std::size_t>(span.end - start, line.size());
        const std::string number = std::to_string(place.line);
        const auto room =
            columns_ - std::min<unsigned>(columns_ / 2, static_cast<unsigned>(number.size()) + 11);
        const std::size_t reach = kBytesPerColumn * room;
        std::size_t from = begin > reach ? begin - reach : 0;
        while (from > 0 && from < begin && is_continuation(line[from])) ++from;
        const std::string_view window = line.substr(from, std::min(end - from, 2 * reach) + reach);
        const bool cut_after = from + window.size() < line.size();
        begin -= from;
        end -= from;
        const Shown shown = fit(cells_of(window, begin, end), room, from > 0, cut_after);
        const std::string gutter(number.size(), ' ');
        return fmt::format("  {} {}\n  {} {}\n", paint_(kBlue, number + " |"), shown.line,
                           paint_(kBlue, gutter + " |"), paint_(caret_color, shown.carets));
    }

  private:
    Positions& positions_;
    unsigned columns_;
    Paint paint_;
};

std::string write(const source::Diagnostic& diagnostic, std::string_view path_without_span,
                  Positions& positions, const ReportStyle& style) {
    const Paint paint{style.color};
    const Excerpts excerpts(positions, style);
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
    if (diagnostic.span.valid()) text += excerpts.around(diagnostic.span, color);
    for (const std::string& note : diagnostic.notes) {
        text += fmt::format("  {} {}\n", paint(kBold, "note:"), printable(note));
    }
    for (const source::Related& place : diagnostic.related) {
        text += fmt::format("  {}: {} {}\n", where(place.span), paint(kBold, "note:"),
                            printable(place.message));
        if (place.span.valid()) text += excerpts.around(place.span, kBlue);
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
