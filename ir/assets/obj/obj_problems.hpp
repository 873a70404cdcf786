// SPDX-License-Identifier: MIT
// The findings of both OBJ readers: their codes, and a list that stops growing.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "ir/assets/obj/obj_file.hpp"

namespace cobble::ir {

extern const source::DiagnosticCode kObjNumber;
extern const source::DiagnosticCode kObjStatement;
extern const source::DiagnosticCode kObjFace;
extern const source::DiagnosticCode kObjIndex;
extern const source::DiagnosticCode kObjTooManyFaces;
extern const source::DiagnosticCode kObjKeyword;

/// True for every word that a line of an OBJ file may begin with, whether we read it or not.
bool is_obj_keyword(std::string_view word);

/// Counts a problem of `file` and lists it if there is room.
void add_problem(ObjFile& file, const source::DiagnosticCode& code, std::size_t begin,
                 std::size_t end, std::string message);

/// Which of its arrays a corner's index points into.
enum class ObjIndexKind : std::uint8_t { kPosition, kUv, kNormal };

/// "face refers to vertex 9, but the file has 8".
std::string index_message(ObjIndexKind kind, std::int64_t index, std::size_t count);

/// Puts the problems in order of their bytes (indices are judged after the whole file is read).
void sort_problems(ObjFile& file);

}  // namespace cobble::ir
