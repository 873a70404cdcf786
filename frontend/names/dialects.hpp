// SPDX-License-Identifier: MIT
// Words of the language's other dialects: what each was called where, and what to write today.
//
// The language has relatives: the course's editions of 2003 and 2004, a course at Tsinghua, the
// rewrite of 2019, and words that students added to their own programs. None of those words is
// accepted; this table makes the error message say what the word meant and what to do about it.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "frontend/lex/tokens.hpp"
#include "frontend/source/diagnostic.hpp"

namespace cobble::frontend {

enum class Dialect : std::uint8_t { k2003, k2004, kTsinghua, k2019, kExtension };

/// How an entry can be rewritten without thinking about the rest of the file.
enum class Rewrite : std::uint8_t {
    kNone,       ///< only a person can
    kRename,     ///< another name, the same values
    kFalloff,    ///< `attenuation 1 0 q` as `falloff q`
    kTranspose,  ///< `Matrix` by rows as `Matrix4f` by columns
};

struct DialectWord {
    std::string_view word;
    std::string_view block;   ///< where it stands; "" is the top level, "Material" both spellings
    std::string_view modern;  ///< the word of today, "" if there is none
    std::string_view advice;  ///< a note: lower case, one sentence, no final stop
    Dialect dialect;
    Rewrite rewrite;
};

/// "the 2004 dialect" and so on, for messages.
std::string_view name_of(Dialect dialect);

/// The entry for `word` in `block` (a block's name, "" at the top level), or else, inside a block,
/// the entry of any other block where that word is a block's name, or null. At the top level
/// `Light` is a misspelt `Lights`, whatever it is elsewhere. A linear search: for unknown names
/// only.
const DialectWord* find_dialect_word(std::string_view word, std::string_view block);

/// The change that turns one entry into today's words, if it can be had from the entry alone: never
/// safe, and its title says what changes. `name` is the entry's first token, `end` the first token
/// after its values and braces.
std::optional<source::Fix> dialect_fix(const DialectWord& word, source::SourceId source,
                                       const Tokens& tokens, TokenId name, TokenId end);

/// True if a block of this name may stand at the top level in any dialect: how a `.txt` file is
/// recognised as a scene by its first word.
bool is_top_level_name_of_any_dialect(std::string_view word);

}  // namespace cobble::frontend
