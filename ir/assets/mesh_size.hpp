// SPDX-License-Identifier: MIT
// What a mesh will take once it is read, for a limit that is checked before.
#pragma once

#include <cstdint>
#include <string_view>

#include "ir/assets/obj/obj_file.hpp"

namespace cobble::ir {

/// No OBJ file becomes more than this many times its text: each further corner of a polygon is two
/// bytes of text and one triangle.
inline constexpr std::uint64_t kMostBytesPerTextByte =
    (sizeof(Mesh::Face) + sizeof(std::uint32_t)) / 2;

/// An upper bound on bytes_of(read_obj(text, ...)) by any rules: counts the lines that begin with
/// `v` and `f` and the corners. Cost: one pass, a fraction of reading.
std::uint64_t obj_bytes_at_most(std::string_view text);

/// The bytes of the vertices, faces and offsets.
std::uint64_t bytes_of(const ObjFile& file);

}  // namespace cobble::ir
