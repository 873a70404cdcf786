// SPDX-License-Identifier: MIT
// Offsets to lines and columns and back, in the three units that clients count in.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace cobble::source {

enum class ColumnUnit : unsigned char { kByte, kCodePoint, kUtf16 };

/// A place for people: both numbers are 1-based. A tab is one column. A byte-order mark is no
/// column. Bytes that are not valid UTF-8 count one code point each.
struct LineColumn {
    std::uint32_t line = 1;
    std::uint32_t column = 1;
    friend constexpr bool operator==(LineColumn, LineColumn) = default;
};

/// Line starts of one text. Lines end at LF, CRLF or lone CR. Building reads the text once or twice
/// and keeps 4 bytes a line, and 12 bytes for every 4096 of a text that is not all ASCII. A look-up
/// costs a binary search and at most 4096 bytes, however long the line is.
class LineIndex {
  public:
    explicit LineIndex(std::string_view text);

    /// `offset` may be the text's size; larger ones are clamped.
    [[nodiscard]] LineColumn locate(std::uint32_t offset,
                                    ColumnUnit unit = ColumnUnit::kCodePoint) const;

    /// The byte offset of a place; a column past the line's end gives the end of the line.
    [[nodiscard]] std::uint32_t offset(LineColumn place,
                                       ColumnUnit unit = ColumnUnit::kCodePoint) const;

    /// The text of a 1-based line without its line end.
    [[nodiscard]] std::string_view line_text(std::uint32_t line) const;

    [[nodiscard]] std::uint32_t line_count() const {
        return static_cast<std::uint32_t>(starts_.size());
    }

  private:
    /// How many code points and UTF-16 units stand before a place where a code point begins.
    struct Count {
        std::uint32_t offset = 0;
        std::uint32_t code_points = 0;
        std::uint32_t utf16 = 0;
    };

    void find_lines();
    void find_counts();
    /// The last count at or before an offset, or before a number of columns from the text's start.
    [[nodiscard]] Count count_before(std::uint32_t offset) const;
    /// Columns from the beginning of the text to `offset`, which rounds down to a code point.
    [[nodiscard]] std::uint32_t columns_before(std::uint32_t offset, ColumnUnit unit) const;

    std::string_view text_;
    std::vector<std::uint32_t> starts_;
    std::vector<Count> counts_;  ///< one for every 4096 bytes; empty for a text that is all ASCII
};

}  // namespace cobble::source
