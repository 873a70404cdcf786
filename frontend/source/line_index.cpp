// SPDX-License-Identifier: MIT
#include "frontend/source/line_index.hpp"

#include <algorithm>
#include <cstring>

#include "frontend/source/utf8.hpp"

namespace cobble::source {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// Bytes that a code point takes; a byte that starts none counts as one of its own.
std::size_t sequence_length(std::string_view text) {
    return std::max<std::size_t>(utf8_length(text), 1);
}

std::uint32_t width_of(std::size_t sequence, ColumnUnit unit) {
    if (unit == ColumnUnit::kByte) return static_cast<std::uint32_t>(sequence);
    return unit == ColumnUnit::kUtf16 && sequence == 4 ? 2 : 1;
}

}  // namespace

LineIndex::LineIndex(std::string_view text) : text_(text) {
    starts_.push_back(text.starts_with(kByteOrderMark) ? 3 : 0);
    // memchr for LF is much faster than a loop over bytes; lone CRs are rare, so look for them
    // apart.
    const bool has_cr = std::memchr(text.data(), '\r', text.size()) != nullptr;
    if (!has_cr) {
        std::size_t at = 0;
        while ((at = text.find('\n', at)) != std::string_view::npos) {
            starts_.push_back(static_cast<std::uint32_t>(++at));
        }
        return;
    }
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool lone_cr = text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n');
        if (text[i] == '\n' || lone_cr) starts_.push_back(static_cast<std::uint32_t>(i + 1));
    }
}

LineColumn LineIndex::locate(std::uint32_t offset, ColumnUnit unit) const {
    offset = std::min(offset, static_cast<std::uint32_t>(text_.size()));
    const auto after = std::upper_bound(starts_.begin() + 1, starts_.end(), offset);
    const auto line = static_cast<std::uint32_t>(after - starts_.begin());
    std::uint32_t column = 1;
    for (std::size_t at = starts_[line - 1]; at < offset;) {
        const std::size_t sequence = sequence_length(text_.substr(at));
        if (at + sequence > offset && unit != ColumnUnit::kByte) break;
        column += width_of(unit == ColumnUnit::kByte ? 1 : sequence, unit);
        at += unit == ColumnUnit::kByte ? 1 : sequence;
    }
    return {line, column};
}

std::string_view LineIndex::line_text(std::uint32_t line) const {
    if (line == 0 || line > starts_.size()) return {};
    const std::size_t begin = starts_[line - 1];
    std::size_t end = line < starts_.size() ? starts_[line] : text_.size();
    while (end > begin && (text_[end - 1] == '\n' || text_[end - 1] == '\r')) --end;
    return text_.substr(begin, end - begin);
}

std::uint32_t LineIndex::offset(LineColumn place, ColumnUnit unit) const {
    if (place.line == 0) return 0;
    if (place.line > starts_.size()) return static_cast<std::uint32_t>(text_.size());
    const std::string_view line = line_text(place.line);
    std::uint32_t column = 1;
    std::size_t at = 0;
    while (at < line.size() && column < place.column) {
        const std::size_t sequence =
            unit == ColumnUnit::kByte ? 1 : sequence_length(line.substr(at));
        column += width_of(sequence, unit);
        at += sequence;
    }
    return static_cast<std::uint32_t>(starts_[place.line - 1] + at);
}

}  // namespace cobble::source
