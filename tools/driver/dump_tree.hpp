// SPDX-License-Identifier: MIT
// What each phase of the front end saw, one line a token or node.
#pragma once

#include <functional>
#include <string_view>

#include "frontend/check/check.hpp"

namespace cobble::driver {

/// Takes text; false means that nobody reads it any more.
using DumpSink = std::function<bool(std::string_view)>;

/// "LINE:COLUMN kind text", comments among the tokens.
void dump_tokens(const frontend::CheckedScene& scene, const DumpSink& sink);

/// Indented by nesting (at most 40 levels deep in white space; the level stands at the front of a
/// line that is deeper): the kind of node, its flags, and its own first words.
void dump_cst(const frontend::CheckedScene& scene, const DumpSink& sink);

/// Blocks and fields with their values and, for objects, the material.
void dump_ast(const frontend::CheckedScene& scene, const DumpSink& sink);

}  // namespace cobble::driver
