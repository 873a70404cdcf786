// SPDX-License-Identifier: MIT
#include "frontend/parse/cst.hpp"

#include "frontend/lex/words.hpp"
#include "grammar/vocabulary.hpp"

namespace cobble::frontend {
namespace {

bool is_brace(const Tokens& tokens, std::uint32_t token) {
    return token < tokens.size() && tokens.kind({token}) == TokenKind::kOpenBrace;
}

// Whether the token after a block's name is its label. It should stand on the name's line.
bool may_be_label(const Tokens& tokens, std::uint32_t token) {
    switch (tokens.kind({token})) {
        case TokenKind::kOpenBrace:
        case TokenKind::kCloseBrace:
        case TokenKind::kEndOfFile:
            return false;
        case TokenKind::kWord:
            return !grammar::is_vocabulary_name(tokens.text_of({token}));
        default:
            return !tokens.line_ends_after({token - 1});
    }
}

}  // namespace

TokenId open_brace_of(const Tokens& tokens, const CstNode& block) {
    const std::uint32_t first = block.first_token;
    if (block.word_label != 0) return {first + 2};
    if (is_brace(tokens, first)) return {first};
    if (is_brace(tokens, first + 1)) return {first + 1};
    if (is_brace(tokens, first + 2) && may_be_label(tokens, first + 1)) return {first + 2};
    return {};
}

TokenId label_of(const Tokens& tokens, const CstNode& block) {
    const std::uint32_t first = block.first_token;
    const TokenId brace = open_brace_of(tokens, block);
    if (brace.valid()) return brace.value == first + 2 ? TokenId{first + 1} : TokenId{};
    if (block.end_token == first + 1) return {};
    // Without a brace only a word that can be nothing else is a label.
    if (tokens.kind({first + 1}) != TokenKind::kWord || !may_be_label(tokens, first + 1)) return {};
    if (tokens.line_ends_after({first})) return {};
    return is_label(tokens.text_of({first + 1})) ? TokenId{first + 1} : TokenId{};
}

}  // namespace cobble::frontend
