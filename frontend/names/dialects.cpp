// SPDX-License-Identifier: MIT
#include "frontend/names/dialects.hpp"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "grammar/vocabulary.hpp"

namespace cobble::frontend {
namespace {

constexpr DialectWord kWords[] = {
#define COBBLE_DIALECT(word, block, dialect, modern, rewrite, advice) \
    {#word, block, modern, advice, Dialect::dialect, Rewrite::rewrite},
#include "frontend/names/dialects.def"
};

/// Where the table lists what may stand in several blocks under one of them.
std::string_view listed_under(std::string_view block) {
    if (block == "PhongMaterial") return "Material";
    return block;
}

/// A block's name rather than a field's: what is worth finding away from its place.
bool is_block_like(std::string_view word) { return word[0] >= 'A' && word[0] <= 'Z'; }

source::Span span_of(source::SourceId source, const Tokens& tokens, TokenId token) {
    const ByteRange range = tokens.range(token);
    return {source, range.begin, range.end};
}

/// The tokens of `kind` after the name.
std::vector<TokenId> numbers_in(const Tokens& tokens, TokenId name, TokenId end) {
    std::vector<TokenId> numbers;
    for (std::uint32_t i = name.value + 1; i < end.value && numbers.size() <= 16; ++i) {
        if (tokens.kind(TokenId{i}) == TokenKind::kNumber) numbers.push_back(TokenId{i});
    }
    return numbers;
}

double number_of(const Tokens& tokens, TokenId token) {
    std::string_view text = tokens.text_of(token);
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0;
    fast_float::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

source::Fix rename(const DialectWord& word, source::SourceId source, const Tokens& tokens,
                   TokenId name) {
    return {fmt::format("rename '{}' to '{}' (the look changes: {} shades by other formulas)",
                        word.word, word.modern, name_of(word.dialect)),
            false,
            {{span_of(source, tokens, name), std::string(word.modern)}}};
}

std::optional<source::Fix> falloff(source::SourceId source, const Tokens& tokens, TokenId name,
                                   TokenId end) {
    const auto numbers = numbers_in(tokens, name, end);
    if (numbers.size() != 3 || end.value - name.value != 4) return std::nullopt;
    if (number_of(tokens, numbers[0]) != 1 || number_of(tokens, numbers[1]) != 0) {
        return std::nullopt;
    }
    if (!(number_of(tokens, numbers[2]) >= 0)) return std::nullopt;
    const std::string text = fmt::format("falloff {}", tokens.text_of(numbers[2]));
    source::Span span = span_of(source, tokens, name);
    span.end = tokens.range(numbers[2]).end;
    return source::Fix{
        fmt::format("write '{}' (the same fading with distance, no longer clamped)", text),
        false,
        {{span, text}}};
}

std::optional<source::Fix> transpose(source::SourceId source, const Tokens& tokens, TokenId name,
                                     TokenId end) {
    const auto numbers = numbers_in(tokens, name, end);
    // The name, two braces and the numbers, and nothing else.
    if (numbers.size() != 16 || end.value - name.value != 19) return std::nullopt;
    source::Fix fix{"rename 'Matrix' to 'Matrix4f' and transpose its numbers from rows to columns",
                    false,
                    {{span_of(source, tokens, name), "Matrix4f"}}};
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
            const TokenId here = numbers[row * 4 + column];
            const TokenId there = numbers[column * 4 + row];
            if (tokens.text_of(here) == tokens.text_of(there)) continue;
            fix.edits.push_back(
                {span_of(source, tokens, here), std::string(tokens.text_of(there))});
        }
    }
    return fix;
}

}  // namespace

std::string_view name_of(Dialect dialect) {
    switch (dialect) {
        case Dialect::k2003:
            return "the 2003 dialect";
        case Dialect::k2004:
            return "the 2004 dialect";
        case Dialect::kTsinghua:
            return "the Tsinghua dialect";
        case Dialect::k2019:
            return "the 2019 dialect";
        case Dialect::kExtension:
            break;
    }
    return "a student's extension";
}

const DialectWord* find_dialect_word(std::string_view word, std::string_view block) {
    const std::string_view place = listed_under(block);
    const DialectWord* elsewhere = nullptr;
    for (const DialectWord& entry : kWords) {
        if (entry.word != word) continue;
        if (entry.block == place) return &entry;
        if (elsewhere == nullptr && is_block_like(word) && !place.empty()) elsewhere = &entry;
    }
    return elsewhere;
}

std::optional<source::Fix> dialect_fix(const DialectWord& word, source::SourceId source,
                                       const Tokens& tokens, TokenId name, TokenId end) {
    switch (word.rewrite) {
        case Rewrite::kNone:
            break;
        case Rewrite::kRename:
            return rename(word, source, tokens, name);
        case Rewrite::kFalloff:
            return falloff(source, tokens, name, end);
        case Rewrite::kTranspose:
            return transpose(source, tokens, name, end);
    }
    return std::nullopt;
}

bool is_top_level_name_of_any_dialect(std::string_view word) {
    const grammar::BlockRow* row = grammar::find_block(word);
    if (row != nullptr && grammar::may_stand_at_top(row->id)) return true;
    return std::ranges::any_of(kWords, [word](const DialectWord& entry) {
        return entry.block.empty() && entry.word == word;
    });
}

}  // namespace cobble::frontend
