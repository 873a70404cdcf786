// SPDX-License-Identifier: MIT
#include "frontend/format/edits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "frontend/format/writer.hpp"

namespace cobble::frontend {
namespace {

/// One line, its end included, and how much of the text stands before it.
struct Line {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::uint32_t solid_before = 0;  ///< bytes before it that are not white space
};

struct Lines {
    std::vector<Line> lines;
    std::uint32_t solid = 0;  ///< bytes in the text that are not white space
};

Lines split(std::string_view text) {
    Lines result;
    const auto size = static_cast<std::uint32_t>(text.size());
    std::uint32_t i = 0;
    while (i < size) {
        Line line{i, i, result.solid};
        while (i < size && !is_line_end(text[i])) {
            if (!is_blank(text[i])) ++result.solid;
            ++i;
        }
        if (i < size) i += text.substr(i, 2) == "\r\n" ? 2 : 1;
        line.end = i;
        result.lines.push_back(line);
    }
    return result;
}

bool same_solid_text(std::string_view a, std::string_view b) {
    const auto is_white = [](char c) { return is_blank(c) || is_line_end(c); };
    auto i = a.begin();
    auto j = b.begin();
    for (;;) {
        i = std::find_if_not(i, a.end(), is_white);
        j = std::find_if_not(j, b.end(), is_white);
        if (i == a.end() || j == b.end()) return i == a.end() && j == b.end();
        if (*i != *j) return false;
        ++i;
        ++j;
    }
}

class Differ {
  public:
    Differ(std::string_view before, std::string_view after)
        : before_(before), after_(after), old_(split(before)), new_(split(after)) {}

    std::vector<LineEdit> run() {
        if (same_solid_text(before_, after_)) {
            walk();
        } else {
            trim_ends();
        }
        return std::move(edits_);
    }

  private:
    [[nodiscard]] bool equal(std::size_t o, std::size_t n) const {
        const Line& a = old_.lines[o];
        const Line& b = new_.lines[n];
        return before_.substr(a.begin, a.end - a.begin) == after_.substr(b.begin, b.end - b.begin);
    }

    /// Lines match only where the same text stands before them; else the one that lags moves on.
    void walk() {
        std::size_t o = 0;
        std::size_t n = 0;
        std::size_t old_begin = 0;
        std::size_t new_begin = 0;
        while (o < old_.lines.size() && n < new_.lines.size()) {
            const std::uint32_t old_solid = old_.lines[o].solid_before;
            const std::uint32_t new_solid = new_.lines[n].solid_before;
            if (old_solid == new_solid && equal(o, n)) {
                add(old_begin, o, new_begin, n);
                old_begin = ++o;
                new_begin = ++n;
                continue;
            }
            // Where both stand at the same place the shorter line moves, so that a blank line or
            // the first part of a line that was joined goes before what follows it.
            const std::uint32_t old_after = solid_after(old_, o);
            const std::uint32_t new_after = solid_after(new_, n);
            if (old_after <= new_after) ++o;
            if (new_after <= old_after) ++n;
        }
        add(old_begin, old_.lines.size(), new_begin, new_.lines.size());
    }

    static std::uint32_t solid_after(const Lines& text, std::size_t line) {
        return line + 1 < text.lines.size() ? text.lines[line + 1].solid_before : text.solid;
    }

    void trim_ends() {
        std::size_t old_end = old_.lines.size();
        std::size_t new_end = new_.lines.size();
        std::size_t begin = 0;
        while (begin < old_end && begin < new_end && equal(begin, begin)) ++begin;
        while (old_end > begin && new_end > begin && equal(old_end - 1, new_end - 1)) {
            --old_end;
            --new_end;
        }
        add(begin, old_end, begin, new_end);
    }

    void add(std::size_t old_begin, std::size_t old_end, std::size_t new_begin,
             std::size_t new_end) {
        if (old_begin == old_end && new_begin == new_end) return;
        edits_.push_back(
            {static_cast<std::uint32_t>(old_begin), static_cast<std::uint32_t>(old_end - old_begin),
             static_cast<std::uint32_t>(new_begin), static_cast<std::uint32_t>(new_end - new_begin),
             bytes(old_, before_, old_begin, old_end), bytes(new_, after_, new_begin, new_end)});
    }

    static ByteRange bytes(const Lines& lines, std::string_view text, std::size_t begin,
                           std::size_t end) {
        const auto size = static_cast<std::uint32_t>(text.size());
        const std::uint32_t first = begin < lines.lines.size() ? lines.lines[begin].begin : size;
        return {first, begin == end ? first : lines.lines[end - 1].end};
    }

    std::string_view before_;
    std::string_view after_;
    Lines old_;
    Lines new_;
    std::vector<LineEdit> edits_;
};

constexpr std::uint32_t kContext = 3;  // what diff -u shows

/// "12,3", or "12" for one line; an empty range names the line before it.
std::string hunk_range(std::uint32_t first, std::uint32_t count) {
    if (count == 1) return fmt::format("{}", first + 1);
    return fmt::format("{},{}", count == 0 ? first : first + 1, count);
}

void put_line(std::string& out, char mark, std::string_view line) {
    out.push_back(mark);
    out.append(line);
    if (line.empty() || !is_line_end(line.back())) {
        out.append("\n\\ No newline at end of file\n");
    } else if (line.back() == '\r') {
        out.push_back('\n');
    }
}

}  // namespace

std::vector<LineEdit> line_edits(std::string_view before, std::string_view after) {
    return Differ(before, after).run();
}

std::string apply(std::string_view before, std::string_view after,
                  const std::vector<LineEdit>& edits) {
    std::string result;
    result.reserve(after.size());
    std::size_t at = 0;
    for (const LineEdit& edit : edits) {
        result.append(before.substr(at, edit.old_bytes.begin - at));
        result.append(
            after.substr(edit.new_bytes.begin, edit.new_bytes.end - edit.new_bytes.begin));
        at = edit.old_bytes.end;
    }
    result.append(before.substr(at));
    return result;
}

std::string unified_diff(std::string_view before, std::string_view after,
                         std::string_view before_name, std::string_view after_name) {
    const std::vector<LineEdit> edits = line_edits(before, after);
    if (edits.empty()) return {};
    const std::vector<Line> old_lines = split(before).lines;
    const std::vector<Line> new_lines = split(after).lines;
    const auto old_line = [&](std::uint32_t i) {
        return before.substr(old_lines[i].begin, old_lines[i].end - old_lines[i].begin);
    };
    const auto new_line = [&](std::uint32_t i) {
        return after.substr(new_lines[i].begin, new_lines[i].end - new_lines[i].begin);
    };
    const auto old_size = static_cast<std::uint32_t>(old_lines.size());

    std::string out = fmt::format("--- {}\n+++ {}\n", before_name, after_name);
    for (std::size_t first = 0; first < edits.size();) {
        // Edits whose context would touch stand in one hunk.
        std::size_t last = first;
        while (last + 1 < edits.size() &&
               edits[last + 1].old_line - (edits[last].old_line + edits[last].old_count) <=
                   2 * kContext) {
            ++last;
        }
        const std::uint32_t lead = std::min(edits[first].old_line, kContext);
        const std::uint32_t old_begin = edits[first].old_line - lead;
        const std::uint32_t old_end =
            std::min(edits[last].old_line + edits[last].old_count + kContext, old_size);
        const std::uint32_t new_begin = edits[first].new_line - lead;
        const std::uint32_t tail = old_end - (edits[last].old_line + edits[last].old_count);
        const std::uint32_t new_end = edits[last].new_line + edits[last].new_count + tail;
        fmt::format_to(std::back_inserter(out), "@@ -{} +{} @@\n",
                       hunk_range(old_begin, old_end - old_begin),
                       hunk_range(new_begin, new_end - new_begin));
        std::uint32_t line = old_begin;
        for (std::size_t i = first; i <= last; ++i) {
            const LineEdit& edit = edits[i];
            for (; line < edit.old_line; ++line) put_line(out, ' ', old_line(line));
            for (; line < edit.old_line + edit.old_count; ++line) {
                put_line(out, '-', old_line(line));
            }
            for (std::uint32_t n = 0; n < edit.new_count; ++n) {
                put_line(out, '+', new_line(edit.new_line + n));
            }
        }
        for (; line < old_end; ++line) put_line(out, ' ', old_line(line));
        first = last + 1;
    }
    return out;
}

}  // namespace cobble::frontend
