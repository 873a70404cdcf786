// SPDX-License-Identifier: MIT
// What indentation tells. It is asked only where braces do not add up: it never makes a file wrong.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "frontend/lex/tokens.hpp"

namespace cobble::frontend {

/// The white space before a token that stands first on its line; nothing for other tokens.
/// Indentations are compared as texts, so that tabs and spaces need no common width.
std::optional<std::string_view> indent_of(const Tokens& tokens, std::uint32_t token);

/// True if `indent` is `than` and more of tabs or blanks. Other mixtures of the two say nothing.
bool is_deeper(std::string_view indent, std::string_view than);

/// True if `item` stands on a line of its own, indented like the block that begins at `opener` and
/// not like that block's first child.
bool stands_beside(const Tokens& tokens, std::uint32_t item, std::uint32_t opener,
                   std::uint32_t first_child);

/// True if the } at `brace`, which closes the block that begins at `opener`, looks like one too
/// many, given that `item` after it would fit into that block only.
bool close_looks_extra(const Tokens& tokens, std::uint32_t opener, std::uint32_t brace,
                       std::uint32_t item);

}  // namespace cobble::frontend
