// SPDX-License-Identifier: MIT
#include "tools/lsp/protocol/text_positions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cobble::lsp {
namespace {

source::ColumnUnit unit_of(PositionEncoding encoding) {
    switch (encoding) {
        case PositionEncoding::kUtf8:
            return source::ColumnUnit::kByte;
        case PositionEncoding::kUtf16:
            return source::ColumnUnit::kUtf16;
        case PositionEncoding::kUtf32:
            break;
    }
    return source::ColumnUnit::kCodePoint;
}

/// A number from 0, one more, and no more than there is; clients send 2^31 for "to the end".
std::uint32_t one_more(const Json& number) {
    constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max() - 1;
    if (number.is_number_unsigned()) {
        return static_cast<std::uint32_t>(
                   std::min<std::uint64_t>(number.get<std::uint64_t>(), kMost)) +
               1;
    }
    const auto value = number.get<double>();
    if (!(value > 0)) return 1;
    return value >= kMost ? kMost : static_cast<std::uint32_t>(value) + 1;
}

}  // namespace

std::string_view name_of(PositionEncoding encoding) {
    switch (encoding) {
        case PositionEncoding::kUtf8:
            return "utf-8";
        case PositionEncoding::kUtf16:
            return "utf-16";
        case PositionEncoding::kUtf32:
            break;
    }
    return "utf-32";
}

PositionEncoding choose_encoding(const Json& capabilities) {
    const auto general = capabilities.find("general");
    if (general == capabilities.end() || !general->is_object()) return PositionEncoding::kUtf16;
    const auto offered = general->find("positionEncodings");
    if (offered == general->end() || !offered->is_array()) return PositionEncoding::kUtf16;
    for (const PositionEncoding encoding :
         {PositionEncoding::kUtf8, PositionEncoding::kUtf32, PositionEncoding::kUtf16}) {
        for (const Json& name : *offered) {
            if (name.is_string() && name.get_ref<const std::string&>() == name_of(encoding)) {
                return encoding;
            }
        }
    }
    return PositionEncoding::kUtf16;
}

std::uint32_t TextPositions::offset(const Json& position) const {
    const std::uint32_t line = one_more(position.at("line"));
    const std::uint32_t last = lines_.line_count();
    if (line > last) return lines_.offset({last, std::numeric_limits<std::uint32_t>::max()});
    return lines_.offset({line, one_more(position.at("character"))}, unit_of(encoding_));
}

Bytes TextPositions::bytes(const Json& range) const {
    const std::uint32_t begin = offset(range.at("start"));
    return {begin, std::max(begin, offset(range.at("end")))};
}

Json TextPositions::position(std::uint32_t offset) const {
    const source::LineColumn place = lines_.locate(offset, unit_of(encoding_));
    return {{"line", place.line - 1}, {"character", place.column - 1}};
}

Json TextPositions::range(std::uint32_t begin, std::uint32_t end) const {
    return {{"start", position(begin)}, {"end", position(end)}};
}

}  // namespace cobble::lsp
