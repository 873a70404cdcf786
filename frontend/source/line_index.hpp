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

/// Line starts of one text. Lines end at LF, CRLF or lone CR. Building reads the text once;
/// a look-up costs a binary search and the length of one line (constant for ASCII-only text
/// before the column).
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
    std::string_view text_;
    std::vector<std::uint32_t> starts_;
};

}  // namespace cobble::source
