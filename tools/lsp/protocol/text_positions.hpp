// SPDX-License-Identifier: MIT
// The protocol's positions (line and character from 0, characters in the units that client and
// server agreed on) as byte offsets, and back.
#pragma once

#include <cstdint>
#include <string_view>

#include "frontend/source/line_index.hpp"
#include "tools/lsp/protocol/rpc.hpp"

namespace cobble::lsp {

enum class PositionEncoding : unsigned char { kUtf8, kUtf16, kUtf32 };

/// "utf-8", "utf-16", "utf-32".
std::string_view name_of(PositionEncoding encoding);

/// The best of those that the client offers (`general.positionEncodings`): UTF-8 costs nothing;
/// UTF-16, which each client must know, if it offers none.
PositionEncoding choose_encoding(const Json& capabilities);

/// Bytes [begin, end).
struct Bytes {
    std::uint32_t begin = 0, end = 0;
};

/// Of one text, which must outlive it. Lines and characters past an end are taken for that end, as
/// the protocol wants it.
class TextPositions {
  public:
    TextPositions(std::string_view text, PositionEncoding encoding)
        : lines_(text), encoding_(encoding) {}

    /// Throws Json::exception if it is no position.
    [[nodiscard]] std::uint32_t offset(const Json& position) const;
    /// A range that ends before it begins is the empty one at its beginning.
    [[nodiscard]] Bytes bytes(const Json& range) const;
    [[nodiscard]] Json position(std::uint32_t offset) const;
    [[nodiscard]] Json range(std::uint32_t begin, std::uint32_t end) const;
    [[nodiscard]] const source::LineIndex& lines() const { return lines_; }

  private:
    source::LineIndex lines_;
    PositionEncoding encoding_;
};

}  // namespace cobble::lsp
