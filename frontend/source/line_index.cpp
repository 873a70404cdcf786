// SPDX-License-Identifier: MIT
#include "frontend/source/line_index.hpp"

#include <algorithm>

#include "frontend/source/utf8.hpp"

namespace cobble::source {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::uint32_t kBytesPerCount = 4096;

// Bytes that a code point takes; a byte that starts none counts as one of its own.
std::uint32_t sequence_length(std::string_view text) {
    return static_cast<std::uint32_t>(std::max<std::size_t>(utf8_length(text), 1));
}

// Code points beyond the basic plane, which take four bytes, are two units of UTF-16.
constexpr std::uint32_t utf16_units(std::uint32_t length) { return length == 4 ? 2 : 1; }

}  // namespace

LineIndex::LineIndex(std::string_view text) : text_(text) {
    find_lines();
    if (!is_ascii(text)) find_counts();
}

void LineIndex::find_lines() {
    starts_.push_back(text_.starts_with(kByteOrderMark) ? 3 : 0);
    // memchr for LF is much faster than a loop over bytes; CRs are rare, so look for them apart.
    const bool has_cr = text_.find('\r') != std::string_view::npos;
    if (!has_cr) {
        std::size_t at = 0;
        while ((at = text_.find('\n', at)) != std::string_view::npos) {
            starts_.push_back(static_cast<std::uint32_t>(++at));
        }
        return;
    }
    for (std::size_t i = 0; i < text_.size(); ++i) {
        const bool lone_cr = text_[i] == '\r' && (i + 1 == text_.size() || text_[i + 1] != '\n');
        if (text_[i] == '\n' || lone_cr) starts_.push_back(static_cast<std::uint32_t>(i + 1));
    }
}

void LineIndex::find_counts() {
    counts_.reserve(text_.size() / kBytesPerCount + 1);
    Count count;
    while (count.offset < text_.size()) {
        if (count.offset >= counts_.size() * kBytesPerCount) counts_.push_back(count);
        const std::uint32_t length = sequence_length(text_.substr(count.offset));
        count.offset += length;
        count.code_points += 1;
        count.utf16 += utf16_units(length);
    }
}

LineIndex::Count LineIndex::count_before(std::uint32_t offset) const {
    const auto after = std::upper_bound(
        counts_.begin() + 1, counts_.end(), offset,
        [](std::uint32_t wanted, const Count& count) { return wanted < count.offset; });
    return *(after - 1);
}

std::uint32_t LineIndex::columns_before(std::uint32_t offset, ColumnUnit unit) const {
    if (unit == ColumnUnit::kByte || counts_.empty()) return offset;
    Count count = count_before(offset);
    while (count.offset < offset) {
        const std::uint32_t length = sequence_length(text_.substr(count.offset));
        if (count.offset + length > offset) break;
        count.offset += length;
        count.code_points += 1;
        count.utf16 += utf16_units(length);
    }
    return unit == ColumnUnit::kUtf16 ? count.utf16 : count.code_points;
}

LineColumn LineIndex::locate(std::uint32_t offset, ColumnUnit unit) const {
    offset = std::min(offset, static_cast<std::uint32_t>(text_.size()));
    const auto after = std::upper_bound(starts_.begin() + 1, starts_.end(), offset);
    const auto line = static_cast<std::uint32_t>(after - starts_.begin());
    const std::uint32_t start = starts_[line - 1];
    // Only a byte-order mark stands before the first line's start.
    if (offset <= start) return {line, 1};
    return {line, columns_before(offset, unit) - columns_before(start, unit) + 1};
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
    const std::uint32_t start = starts_[place.line - 1];
    const auto end = start + static_cast<std::uint32_t>(line_text(place.line).size());
    const std::uint32_t before = place.column == 0 ? 0 : place.column - 1;
    if (before == 0) return start;
    if (unit == ColumnUnit::kByte || counts_.empty()) {
        return before < end - start ? start + before : end;
    }
    // The first place with that many columns before it, by bisection over bytes.
    const std::uint32_t base = columns_before(start, unit);
    std::uint32_t low = start;
    std::uint32_t high = end;
    while (low < high) {
        const std::uint32_t middle = low + (high - low) / 2;
        if (columns_before(middle, unit) - base < before) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

}  // namespace cobble::source
