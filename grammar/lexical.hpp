// SPDX-License-Identifier: MIT
// The lexical grammar: which runs of bytes are which tokens.
//
// Input: the bytes of a file. Total by construction: every text matches `text`, because what fits
// nothing else is a word and an unclosed string is a token of its own. Actions belong on the rules
// directly inside `token` and on `comment`, which are never undone once they have matched.
#pragma once

#include <array>

#include <tao/pegtl.hpp>
#include <tao/pegtl/contrib/analyze_traits.hpp>

namespace cobble::grammar::lexical {

namespace pegtl = tao::pegtl;

/// What a byte can be inside a token.
enum class ByteClass : unsigned char { kChunk, kWhite, kDelimiter };

/// One look-up a byte instead of a chain of comparisons: three quarters of the lexer's time is
/// spent asking whether a chunk goes on.
inline constexpr std::array<ByteClass, 256> kByteClasses = [] {
    std::array<ByteClass, 256> classes{};
    const auto put = [&classes](char byte, ByteClass byte_class) {
        classes[static_cast<unsigned char>(byte)] = byte_class;
    };
    for (const char byte : {' ', '\t', '\r', '\n', '\v', '\f'}) put(byte, ByteClass::kWhite);
    for (const char byte : {'{', '}', '"'}) put(byte, ByteClass::kDelimiter);
    return classes;
}();

/// A byte of the given class.
template <ByteClass byte_class>
struct byte_of {
    using rule_t = byte_of;
    using subs_t = pegtl::empty_list;

    template <typename Input>
    static bool match(Input& in) {
        if (in.empty() || kByteClasses[in.peek_uint8()] != byte_class) return false;
        in.bump_in_this_line(1);
        return true;
    }
};

struct white : byte_of<ByteClass::kWhite> {};
struct chunk_byte : byte_of<ByteClass::kChunk> {};
struct byte_order_mark : pegtl::string<'\xEF', '\xBB', '\xBF'> {};

struct open_brace : pegtl::one<'{'> {};
struct close_brace : pegtl::one<'}'> {};

struct comment_mark : pegtl::two<'/'> {};
struct line_byte : pegtl::not_one<'\n', '\r'> {};
struct comment : pegtl::seq<comment_mark, pegtl::star<line_byte>> {};

// A number or colour ends where its chunk ends, or where a comment begins.
struct value_end : pegtl::not_at<pegtl::not_at<comment_mark>, chunk_byte> {};

struct sign : pegtl::one<'+', '-'> {};
struct digits : pegtl::plus<pegtl::digit> {};
struct fraction : pegtl::seq<pegtl::one<'.'>, digits> {};
struct mantissa
    : pegtl::sor<pegtl::seq<digits, pegtl::opt<pegtl::one<'.'>, pegtl::star<pegtl::digit>>>,
                 fraction> {};
struct exponent : pegtl::seq<pegtl::one<'e', 'E'>, pegtl::opt<sign>, digits> {};
struct number : pegtl::seq<pegtl::opt<sign>, mantissa, pegtl::opt<exponent>, value_end> {};

struct color : pegtl::seq<pegtl::one<'#'>, pegtl::rep<6, pegtl::xdigit>, value_end> {};

struct quote : pegtl::one<'"'> {};
struct string_byte : pegtl::not_one<'"', '\n', '\r'> {};
struct string : pegtl::seq<quote, pegtl::star<string_byte>, quote> {};
struct unterminated_string : pegtl::seq<quote, pegtl::star<string_byte>> {};

struct word : pegtl::plus<chunk_byte> {};

struct token : pegtl::sor<number, comment, color, open_brace, close_brace, string,
                          unterminated_string, word> {};
struct text
    : pegtl::seq<pegtl::opt<byte_order_mark>, pegtl::star<pegtl::sor<white, token>>, pegtl::eof> {};

}  // namespace cobble::grammar::lexical

namespace tao::pegtl {
template <typename Name, cobble::grammar::lexical::ByteClass byte_class>
struct analyze_traits<Name, cobble::grammar::lexical::byte_of<byte_class>> : analyze_any_traits<> {
};
}  // namespace tao::pegtl
