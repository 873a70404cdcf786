// SPDX-License-Identifier: MIT
#include "frontend/format/writer.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace cobble::frontend {
namespace {

constexpr std::size_t kIndentWidth = 4;

constexpr auto kSpaces = [] {
    std::array<char, kIndentWidth * kMaxIndentLevels> spaces{};
    spaces.fill(' ');
    return spaces;
}();

/// Appends to a string that is made long enough beforehand: a formatted file is hardly longer than
/// its source, and appending piece by piece took half the formatter's time.
class StringSink {
  public:
    StringSink(std::string& out, std::size_t expected) : out_(&out), size_(out.size()) {
        out.resize(size_ + expected);
    }
    void put(std::string_view bytes) {
        if (out_->size() - size_ < bytes.size()) out_->resize(2 * out_->size() + bytes.size());
        std::memcpy(out_->data() + size_, bytes.data(), bytes.size());
        size_ += bytes.size();
    }
    void put(char c) { put(std::string_view(&c, 1)); }
    /// Copies all of kSpaces and counts some: a copy of constant size is a few instructions.
    void put_spaces(std::size_t count) {
        if (out_->size() - size_ < kSpaces.size()) out_->resize(2 * out_->size() + kSpaces.size());
        std::memcpy(out_->data() + size_, kSpaces.data(), kSpaces.size());
        size_ += count;
    }
    bool finish() {
        out_->resize(size_);
        return true;
    }

  private:
    std::string* out_;
    std::size_t size_;  ///< what is written; the rest of the string is room
};

class CompareSink {
  public:
    explicit CompareSink(std::string_view expected) : rest_(expected) {}
    void put(std::string_view bytes) {
        if (!rest_.starts_with(bytes)) {
            equal_ = false;
        } else {
            rest_.remove_prefix(bytes.size());
        }
    }
    void put(char c) { put(std::string_view(&c, 1)); }
    void put_spaces(std::size_t count) { put(std::string_view(kSpaces.data(), count)); }
    [[nodiscard]] bool finish() const { return equal_ && rest_.empty(); }

  private:
    std::string_view rest_;
    bool equal_ = true;
};

/// Line ends in white space: LF, CRLF and lone CR count one each.
std::uint32_t count_lines(std::string_view blanks) {
    std::uint32_t lines = 0;
    for (std::size_t i = 0; i < blanks.size(); ++i) {
        if (blanks[i] == '\n' || (blanks[i] == '\r' && blanks.substr(i + 1, 1) != "\n")) ++lines;
    }
    return lines;
}

/// The blanks after the last line end.
std::string_view own_indent(std::string_view blanks) {
    const std::size_t end = blanks.find_last_of("\r\n");
    return end == std::string_view::npos ? blanks : blanks.substr(end + 1);
}

std::string_view trim_end(std::string_view comment) {
    while (!comment.empty() && is_blank(comment.back())) comment.remove_suffix(1);
    return comment;
}

template <typename Sink>
class Writer {
  public:
    Writer(const Tokens& tokens, const Layout& layout, const WriteOptions& options, Sink sink)
        : tokens_(tokens),
          layout_(layout),
          options_(options),
          whole_file_(options.first_line <= 1 && options.last_line == UINT32_MAX),
          sink_(sink) {}

    WriteResult run() {
        if (tokens_.text.starts_with(kByteOrderMark)) take_verbatim(kByteOrderMark.size());
        find_line_end();
        const std::uint32_t count = tokens_.size();
        for (std::uint32_t i = 0; i < count; ++i) {
            const ByteRange token{tokens_.tokens[i].begin, end_of(tokens_, i)};
            const Gap& gap = layout_.gaps[i];
            if (at_comment(token.begin) || !whole_file_ || off_ || ends_line_) {
                slow_gap(gap, token);
            } else {
                fast_gap(gap, token);
            }
            sink_.put(tokens_.text.substr(token.begin, token.end - token.begin));
            position_ = token.end;
            ends_line_ = tokens_.kind({i}) == TokenKind::kUnterminatedString;
            at_start_ = false;
        }
        return {lines_added_, sink_.finish()};
    }

  private:
    [[nodiscard]] bool at_comment(std::uint32_t before) const {
        return comment_ < tokens_.comments.size() && tokens_.comments[comment_].begin < before;
    }

    /// The line end to write: the first in the file, leading blank lines aside, because those are
    /// not kept and the second run must find the same one.
    void find_line_end() {
        const std::string_view text = tokens_.text;
        std::uint32_t first = tokens_.range({0}).begin;
        if (!tokens_.comments.empty()) first = std::min(first, tokens_.comments[0].begin);
        std::size_t end = text.find_first_of("\r\n", first);
        if (end == std::string_view::npos) end = text.find_first_of("\r\n");
        if (end == std::string_view::npos) return;
        line_end_ = text.substr(end, text.substr(end, 2) == "\r\n" ? 2 : 1);
    }

    void take_verbatim(std::uint64_t end) {
        sink_.put(tokens_.text.substr(position_, end - position_));
        position_ = static_cast<std::uint32_t>(end);
    }

    void indent(std::uint8_t level) { sink_.put_spaces(level * kIndentWidth); }

    void new_line() {
        sink_.put(line_end_);
        ++lines_added_;
    }

    /// A gap without comments, with formatting on, in a whole file: nearly all of them.
    void fast_gap(const Gap& gap, ByteRange token) {
        switch (gap.kind) {
            case GapKind::kSpace:
                sink_.put(' ');
                return;
            case GapKind::kGlue:
                return;
            case GapKind::kVerbatim:
                sink_.put(tokens_.text.substr(position_, token.begin - position_));
                return;
            case GapKind::kLine:
                if (!at_start_) {
                    sink_.put(line_end_);
                    if (gap.blank_first && gap.blank_last && has_blank_line(token.begin)) {
                        sink_.put(line_end_);
                    }
                    indent(gap.level);
                    return;
                }
                [[fallthrough]];
            default:
                bool first = true;
                separate(gap, token.begin, first, /*is_token=*/true);
        }
    }

    /// True if more than one line ends between what is written and `end`.
    [[nodiscard]] bool has_blank_line(std::uint32_t end) const {
        const std::string_view text = tokens_.text;
        // A line end, a gap's width of blanks, and no other line end: what most gaps look like.
        std::uint32_t at = position_;
        while (at < end && !is_line_end(text[at])) ++at;
        if (text.substr(at, 2) == "\r\n") ++at;
        for (++at; at < end; ++at) {
            if (is_line_end(text[at])) return true;
        }
        return false;
    }

    void slow_gap(const Gap& gap, ByteRange token) {
        bool first = true;
        while (at_comment(token.begin)) {
            const ByteRange range = tokens_.comments[comment_];
            ++comment_;
            const std::string_view whole =
                tokens_.text.substr(range.begin, range.end - range.begin);
            const std::string_view comment = trim_end(whole);
            const Switch found = switch_of(comment);
            separate(gap, range.begin, first, /*is_token=*/false);
            const bool verbatim = (off_ && found != Switch::kOn) ||
                                  gap.kind == GapKind::kVerbatim || !in_range(line_);
            sink_.put(verbatim ? whole : comment);
            position_ = range.end;
            ends_line_ = true;
            at_start_ = false;
            if (found != Switch::kNone) off_ = found == Switch::kOff;
        }
        separate(gap, token.begin, first, /*is_token=*/true);
    }

    [[nodiscard]] bool in_range(std::uint64_t line) const {
        return whole_file_ || (line >= options_.first_line && line <= options_.last_line);
    }

    /// Writes what stands between the last thing written and the comment or token at `begin`.
    /// `first` is true while nothing of this gap has begun a line.
    void separate(const Gap& gap, std::uint32_t begin, bool& first, bool is_token) {
        const std::string_view blanks = tokens_.text.substr(position_, begin - position_);
        const std::uint32_t lines = count_lines(blanks);
        const std::uint64_t line_before = line_;
        line_ += lines;
        if (off_ || gap.kind == GapKind::kVerbatim || mark_would_move(begin) ||
            (!in_range(line_before) && !in_range(line_))) {
            sink_.put(blanks);
            if (lines > 0) first = false;
            return;
        }
        if (!in_range(line_)) {
            // The line of what follows is not ours; the end of the last line is.
            sink_.put(blanks.substr(blanks.find_first_of("\r\n")));
            return;
        }
        lines_added_ -= lines;
        const bool begins_line =
            at_start_ || (is_token ? token_begins_line(gap, lines) : lines > 0);
        if (!begins_line && in_range(line_before)) {
            if (is_token && gap.kind == GapKind::kStrayIndent) {
                sink_.put(blanks);
            } else if (!is_token || gap.kind != GapKind::kGlue) {
                sink_.put(' ');
            }
            return;
        }
        const bool may_blank = (first ? gap.blank_first : is_token || gap.blank_between) &&
                               (!is_token || gap.blank_last);
        first = false;
        if (!in_range(line_before)) {
            keep_lines_before_range(blanks, line_before, may_blank);
        } else if (!at_start_) {
            new_line();
            if (may_blank && lines > 1) new_line();
        }
        if (is_token && keeps_indent(gap, lines)) {
            sink_.put(own_indent(blanks));
        } else {
            indent(is_token ? gap.level : gap.comment_level);
        }
    }

    /// A byte-order mark is one only at the very start: bytes like it stay away from there.
    [[nodiscard]] bool mark_would_move(std::uint32_t begin) const {
        return at_start_ && position_ == 0 && begin > 0 &&
               tokens_.text.substr(begin).starts_with(kByteOrderMark);
    }

    [[nodiscard]] bool token_begins_line(const Gap& gap, std::uint32_t lines) const {
        if (ends_line_) return true;
        switch (gap.kind) {
            case GapKind::kGlue:
            case GapKind::kSpace:
                return false;
            case GapKind::kStrayIndent:
                return lines > 0;
            default:
                return true;
        }
    }

    [[nodiscard]] bool keeps_indent(const Gap& gap, std::uint32_t lines) const {
        const bool broken = gap.kind == GapKind::kOwnIndent || gap.kind == GapKind::kStrayIndent;
        return broken && (lines > 0 || at_start_);
    }

    /// What stands before the first line of the range stays; from there on at most one blank line.
    void keep_lines_before_range(std::string_view blanks, std::uint64_t line_before,
                                 bool may_blank) {
        std::size_t end = 0;
        std::uint64_t line = line_before;
        while (line < options_.first_line) {
            end = blanks.find_first_of("\r\n", end);
            end += blanks.substr(end, 2) == "\r\n" ? 2 : 1;
            ++line;
            ++lines_added_;
        }
        sink_.put(blanks.substr(0, end));
        const bool blank_already = line > line_before + 1;
        if (!may_blank || blank_already || line_ == line) return;
        // A lone CR and our LF would be one line end.
        const bool would_join = blanks.substr(0, end).ends_with('\r') && line_end_ == "\n";
        sink_.put(would_join ? "\r" : line_end_);
        ++lines_added_;
    }

    const Tokens& tokens_;
    const Layout& layout_;
    WriteOptions options_;
    bool whole_file_;
    Sink sink_;
    std::string_view line_end_ = "\n";
    std::uint32_t position_ = 0;  ///< in the source: up to here everything is written
    std::size_t comment_ = 0;     ///< the next one
    std::uint64_t line_ = 1;      ///< of position_; counted only where a range is formatted
    std::int64_t lines_added_ = 0;
    bool off_ = false;
    bool ends_line_ = false;  ///< what was written last goes on to the end of its line
    bool at_start_ = true;    ///< nothing but a byte-order mark is written
};

}  // namespace

Switch switch_of(std::string_view comment) {
    constexpr std::string_view kName = "cobble-format";
    const auto skip_blanks = [&comment] {
        while (!comment.empty() && is_blank(comment.front())) comment.remove_prefix(1);
    };
    if (!comment.starts_with("//")) return Switch::kNone;
    comment = trim_end(comment.substr(2));
    skip_blanks();
    if (!comment.starts_with(kName)) return Switch::kNone;
    comment.remove_prefix(kName.size());
    if (comment.empty() || !is_blank(comment.front())) return Switch::kNone;
    skip_blanks();
    if (comment == "off") return Switch::kOff;
    return comment == "on" ? Switch::kOn : Switch::kNone;
}

WriteResult write(const Tokens& tokens, const Layout& layout, const WriteOptions& options,
                  std::string& out) {
    return Writer(tokens, layout, options,
                  StringSink(out, tokens.text.size() + tokens.text.size() / 8))
        .run();
}

WriteResult compare(const Tokens& tokens, const Layout& layout, const WriteOptions& options,
                    std::string_view expected) {
    return Writer(tokens, layout, options, CompareSink(expected)).run();
}

}  // namespace cobble::frontend
