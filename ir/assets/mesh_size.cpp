// SPDX-License-Identifier: MIT
#include "ir/assets/mesh_size.hpp"

namespace cobble::ir {
namespace {

constexpr std::uint64_t kFaceBytes = sizeof(Mesh::Face) + sizeof(std::uint32_t);

bool is_line_end(char c) { return c == '\n' || c == '\r'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\\'; }

}  // namespace

std::uint64_t obj_bytes_at_most(std::string_view text) {
    std::uint64_t bytes = 0;
    std::uint64_t words = 0;  // of the face in hand, its `f` too
    bool in_face = false;
    bool line_start = true;
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (is_line_end(c)) {
            // A backslash continues the line by one set of rules and not by the other: corners that
            // follow belong to the face, and so do statements begin.
            in_face = in_face && i > 0 && (text[i - 1] == '\\' || text[i - 1] == '\r');
            line_start = true;
            ++i;
            continue;
        }
        if (is_blank(c)) {
            ++i;
            continue;
        }
        if (line_start && c == 'v') {
            bytes += sizeof(math::Vec3d);
            in_face = false;
        } else if (line_start && c == 'f') {
            bytes += kFaceBytes;
            in_face = true;
            words = 0;
        }
        // The first triangle has been counted with its `f` and takes three corners.
        if (in_face && ++words > 4) bytes += kFaceBytes;
        line_start = false;
        while (i < text.size() && !is_blank(text[i]) && !is_line_end(text[i])) ++i;
    }
    return bytes;
}

std::uint64_t bytes_of(const ObjFile& file) {
    return file.positions.size() * sizeof(math::Vec3d) + file.uvs.size() * sizeof(math::Vec2d) +
           file.normals.size() * sizeof(math::Vec3d) + file.faces.size() * sizeof(Mesh::Face) +
           file.face_offsets.size() * sizeof(std::uint32_t);
}

}  // namespace cobble::ir
