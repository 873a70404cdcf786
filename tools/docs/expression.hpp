// SPDX-License-Identifier: MIT
// Grammars as data: what the EBNF page and the railroad diagrams are both drawn from.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace cobble::docs {

enum class Form : unsigned char {
    kText,      ///< these very characters
    kClass,     ///< some character or token, described in words
    kRule,      ///< a rule, by its name
    kSequence,  ///< all parts, one after the other
    kChoice,    ///< the first part that matches
    kOptional,  ///< parts[0] or nothing
    kMany,      ///< parts[0], any number of times
    kSome,      ///< parts[0], once or more
    kRepeat,    ///< parts[0], `count` times
    kAhead,     ///< parts[0] must come next; it is not consumed
    kNotAhead,  ///< parts[0] must not come next
};

struct Expression {
    Form form = Form::kSequence;
    std::string text;
    std::vector<Expression> parts;
    int count = 0;
};

inline Expression text(std::string characters) {
    return {Form::kText, std::move(characters), {}, 0};
}
inline Expression described(std::string words) { return {Form::kClass, std::move(words), {}, 0}; }
inline Expression rule(std::string name) { return {Form::kRule, std::move(name), {}, 0}; }
inline Expression compound(Form form, std::vector<Expression> parts, int count = 0) {
    if (parts.size() == 1 && (form == Form::kSequence || form == Form::kChoice)) {
        return std::move(parts[0]);
    }
    return {form, {}, std::move(parts), count};
}

struct Rule {
    std::string name;
    Expression body;
};

/// Rules in the order in which they are first used, the start first.
using Grammar = std::vector<Rule>;

/// One rule as a line of EBNF, broken and indented past 96 columns.
std::string ebnf(const Rule& rule);

/// One rule, or several one below the other, each under its name, as a picture of their own (SVG).
std::string railroad(const Grammar& rules);

}  // namespace cobble::docs
