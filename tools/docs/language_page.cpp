// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "tools/docs/pages.hpp"
#include "tools/docs/value_words.hpp"

namespace cobble::docs {
namespace {

std::string range_words(const grammar::Range& range) {
    const bool low = std::isfinite(range.low);
    const bool high = std::isfinite(range.high);
    std::string words;
    if (low && high) {
        words = fmt::format("{}{}, {}{}", range.low_open ? "(" : "[", range.low, range.high,
                            range.high_open ? ")" : "]");
    } else if (low) {
        words = fmt::format("{} {}", range.low_open ? ">" : "≥", range.low);
    } else if (high) {
        words = fmt::format("{} {}", range.high_open ? "<" : "≤", range.high);
    }
    if (range.zero_excluded) words += words.empty() ? "not 0" : ", not 0";
    if (std::isfinite(range.warn_above)) {
        words += fmt::format("{}a warning above {}", words.empty() ? "" : "; ", range.warn_above);
    }
    return words;
}

std::string needed_words(const grammar::FieldRow& field) {
    std::string words = field.presence == grammar::Presence::kRequired   ? "required"
                        : field.presence == grammar::Presence::kExpected ? "a warning without"
                                                                         : "";
    if (field.repeat == grammar::Repeat::kLastWins) {
        words += words.empty() ? "" : "; ";
        words += "the last one counts";
    } else if (field.repeat == grammar::Repeat::kTwice) {
        words += words.empty() ? "" : "; ";
        words += "twice";
    }
    return words;
}

std::string link(std::string_view block) {
    std::string anchor(block);
    for (char& c : anchor) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return fmt::format("[`{}`](#{})", block, anchor);
}

std::string list_of(const std::vector<std::string>& words) {
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) list += i + 1 == words.size() ? " or " : ", ";
        list += words[i];
    }
    return list;
}

std::string parents_of(const grammar::BlockRow& row) {
    std::vector<std::string> words;
    if (grammar::may_stand_at_top(row.id)) words.emplace_back("at the top level of the file");
    std::vector<std::string> blocks;
    for (const grammar::BlockRow& parent : grammar::blocks()) {
        if (grammar::may_stand_in(row.id, parent.id)) blocks.push_back(link(parent.name));
    }
    if (!blocks.empty()) words.push_back("in " + list_of(blocks));
    return list_of(words);
}

void add_fields(std::string& page, const grammar::BlockRow& row) {
    const auto fields = grammar::fields_of(row.id);
    if (fields.empty()) return;
    const bool named =
        row.layout == grammar::Layout::kFields || row.layout == grammar::Layout::kList;
    page += named ? "| field | value | unit | range | default | | meaning |\n"
                    "|---|---|---|---|---|---|---|\n"
                  : "| value | unit | range | default | | meaning |\n"
                    "|---|---|---|---|---|---|\n";
    for (const grammar::FieldRow& field : fields) {
        const std::string fallback =
            field.fallback.empty() ? "" : fmt::format("`{}`", field.fallback);
        if (named) fmt::format_to(std::back_inserter(page), "| `{}` ", field.name);
        fmt::format_to(std::back_inserter(page), "| {} | {} | {} | {} | {} | {} |\n",
                       value_words(field.type).words, field.unit, range_words(field.range),
                       fallback, needed_words(field), field.doc);
    }
    page += "\n";
}

void add_block(std::string& page, const grammar::BlockRow& row, const ExampleSource& examples) {
    fmt::format_to(std::back_inserter(page), "### {}\n\n{}\n\nStands {}.{}\n\n", row.name, row.doc,
                   parents_of(row), row.labelled ? " May carry a [label](#labels)." : "");
    fmt::format_to(std::back_inserter(page), "![{0}](railroad/{0}.svg)\n\n", row.name);
    add_fields(page, row);
    if (const auto example = examples(row.name)) {
        fmt::format_to(std::back_inserter(page), "```\n{}```\n\n", shown_part(*example));
    }
}

/// The heading under which a block stands. No heading is a block's name, so that links are clear.
std::string_view part_of(const grammar::BlockRow& row) {
    using enum grammar::Role;
    switch (row.role) {
        case kCamera:
            return "The view";
        case kSection:
            // A section stands with what it holds.
            for (const grammar::BlockRow& child : grammar::blocks()) {
                if (grammar::may_stand_in(child.id, row.id)) return part_of(child);
            }
            return "Surroundings";
        case kLight:
            return "Light sources";
        case kMaterial:
        case kNoise:
            return "Surfaces";
        case kGroup:
        case kMaterialIndex:
        case kObject:
            return "Objects and groups";
        case kTransform:
        case kMove:
        case kMotion:
            return "Placing and moving";
    }
    return {};
}

constexpr std::string_view kIntroduction = R"(# The scene language

Generated by `cobble-docs` from the vocabulary (`grammar/vocabulary.def`); do not edit. The exact
grammar is in [grammar.ebnf.md](grammar.ebnf.md).

A scene is a text file of blocks: `Name { ... }`. A block holds fields, each a name with its values,
and other blocks. The order of fields is free, and so is that of the sections; the order of blocks
within a list (lights, materials, objects, transforms) is part of what the scene says. Line breaks
and blanks mean nothing, except that a label stands on the line of its block's name, and that a
word on the line after a field's name is its value only if it stands there alone.

## Values

| what | how it is written |
|---|---|
| number | `5`, `-.5`, `5.`, `1e-3`: decimal, with a point and an exponent if wanted |
| integer | a number without a fractional part |
| colour | three numbers, red, green and blue, or `#rrggbb` in hexadecimal |
| path | a word, or a `"string"` where it holds blanks, braces or `//`, or is a name of the language; relative to the scene file |

`//` begins a comment, up to the end of the line, where a word could begin or right after a number
or colour. Within a word it is text: `tex//a.bmp`.

## Labels

`PhongMaterial stone { ... }` names a material, a light, an object, a group, a transform or a
camera, so that other places (`MaterialIndex stone`) and people can speak of it. A label begins with
a letter or `_` and goes on with letters, digits, `_` and `-`; it is no name of the language, stands
on the line of the block's name, and is given once for each kind of thing.

)";

}  // namespace

std::string shown_part(std::string_view example) {
    std::string result;
    bool shown = false;
    bool marked = false;
    std::size_t indent = 0;
    while (!example.empty()) {
        std::string_view line = example.substr(0, example.find('\n') + 1);
        if (line.empty()) line = example;
        example.remove_prefix(line.size());
        const std::size_t begin = line.find_first_not_of(' ');
        const std::string_view rest = begin == std::string_view::npos ? line : line.substr(begin);
        if (rest == "// example\n") {
            result.clear();
            shown = true;
            marked = true;
            indent = begin;
        } else if (rest == "// end\n") {
            shown = false;
        } else if (shown || !marked) {
            result +=
                begin != std::string_view::npos && begin >= indent ? line.substr(indent) : line;
        }
    }
    return result;
}

Page language_page(const ExampleSource& examples) {
    Page page{"grammar/LANGUAGE.md", std::string(kIntroduction)};
    std::string_view part;
    for (const grammar::BlockRow& row : grammar::blocks()) {
        const std::string_view next = part_of(row);
        if (next != part) {
            part = next;
            fmt::format_to(std::back_inserter(page.text), "## {}\n\n", part);
        }
        add_block(page.text, row, examples);
    }
    page.text.pop_back();
    return page;
}

std::vector<Page> all_pages(const ExampleSource& examples) {
    std::vector<Page> pages = grammar_pages();
    pages.push_back(language_page(examples));
    pages.push_back(diagnostics_page());
    return pages;
}

}  // namespace cobble::docs
