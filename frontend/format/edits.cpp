// SPDX-License-Identifier: MIT
#include "frontend/format/edits.hpp"

#include <algorithm>
#include <utility>

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

}  // namespace cobble::frontend
