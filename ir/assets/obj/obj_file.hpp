// SPDX-License-Identifier: MIT
// Wavefront OBJ text as flat arrays. Input: the bytes of one file. Output: vertices, faces cut into
// triangles, and what is wrong, each with its bytes. Invariant: never fails; every index of every
// face that is kept is in range, every number is finite, in single precision too.
//
// Read: `v` (3 numbers; a weight and a colour after them are ignored), `vt` (1 to 3 numbers; the
// third is ignored), `vn`, `f` with corners a, a/t, a//n, a/t/n, negative indices (counted back
// from the last vertex so far), polygons (cut into a fan around their first corner), comments,
// lines continued by a backslash, LF, CRLF and CR line ends, a last line without a line end.
// Every other keyword of the format is passed over in silence, a word that is none with a remark.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "frontend/source/diagnostic.hpp"
#include "ir/math/vec.hpp"
#include "ir/scene/assets.hpp"

namespace cobble::ir {

/// What is wrong at the bytes [begin, end) of the file.
struct ObjProblem {
    const source::DiagnosticCode* code = nullptr;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::string message;
};

struct ObjFile {
    std::vector<math::Vec3d> positions;
    std::vector<math::Vec2d> uvs;
    std::vector<math::Vec3d> normals;         ///< as written, any length
    std::vector<Mesh::Face> faces;            ///< faces with an error are left out
    std::vector<std::uint32_t> face_offsets;  ///< byte where the line of each face begins
    std::vector<ObjProblem> problems;         ///< the first kMaxObjProblems, in order of bytes
    std::uint64_t problem_count = 0;          ///< all of them
    /// Lines that begin with no keyword of the format: the first one of each word, and of
    /// kMaxObjRemarks words at most. They leave the mesh as it is. Empty under kPublished.
    std::vector<ObjProblem> remarks;
    bool more_remarks = false;  ///< there were other such words
};

/// More than these are counted, not listed: one cause tends to break every line of a file.
inline constexpr std::size_t kMaxObjProblems = 20;
/// A file that begins its lines with more unknown words than these is no mesh.
inline constexpr std::size_t kMaxObjRemarks = 5;

/// How the file is understood.
enum class ObjRules : std::uint8_t {
    kStandard,
    /// As the course's programs read: only lines of at least three bytes that end in LF; only `v`,
    /// `vt` and `f`; three corners a face; slashes are blanks, after which corners are pairs of
    /// vertex and texture coordinate; no negative indices; if the file has texture coordinates,
    /// corners without one take the first.
    kPublished,
};

/// Reads a file of less than 4 GiB. `max_faces` counts triangles: at the first one more, reading
/// stops with a problem. Cost: one pass; memory at most some 40 times the size of the text.
ObjFile read_obj(const std::string& text, ObjRules rules, std::uint64_t max_faces);

}  // namespace cobble::ir
