// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <iterator>

#include "tools/docs/from_pegtl.hpp"
#include "tools/docs/pages.hpp"

namespace cobble::docs {

std::string describe(grammar::structure::Symbol symbol) {
    using enum grammar::structure::Symbol;
    switch (symbol) {
        case kOpen:
            return "{";
        case kClose:
            return "}";
        case kEnd:
            return "end of the file";
        case kName:
            return "a word";
        case kFieldName:
            return "a word that names a field of the open block";
        case kInlineName:
            return "a word that names a block without braces";
        case kBlockName:
            return "a word that names a block with braces";
        case kLabel:
            return "a label on the same line, before a {";
        case kBareLabel:
            return "a label that no { follows";
        case kMember:
            return "what may stand in the block just named";
        case kLiteral:
            return "a number or a colour";
        case kWordValue:
            return "a word or string that is the field's value";
        case kOddValue:
            return "a malformed number, or a word where numbers are due";
        case kBareValue:
            return "what a positional block holds: no block's name";
        case kStrayValue:
            return "a number, colour, string or malformed number";
        case kProse:
            return "a word or string on the same line";
    }
    return {};
}

std::string describe(grammar::lexical::ByteClass byte_class) {
    using enum grammar::lexical::ByteClass;
    switch (byte_class) {
        case kChunk:
            return "any byte but white space, {, } and \"";
        case kWhite:
            return "space, tab, CR, LF, VT or FF";
        case kDelimiter:
            return "{, } or \"";
    }
    return {};
}

Expression show_character(char c) {
    switch (c) {
        case '\n':
            return described("LF");
        case '\r':
            return described("CR");
        default:
            return text(std::string(1, c));
    }
}

namespace {

using grammar::ValueType;

/// The rule for values of a type.
std::string value_rule(ValueType type) {
    switch (type) {
        case ValueType::kNumber:
            return "number";
        case ValueType::kInteger:
            return "integer";
        case ValueType::kCount:
            return "count";
        case ValueType::kVector2:
            return "vector2";
        case ValueType::kVector3:
            return "vector3";
        case ValueType::kColor:
            return "rgb";
        case ValueType::kNumbers4:
            return "numbers4";
        case ValueType::kNumbers16:
            return "numbers16";
        case ValueType::kImagePath:
        case ValueType::kFolderPath:
        case ValueType::kMeshPath:
            return "path";
        case ValueType::kMaterialRef:
            return "material";
        case ValueType::kTextureFilter:
            return "filter";
    }
    return {};
}

Expression children_of(grammar::BlockMask parent) {
    std::vector<Expression> names;
    for (const grammar::BlockRow& row : grammar::blocks()) {
        if ((row.parents & parent) != 0) names.push_back(rule(std::string(row.name)));
    }
    return compound(Form::kChoice, std::move(names));
}

Expression block_body(const grammar::BlockRow& row) {
    using grammar::Layout;
    const auto fields = grammar::fields_of(row.id);
    std::vector<Expression> parts{text(std::string(row.name))};
    if (row.layout == Layout::kInline) {
        parts.push_back(rule(value_rule(fields[0].type)));
        return compound(Form::kSequence, std::move(parts));
    }
    if (row.labelled) parts.push_back(compound(Form::kOptional, {rule("label")}));
    parts.push_back(text("{"));
    if (row.layout == Layout::kPositional) {
        parts.push_back(rule(value_rule(fields[0].type)));
    } else {
        std::vector<Expression> members;
        for (const grammar::FieldRow& field : fields) {
            members.push_back(compound(
                Form::kSequence, {text(std::string(field.name)), rule(value_rule(field.type))}));
        }
        Expression children = children_of(grammar::mask_of(row.id));
        if (children.form == Form::kRule) {
            members.push_back(std::move(children));
        } else {
            for (Expression& child : children.parts) members.push_back(std::move(child));
        }
        parts.push_back(compound(Form::kMany, {compound(Form::kChoice, std::move(members))}));
    }
    parts.push_back(text("}"));
    return compound(Form::kSequence, std::move(parts));
}

Grammar value_grammar() {
    const auto repeated = [](int count) {
        return compound(Form::kRepeat, {rule("number")}, count);
    };
    return {
        {"integer", described("a number without a fractional part")},
        {"count", described("an integer that equals the number of members")},
        {"vector2", repeated(2)},
        {"vector3", repeated(3)},
        {"rgb", compound(Form::kChoice, {repeated(3), rule("color")})},
        {"numbers4", repeated(4)},
        {"numbers16", repeated(16)},
        {"path", compound(Form::kChoice, {rule("word"), rule("string")})},
        {"filter", compound(Form::kChoice, {text("nearest"), text("bilinear")})},
        {"material", compound(Form::kChoice, {rule("integer"), rule("label")})},
        {"label", described("[A-Za-z_][A-Za-z0-9_-]*, no name of the language")},
    };
}

constexpr std::string_view kIntroduction = R"(# The grammar

Generated by `cobble-docs` from the grammars themselves (`grammar/lexical.hpp`,
`grammar/structure.hpp`) and the vocabulary (`grammar/vocabulary.def`); do not edit.

Read it so: `"x"` is that very text, `<...>` describes a byte or token in words, `x?` is `x` or
nothing, `x*` any number of `x`, `x+` one or more, `x{3}` three; `x | y` is the first of the two that
matches; `&x` says that `x` must come next and `!x` that it must not, and neither consumes it.

)";

void add_section(std::string& page, std::string_view title, std::string_view what,
                 const Grammar& rules, std::string_view picture) {
    fmt::format_to(std::back_inserter(page), "## {}\n\n{}\n\n```ebnf\n", title, what);
    for (const Rule& rule : rules) page += ebnf(rule) + "\n";
    page += "```\n\n";
    if (!picture.empty()) {
        fmt::format_to(std::back_inserter(page), "![{}](railroad/{})\n\n", title, picture);
    }
}

}  // namespace

Grammar block_grammar() {
    Grammar grammar;
    grammar.push_back({"scene", compound(Form::kMany, {children_of(grammar::kFileMask)})});
    for (const grammar::BlockRow& row : grammar::blocks()) {
        grammar.push_back({std::string(row.name), block_body(row)});
    }
    return grammar;
}

std::vector<Page> grammar_pages() {
    const Grammar lexical = grammar_of<grammar::lexical::text>();
    const Grammar structure = grammar_of<grammar::structure::file>();
    const Grammar values = value_grammar();
    const Grammar blocks = block_grammar();
    Page page{"grammar/grammar.ebnf.md", std::string(kIntroduction)};
    add_section(
        page.text, "Blocks",
        "What a right scene consists of. Blocks and fields stand in any order; which fields "
        "must be there and which may be repeated is told in [LANGUAGE.md](LANGUAGE.md), "
        "which also shows each rule as a diagram.",
        blocks, "");
    add_section(page.text, "Values", "What is written after a name.", values, "values.svg");
    add_section(
        page.text, "Tokens to a tree",
        "How the parser reads tokens. Every sequence of them matches `file`: what is wrong is "
        "an `item` too. Nesting is not in the rules but on a stack, which `block_head` pushes "
        "and `block_close` pops, so that no depth of it is too much.",
        structure, "structure.svg");
    add_section(page.text, "Bytes to tokens",
                "How the lexer reads bytes. Every file matches `text`.", lexical, "lexical.svg");
    page.text.pop_back();

    std::vector<Page> pages{std::move(page)};
    pages.push_back({"grammar/railroad/values.svg", railroad(values)});
    pages.push_back({"grammar/railroad/structure.svg", railroad(structure)});
    pages.push_back({"grammar/railroad/lexical.svg", railroad(lexical)});
    for (const Rule& rule : blocks) {
        pages.push_back({"grammar/railroad/" + rule.name + ".svg", railroad({rule})});
    }
    return pages;
}

}  // namespace cobble::docs
