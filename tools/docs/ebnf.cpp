// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <string_view>

#include "tools/docs/expression.hpp"

namespace cobble::docs {
namespace {

constexpr std::size_t kColumns = 96;

/// How tightly a form binds: a part that binds less than its surroundings needs parentheses.
int strength(const Expression& expression) {
    switch (expression.form) {
        case Form::kChoice:
            return 0;
        case Form::kSequence:
            return 1;
        case Form::kOptional:
        case Form::kMany:
        case Form::kSome:
        case Form::kRepeat:
        case Form::kAhead:
        case Form::kNotAhead:
            return 2;
        default:
            return 3;
    }
}

std::string write(const Expression& expression);

std::string write_part(const Expression& part, int needed) {
    const std::string text = write(part);
    return strength(part) >= needed ? text : fmt::format("({})", text);
}

std::string join(const std::vector<Expression>& parts, std::string_view between, int needed) {
    std::string text;
    for (const Expression& part : parts) {
        if (!text.empty()) text += between;
        text += write_part(part, needed);
    }
    return text;
}

// The recursion is as deep as the grammar's source is nested.
std::string write(const Expression& expression) {
    const auto& parts = expression.parts;
    switch (expression.form) {
        case Form::kText:
            return expression.text == "\"" ? "'\"'" : fmt::format("\"{}\"", expression.text);
        case Form::kClass:
            return fmt::format("<{}>", expression.text);
        case Form::kRule:
            return expression.text;
        case Form::kSequence:
            return join(parts, " ", 2);
        case Form::kChoice:
            return join(parts, " | ", 1);
        case Form::kOptional:
            return write_part(parts[0], 3) + "?";
        case Form::kMany:
            return write_part(parts[0], 3) + "*";
        case Form::kSome:
            return write_part(parts[0], 3) + "+";
        case Form::kRepeat:
            return write_part(parts[0], 3) + fmt::format("{{{}}}", expression.count);
        case Form::kAhead:
            return fmt::format("&{}", write_part(parts[0], 3));
        case Form::kNotAhead:
            return fmt::format("!{}", write_part(parts[0], 3));
    }
    return {};
}

/// The text cut at its blanks outside quotes and angles.
std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words(1);
    char inside = 0;
    for (const char c : text) {
        if (c == ' ' && inside == 0) {
            words.emplace_back();
            continue;
        }
        words.back() += c;
        if (inside != 0) {
            if (c == inside) inside = 0;
        } else if (c == '"' || c == '\'') {
            inside = c;
        } else if (c == '<') {
            inside = '>';
        }
    }
    return words;
}

/// Fills lines up to kColumns, further ones indented; a new one begins at a `|` rather than within
/// an alternative.
std::string wrap(const std::string& text, std::size_t indent) {
    std::vector<std::string> pieces;
    for (std::string& word : words_of(text)) {
        if (pieces.empty() || word == "|") {
            pieces.push_back(std::move(word));
        } else {
            pieces.back() += ' ';
            pieces.back() += word;
        }
    }
    std::string result;
    std::size_t column = indent;
    for (const std::string& piece : pieces) {
        if (column > indent && column + 1 + piece.size() > kColumns) {
            result += '\n';
            result.append(indent, ' ');
            column = indent;
        } else if (column > indent) {
            result += ' ';
            ++column;
        }
        result += piece;
        column += piece.size();
    }
    return result;
}

}  // namespace

std::string ebnf(const Rule& rule) {
    const std::string head = rule.name + " ::= ";
    return head + wrap(write(rule.body), head.size());
}

}  // namespace cobble::docs
