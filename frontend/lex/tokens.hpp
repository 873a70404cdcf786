// SPDX-License-Identifier: MIT
// Text as tokens. Input: the bytes of a file. Output: flat arrays from which, with the text, the
// file can be rebuilt byte for byte: white space is what stands between tokens and comments.
// Invariant: total. Every text gives tokens; what is wrong with one is its kind.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace cobble::frontend {

enum class TokenKind : std::uint8_t {
    kOpenBrace,
    kCloseBrace,
    kNumber,              ///< a complete decimal number
    kColor,               ///< # and six hex digits
    kWord,                ///< any other run without white space, braces or quotes
    kString,              ///< "..." with both quotes on one line
    kUnterminatedString,  ///< "... up to the end of its line
    kEndOfFile,           ///< the last token, empty, at the end of the text
};

/// Index of a token in Tokens.
struct TokenId {
    std::uint32_t value = 0xffffffffU;
    [[nodiscard]] constexpr bool valid() const { return value != 0xffffffffU; }
    friend constexpr auto operator<=>(TokenId, TokenId) = default;
};

/// A half-open range of bytes.
struct ByteRange {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    friend constexpr bool operator==(ByteRange, ByteRange) = default;
};

/// Eight bytes a token: where it begins, what it is, how long it is. A token of kLongToken bytes or
/// more stores that as its length, and its end is found again from the text.
struct Token {
    std::uint32_t begin;
    std::uint32_t kind : 8;
    std::uint32_t length : 24;
};
static_assert(sizeof(Token) == 8);
inline constexpr std::uint32_t kLongToken = 0xffffffU;

/// The lexer's result. Views into `text`, which must outlive it.
class Tokens {
  public:
    std::string_view text;                    ///< the whole file, byte-order mark included
    std::vector<Token> tokens;                ///< in order; the last is kEndOfFile
    std::vector<ByteRange> comments;          ///< `//` to the end of line (exclusive), in order
    std::vector<std::uint32_t> invalid_utf8;  ///< offset of each byte that starts no code point

    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(tokens.size()); }
    [[nodiscard]] TokenKind kind(TokenId id) const {
        return static_cast<TokenKind>(tokens[id.value].kind);
    }
    [[nodiscard]] ByteRange range(TokenId id) const {
        const Token& token = tokens[id.value];
        if (token.length == kLongToken) return long_range(id);
        return {token.begin, token.begin + token.length};
    }
    [[nodiscard]] std::string_view text_of(TokenId id) const {
        const ByteRange bytes = range(id);
        return text.substr(bytes.begin, bytes.end - bytes.begin);
    }
    /// The text of a word, or of a string without its quotes.
    [[nodiscard]] std::string_view word_of(TokenId id) const;
    /// True if nothing but white space stands before the token on its line.
    [[nodiscard]] bool first_on_line(TokenId id) const;
    /// True if a line ends between the two neighbouring tokens `id` and `id + 1`.
    [[nodiscard]] bool line_ends_after(TokenId id) const;

  private:
    [[nodiscard]] ByteRange long_range(TokenId id) const;
};

/// Cuts a text into tokens. Cost: one pass, about 1.5 bytes kept per byte of text.
Tokens lex(std::string_view text);

}  // namespace cobble::frontend
