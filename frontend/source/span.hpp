// SPDX-License-Identifier: MIT
// Places in source files.
//
// Every phase speaks of places as byte offsets; lines and columns are computed at the edge, once,
// from a line index (see line_index.hpp).
#pragma once

#include <cstdint>

namespace cobble::source {

/// Index of a file in a SourceMap: a scene, a mesh or an image.
struct SourceId {
    std::uint32_t value = kNone;

    static constexpr std::uint32_t kNone = 0xffffffffU;
    [[nodiscard]] constexpr bool valid() const { return value != kNone; }
    friend constexpr bool operator==(SourceId, SourceId) = default;
};

/// The bytes [begin, end) of one source. Trees store offsets only; a span is made where a place
/// leaves its tree. Offset 0 stands for the whole of a binary source (an image).
struct Span {
    SourceId source;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;

    [[nodiscard]] constexpr bool valid() const { return source.valid(); }
    friend constexpr bool operator==(Span, Span) = default;
};

}  // namespace cobble::source
