// SPDX-License-Identifier: MIT
#include <algorithm>

#include "frontend/lex/tokens.hpp"
#include "frontend/source/utf8.hpp"
#include "grammar/lexical.hpp"

namespace cobble::frontend {
namespace {

namespace lexical = grammar::lexical;
namespace pegtl = tao::pegtl;

// Positions are made from offsets by our own line index, so PEGTL need not count lines.
using Input = pegtl::memory_input<pegtl::tracking_mode::lazy, pegtl::eol::lf, const char*>;

struct Sink {
    Tokens& tokens;
    const char* text_begin;

    template <typename ActionInput>
    [[nodiscard]] ByteRange range(const ActionInput& in) const {
        return {static_cast<std::uint32_t>(in.begin() - text_begin),
                static_cast<std::uint32_t>(in.end() - text_begin)};
    }
};

template <typename Rule>
struct Action : pegtl::nothing<Rule> {};

template <TokenKind kind>
struct Emit {
    template <typename ActionInput>
    static void apply(const ActionInput& in, Sink& sink) {
        const ByteRange bytes = sink.range(in);
        const std::uint32_t length = std::min(bytes.end - bytes.begin, kLongToken);
        sink.tokens.tokens.push_back(
            {bytes.begin, static_cast<std::uint32_t>(kind), length & kLongToken});
    }
};

template <>
struct Action<lexical::open_brace> : Emit<TokenKind::kOpenBrace> {};
template <>
struct Action<lexical::close_brace> : Emit<TokenKind::kCloseBrace> {};
template <>
struct Action<lexical::number> : Emit<TokenKind::kNumber> {};
template <>
struct Action<lexical::color> : Emit<TokenKind::kColor> {};
template <>
struct Action<lexical::word> : Emit<TokenKind::kWord> {};
template <>
struct Action<lexical::string> : Emit<TokenKind::kString> {};
template <>
struct Action<lexical::unterminated_string> : Emit<TokenKind::kUnterminatedString> {};
template <>
struct Action<lexical::comment> {
    template <typename ActionInput>
    static void apply(const ActionInput& in, Sink& sink) {
        sink.tokens.comments.push_back(sink.range(in));
    }
};

void find_invalid_utf8(std::string_view text, std::vector<std::uint32_t>& invalid) {
    if (source::is_ascii(text)) return;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = source::utf8_length(text.substr(at));
        if (length == 0) invalid.push_back(static_cast<std::uint32_t>(at));
        at += length == 0 ? 1 : length;
    }
}

}  // namespace

Tokens lex(std::string_view text) {
    Tokens tokens;
    tokens.text = text;
    // Published scenes have a token every 4.8 to 7 bytes; a short reserve costs one growth, a long
    // one memory.
    tokens.tokens.reserve(text.size() / 5 + 16);
    Sink sink{tokens, text.data()};
    Input in(text.data(), text.data() + text.size(), "");
    pegtl::parse<lexical::text, Action>(in, sink);
    const auto end = static_cast<std::uint32_t>(text.size());
    tokens.tokens.push_back({end, static_cast<std::uint32_t>(TokenKind::kEndOfFile) & 0xffU, 0});
    find_invalid_utf8(text, tokens.invalid_utf8);
    return tokens;
}

}  // namespace cobble::frontend
