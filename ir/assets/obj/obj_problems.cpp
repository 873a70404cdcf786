// SPDX-License-Identifier: MIT
#include "ir/assets/obj/obj_problems.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace cobble::ir {

using source::DiagnosticCode;
using source::Severity;

const DiagnosticCode kObjNumber{
    "asset-mesh-number",
    Severity::kError,
    "a number in a mesh file is malformed",
    "Coordinates are decimal numbers such as `-0.5` or `1e-3`, within what single precision holds "
    "(3.4e38 in either direction). A vertex with anything else, `nan` and `inf` included, has no "
    "place, and a texture coordinate no point of the picture, so the faces that use it are left "
    "out.",
    "v 0 1.2.3 0",
    "Write a decimal number, or export the mesh again."};

const DiagnosticCode kObjStatement{
    "asset-mesh-statement",
    Severity::kError,
    "a line of a mesh file has too few or too many values",
    "`v` takes 3 numbers (up to 7, with a weight or a colour), `vt` 1 to 3, `vn` 3. A vertex with "
    "another count is unusable, so the faces that use it are left out.",
    "v 0 1",
    "Give the vertex its three coordinates."};

const DiagnosticCode kObjFace{
    "asset-mesh-face",
    Severity::kError,
    "a face of a mesh file is malformed",
    "A face has three or more corners, each written `v`, `v/vt`, `v//vn` or `v/vt/vn` with whole "
    "numbers. A face written otherwise is left out.",
    "f 1 2",
    "Give the face its corners, or export the mesh again."};

const DiagnosticCode kObjIndex{
    "asset-mesh-index",
    Severity::kError,
    "a face of a mesh refers to something the file does not have",
    "Indices count the `v`, `vt` and `vn` lines of the file from 1; negative ones count back from "
    "the last such line so far. A face with an index out of range is left out.",
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4",
    "Correct the index, or export the mesh again: the file may be cut short."};

const DiagnosticCode kObjTooManyFaces{
    "asset-mesh-too-many-faces",
    Severity::kError,
    "a mesh has more faces than the limit",
    "Each triangle takes some forty bytes of memory and an index of its own; reading stops at the "
    "limit so that a broken or hostile file cannot exhaust the machine. The mesh is left out.",
    "f 1 2 3   (for the 268435457th time)",
    "Reduce the mesh, or split it into several files."};

const DiagnosticCode kObjKeyword{
    "asset-mesh-keyword",
    Severity::kWarning,
    "a line of a mesh file begins with no keyword of the format",
    "Lines of an OBJ file begin with `v`, `vt`, `vn`, `f` or another keyword of the format. What "
    "the format knows and a picture does not need, such as `g`, `usemtl` or `l`, is passed over "
    "in silence; a word that it does not know may be a slip, and the line is not read. Each word "
    "is reported once.",
    "V 0 0 0",
    "Write the keyword in small letters as the format has it, put a `#` before a remark, or check "
    "that the file is an OBJ file."};

bool is_obj_keyword(std::string_view word) {
    // "Object Files (.obj)", Wavefront Advanced Visualizer manual, appendix B1, with those
    // that it calls superseded.
    static constexpr std::string_view kKeywords[] = {
        "v",        "vt",       "vn",   "vp",         "f",         "p",      "l",      "g",
        "o",        "s",        "mg",   "usemtl",     "mtllib",    "usemap", "maplib", "bevel",
        "c_interp", "d_interp", "lod",  "shadow_obj", "trace_obj", "ctech",  "stech",  "cstype",
        "deg",      "bmat",     "step", "curv",       "curv2",     "surf",   "parm",   "trim",
        "hole",     "scrv",     "sp",   "end",        "con",       "call",   "csh",    "bzp",
        "bsp",      "cdc",      "cdp",  "res",        "fo"};
    return std::ranges::find(kKeywords, word) != std::end(kKeywords);
}

void add_problem(ObjFile& file, const DiagnosticCode& code, std::size_t begin, std::size_t end,
                 std::string message) {
    ++file.problem_count;
    if (file.problems.size() >= kMaxObjProblems) return;
    file.problems.push_back({&code, static_cast<std::uint32_t>(begin),
                             static_cast<std::uint32_t>(end), std::move(message)});
}

std::string index_message(ObjIndexKind kind, std::int64_t index, std::size_t count) {
    const char* what = kind == ObjIndexKind::kPosition ? "vertex"
                       : kind == ObjIndexKind::kUv     ? "texture coordinate"
                                                       : "normal";
    std::string message = std::string("face refers to ") + what + " " + std::to_string(index);
    if (index == 0) return message + ", but they are counted from 1";
    if (index < 0) {
        return message + ", but only " + std::to_string(count) + " came before it";
    }
    return message + ", but the file has " + (count == 0 ? "none" : std::to_string(count));
}

void sort_problems(ObjFile& file) {
    std::stable_sort(file.problems.begin(), file.problems.end(),
                     [](const auto& a, const auto& b) { return a.begin < b.begin; });
}

}  // namespace cobble::ir
