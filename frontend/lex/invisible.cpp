// SPDX-License-Identifier: MIT
#include "frontend/lex/invisible.hpp"

#include <algorithm>

#include "frontend/source/utf8.hpp"

namespace cobble::frontend {
namespace {

struct Row {
    std::string_view bytes;
    std::string_view name;
    bool blank;
};

// The white space of Unicode (its property White_Space) beyond ASCII, and the characters without
// width that web pages, chats and editors put into text.
constexpr Row kRows[] = {
    {"\xC2\x85", "U+0085, a next-line character", true},
    {"\xC2\xA0", "U+00A0, a no-break space", true},
    {"\xC2\xAD", "U+00AD, a soft hyphen", false},
    {"\xE1\x9A\x80", "U+1680, an Ogham space", true},
    {"\xE2\x80\x80", "U+2000, an en quad", true},
    {"\xE2\x80\x81", "U+2001, an em quad", true},
    {"\xE2\x80\x82", "U+2002, an en space", true},
    {"\xE2\x80\x83", "U+2003, an em space", true},
    {"\xE2\x80\x84", "U+2004, a three-per-em space", true},
    {"\xE2\x80\x85", "U+2005, a four-per-em space", true},
    {"\xE2\x80\x86", "U+2006, a six-per-em space", true},
    {"\xE2\x80\x87", "U+2007, a figure space", true},
    {"\xE2\x80\x88", "U+2008, a punctuation space", true},
    {"\xE2\x80\x89", "U+2009, a thin space", true},
    {"\xE2\x80\x8A", "U+200A, a hair space", true},
    {"\xE2\x80\x8B", "U+200B, a zero-width space", false},
    {"\xE2\x80\x8C", "U+200C, a zero-width non-joiner", false},
    {"\xE2\x80\x8D", "U+200D, a zero-width joiner", false},
    {"\xE2\x80\x8E", "U+200E, a left-to-right mark", false},
    {"\xE2\x80\x8F", "U+200F, a right-to-left mark", false},
    {"\xE2\x80\xA8", "U+2028, a line separator", true},
    {"\xE2\x80\xA9", "U+2029, a paragraph separator", true},
    {"\xE2\x80\xAF", "U+202F, a narrow no-break space", true},
    {"\xE2\x81\x9F", "U+205F, a mathematical space", true},
    {"\xE2\x81\xA0", "U+2060, a word joiner", false},
    {"\xE3\x80\x80", "U+3000, an ideographic space", true},
    {"\xEF\xBB\xBF", "U+FEFF, a byte-order mark", false},
};

}  // namespace

std::optional<Invisible> find_invisible(std::string_view text, std::size_t from) {
    if (from == 0 && source::is_ascii(text)) return std::nullopt;
    for (std::size_t at = from; at < text.size(); ++at) {
        if (static_cast<unsigned char>(text[at]) < 0x80) continue;
        const auto is_here = [rest = text.substr(at)](const Row& row) {
            return rest.starts_with(row.bytes);
        };
        const auto* const row = std::find_if(std::begin(kRows), std::end(kRows), is_here);
        if (row != std::end(kRows)) return Invisible{at, row->bytes.size(), row->name, row->blank};
    }
    return std::nullopt;
}

std::string visible_name(std::string_view word) {
    std::string name;
    std::size_t at = 0;
    while (const auto found = find_invisible(word, at)) {
        name += word.substr(at, found->at - at);
        at = found->at + found->bytes;
        if (found->blank && !name.empty()) return name;
    }
    name += word.substr(at);
    return name;
}

}  // namespace cobble::frontend
