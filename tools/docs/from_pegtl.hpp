// SPDX-License-Identifier: MIT
// PEGTL rules as data: walks the types that a grammar consists of, so that its pages cannot say
// anything but what the program does. A kind of rule that is not known here does not compile.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <tao/pegtl.hpp>
#include <tao/pegtl/demangle.hpp>

#include "grammar/lexical.hpp"
#include "grammar/structure.hpp"
#include "tools/docs/expression.hpp"

namespace cobble::docs {

/// "a word that names a field of the open block"
std::string describe(grammar::structure::Symbol symbol);
std::string describe(grammar::lexical::ByteClass byte_class);
/// A character as it is shown: itself, or its name if it cannot be seen.
Expression show_character(char c);

namespace pegtl_types {

namespace internal = tao::pegtl::internal;

template <typename Rule>
constexpr std::string_view name_of() {
    std::string_view name = tao::pegtl::demangle<Rule>();
    if (name.starts_with("struct ")) name.remove_prefix(7);
    if (!name.starts_with("cobble::grammar::") || name.find('<') != std::string_view::npos) {
        return {};
    }
    return name.substr(name.rfind(':') + 1);
}

template <typename Form>
struct Body;

template <typename Rule>
void add_rule(Grammar& grammar) {
    const std::string name(name_of<Rule>());
    for (const docs::Rule& known : grammar) {
        if (known.name == name) return;
    }
    const std::size_t at = grammar.size();
    grammar.push_back({name, {}});
    Expression body = Body<typename Rule::rule_t>::make(grammar);
    grammar[at].body = std::move(body);
}

template <typename Rule>
Expression expression_of(Grammar& grammar) {
    if constexpr (!name_of<Rule>().empty()) {
        add_rule<Rule>(grammar);
        return rule(std::string(name_of<Rule>()));
    } else {
        return Body<typename Rule::rule_t>::make(grammar);
    }
}

template <typename... Rules>
std::vector<Expression> expressions_of(Grammar& grammar) {
    std::vector<Expression> parts;
    (parts.push_back(expression_of<Rules>(grammar)), ...);
    return parts;
}

template <Form form, typename... Rules>
struct Compound {
    static Expression make(Grammar& grammar) {
        return compound(form, expressions_of<Rules...>(grammar));
    }
};

template <typename... Rules>
struct Body<internal::seq<Rules...>> : Compound<Form::kSequence, Rules...> {};
template <typename... Rules>
struct Body<internal::sor<Rules...>> : Compound<Form::kChoice, Rules...> {};
template <typename Rule>
struct Body<internal::opt<Rule>> : Compound<Form::kOptional, Rule> {};
template <typename Rule>
struct Body<internal::star<Rule>> : Compound<Form::kMany, Rule> {};
template <typename Rule>
struct Body<internal::plus<Rule>> : Compound<Form::kSome, Rule> {};
template <typename Rule>
struct Body<internal::at<Rule>> : Compound<Form::kAhead, Rule> {};
template <typename Rule>
struct Body<internal::not_at<Rule>> : Compound<Form::kNotAhead, Rule> {};

template <unsigned count, typename Rule>
struct Body<internal::rep<count, Rule>> {
    static Expression make(Grammar& grammar) {
        return compound(Form::kRepeat, expressions_of<Rule>(grammar), static_cast<int>(count));
    }
};

template <char... cs>
struct Body<internal::string<cs...>> {
    static Expression make(Grammar&) {
        const std::string characters{cs...};
        return characters == "\xEF\xBB\xBF" ? described("the bytes EF BB BF") : text(characters);
    }
};

template <typename Peek, char... cs>
struct Body<internal::one<internal::result_on_found::success, Peek, cs...>> {
    static Expression make(Grammar&) { return compound(Form::kChoice, {show_character(cs)...}); }
};

template <typename Peek, char... cs>
struct Body<internal::one<internal::result_on_found::failure, Peek, cs...>> {
    static Expression make(Grammar&) {
        std::string words = "any byte but";
        std::string_view between = " ";
        for (const char c : {cs...}) {
            words.append(between).append(show_character(c).text);
            between = ", ";
        }
        return described(words);
    }
};

template <typename Peek, char low, char high>
struct Body<internal::range<internal::result_on_found::success, Peek, low, high>> {
    static Expression make(Grammar&) { return described(std::string{low, '-', high}); }
};

template <typename Peek, char... cs>
struct Body<internal::ranges<Peek, cs...>> {
    static Expression make(Grammar&) {
        constexpr std::array<char, sizeof...(cs)> kEnds = {cs...};
        std::string words;
        for (std::size_t i = 0; i + 1 < kEnds.size(); i += 2) {
            if (i > 0) words += ", ";
            words += std::string{kEnds[i], '-', kEnds[i + 1]};
        }
        return described(words);
    }
};

template <>
struct Body<internal::eof> {
    static Expression make(Grammar&) { return described("end of the file"); }
};

template <grammar::lexical::ByteClass byte_class>
struct Body<grammar::lexical::byte_of<byte_class>> {
    static Expression make(Grammar&) { return described(describe(byte_class)); }
};

template <grammar::structure::Symbol symbol>
struct Body<grammar::structure::token<symbol>> {
    static Expression make(Grammar&) {
        if constexpr (symbol == grammar::structure::Symbol::kOpen) return text("{");
        if constexpr (symbol == grammar::structure::Symbol::kClose) return text("}");
        return described(describe(symbol));
    }
};

template <>
struct Body<grammar::structure::recover> {
    static Expression make(Grammar&) { return described("back to a missing brace"); }
};

template <>
struct Body<grammar::structure::recover_at_end> {
    static Expression make(Grammar&) { return described("back to a missing brace"); }
};

}  // namespace pegtl_types

/// All rules that `Start` reaches, itself first.
template <typename Start>
Grammar grammar_of() {
    Grammar grammar;
    pegtl_types::add_rule<Start>(grammar);
    return grammar;
}

}  // namespace cobble::docs
