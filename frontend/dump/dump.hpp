// SPDX-License-Identifier: MIT
// What each phase of the front end saw, as text for people and for tests.
//
// One line a thing, the place first as line:column (1-based, in code points), children indented by
// two blanks (past 40 levels by the depth as a number, so that deep nesting stays readable and
// linear). Bytes that are no printable text are written as \xHH. The order is that of the file.
#pragma once

#include <string>

#include "frontend/ast/ast.hpp"
#include "frontend/lex/tokens.hpp"
#include "frontend/parse/cst.hpp"

namespace cobble::frontend {

/// `2:5 word radius`: tokens and comments, the end of the file last.
std::string dump_tokens(const Tokens& tokens);

/// `2:5 field radius 1`, ` error` and ` unclosed` behind those that are flagged.
std::string dump_cst(const Tokens& tokens, const Cst& cst);

/// `1:1 Sphere lamp` and its fields `2:5 radius = 1`, then its children; ` broken` behind those
/// that are. Numbers are the shortest that read back the same.
std::string dump_ast(const Tokens& tokens, const Cst& cst, const Ast& ast);

}  // namespace cobble::frontend
