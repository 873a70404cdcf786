// SPDX-License-Identifier: MIT
#include "tools/driver/report/excerpt.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>
#include <vector>

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
constexpr std::string_view kBlue = "34";

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

}  // namespace

std::string painted(std::string_view color, std::string_view text, const ReportStyle& style) {
    return style.color ? fmt::format("\x1b[{}m{}\x1b[0m", color, text) : std::string(text);
}

std::string excerpt_of(source::Span span, Positions& positions, const ReportStyle& style,
                       std::string_view caret_color) {
    const unsigned columns = std::max(style.columns, kMinColumns);
    const source::LineIndex& lines = positions.lines(span.source);
    const source::LineColumn place = positions.start(span);
    const std::string_view line = lines.line_text(place.line);
    if (line.empty() && span.begin == 0 && span.end == 0) return {};
    const std::uint32_t start = lines.offset({place.line, 1});
    std::size_t begin = std::min<std::size_t>(span.begin - start, line.size());
    std::size_t end = std::min<std::size_t>(span.end - start, line.size());
    const std::string number = std::to_string(place.line);
    const auto room =
        columns - std::min<unsigned>(columns / 2, static_cast<unsigned>(number.size()) + 11);
    const std::size_t reach = kBytesPerColumn * room;
    std::size_t from = begin > reach ? begin - reach : 0;
    while (from > 0 && from < begin && is_continuation(line[from])) ++from;
    const std::string_view window = line.substr(from, std::min(end - from, 2 * reach) + reach);
    const bool cut_after = from + window.size() < line.size();
    begin -= from;
    end -= from;
    const Shown shown = fit(cells_of(window, begin, end), room, from > 0, cut_after);
    const std::string gutter(number.size(), ' ');
    return fmt::format("  {} {}\n  {} {}\n", painted(kBlue, number + " |", style), shown.line,
                       painted(kBlue, gutter + " |", style),
                       painted(caret_color, shown.carets, style));
}

}  // namespace cobble::driver
