// SPDX-License-Identifier: MIT
// What a word looks like, apart from what it means.
#pragma once

#include <string_view>

namespace cobble::frontend {

/// True for what was surely meant as a number: a digit first (after signs and a point), or inf or
/// nan in any case. It says nothing about whether the number is well formed.
bool looks_like_number(std::string_view word);

/// True for `[A-Za-z_][A-Za-z0-9_-]*`.
bool is_label(std::string_view word);

}  // namespace cobble::frontend
