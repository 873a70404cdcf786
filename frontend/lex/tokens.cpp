// SPDX-License-Identifier: MIT
#include "frontend/lex/tokens.hpp"

#include <algorithm>

#include "grammar/lexical.hpp"

namespace cobble::frontend {
namespace {

using grammar::lexical::ByteClass;
using grammar::lexical::kByteClasses;

// The end of a token that is too long for its length field, looked for from where that ends.
std::size_t end_of_long(std::string_view text, TokenKind kind, std::size_t from) {
    if (kind == TokenKind::kString || kind == TokenKind::kUnterminatedString) {
        const std::size_t stop = text.find_first_of("\"\r\n", from);
        if (stop == std::string_view::npos) return text.size();
        return text[stop] == '"' ? stop + 1 : stop;
    }
    for (; from < text.size(); ++from) {
        if (kByteClasses[static_cast<unsigned char>(text[from])] != ByteClass::kChunk) break;
        const bool comment = text.substr(from, 2) == "//";
        if (comment && kind != TokenKind::kWord) break;
    }
    return from;
}

constexpr bool ends_line(char byte) { return byte == '\n' || byte == '\r'; }

}  // namespace

ByteRange Tokens::long_range(TokenId id) const {
    const Token& token = tokens[id.value];
    // The last byte that the length covers may be a closing quote, so look from there.
    const std::size_t end = end_of_long(text, kind(id), token.begin + kLongToken - 1);
    return {token.begin, static_cast<std::uint32_t>(end)};
}

std::string_view Tokens::word_of(TokenId id) const {
    std::string_view word = text_of(id);
    const TokenKind its_kind = kind(id);
    if (its_kind == TokenKind::kString) return word.substr(1, word.size() - 2);
    if (its_kind == TokenKind::kUnterminatedString) return word.substr(1);
    return word;
}

bool Tokens::first_on_line(TokenId id) const {
    const std::uint32_t limit = id.value == 0 ? 0 : range({id.value - 1}).end;
    std::uint32_t at = tokens[id.value].begin;
    while (at > limit) {
        const char byte = text[at - 1];
        if (ends_line(byte)) return true;
        if (kByteClasses[static_cast<unsigned char>(byte)] != ByteClass::kWhite) break;
        --at;
    }
    // Only the first token can come here with nothing before it; three bytes are the byte-order
    // mark, which is no text.
    return id.value == 0 && (at == 0 || (at == 3 && text.starts_with("\xEF\xBB\xBF")));
}

bool Tokens::line_ends_after(TokenId id) const {
    if (id.value + 1 >= size()) return false;
    const std::uint32_t begin = range(id).end;
    const std::string_view gap = text.substr(begin, tokens[id.value + 1].begin - begin);
    return std::any_of(gap.begin(), gap.end(), ends_line);
}

}  // namespace cobble::frontend
