// SPDX-License-Identifier: MIT
#include "frontend/ast/brace_errors.hpp"

#include <fmt/format.h>

#include "frontend/ast/text_errors.hpp"
#include "frontend/parse/layout.hpp"

namespace cobble::frontend {
namespace {

using source::Diagnostic;
using source::DiagnosticCode;
using source::Edit;
using source::Severity;

const DiagnosticCode kMissingBrace(
    "missing-brace", Severity::kError, "a brace is missing",
    "Blocks begin with { and end with }. Where one is missing, what follows would belong to the "
    "wrong block. The place is found by what may stand where (a light cannot stand in a light) "
    "and, "
    "where several blocks could be the open one, by the indentation.",
    "Lights {\n    PointLight {\n        position 0 5 0\n        color 1 1 1\n}\n",
    "Put the brace where the message points to.");

const DiagnosticCode kExtraBrace(
    "extra-brace", Severity::kError, "a } closes nothing",
    "Every } ends the block that was opened last. This one has no block to end, or ends one whose "
    "members go on behind it.",
    "Sphere {\n    center 0 0 0\n    radius 1\n}\n}\n",
    "Remove the brace, or put the { back that it belonged to.");

const DiagnosticCode kNamelessBlock(
    "nameless-block", Severity::kError, "a { has no name before it",
    "Every block begins with the name of what it describes. Without it nobody can tell what the "
    "block's contents mean, so they are not looked at.",
    "Group {\n    {\n        center 0 0 0\n        radius 1\n    }\n}\n",
    "Write the block's name before its {, or remove the brace and its }.");

const DiagnosticCode kStrayValue("stray-value", Severity::kError, "a value belongs to no field",
                                 "Values stand behind the name of a field. A value without a name "
                                 "has no meaning; often the name "
                                 "was deleted by mistake.",
                                 "Sphere {\n    0 0 0\n    radius 1\n}\n",
                                 "Write the field's name before the value, or remove the value.");

// Where something is missing: the empty range behind a token.
ByteRange behind(const Tokens& tokens, TokenId token) {
    const std::uint32_t end = tokens.range(token).end;
    return {end, end};
}

std::string_view line_end_of(std::string_view text) {
    const std::size_t at = text.find_first_of("\r\n");
    if (at == std::string_view::npos || text[at] == '\n') return "\n";
    return text.substr(at, 2) == "\r\n" ? "\r\n" : "\r";
}

// A } behind the last token of a block: on a line of its own, indented like the block's name, if
// the block goes over several lines.
Edit closing_edit(const CstNode& block, Reporter& reporter) {
    const Tokens& tokens = reporter.tokens();
    const TokenId last{block.end_token - 1};
    const std::uint32_t begin = tokens.tokens[block.first_token].begin;
    const ByteRange place = behind(tokens, last);
    const std::string_view text = tokens.text.substr(begin, place.end - begin);
    const auto indent = indent_of(tokens, block.first_token);
    if (!indent || text.find_first_of("\r\n") == std::string_view::npos) {
        return {reporter.span(place), " }"};
    }
    return {reporter.span(place), fmt::format("{}{}}}", line_end_of(tokens.text), *indent)};
}

std::string_view name_of(const CstNode& block, const Reporter& reporter) {
    return reporter.text({block.first_token});
}

}  // namespace

void report_missing_braces(const Cst& cst, NodeId id, Reporter& reporter) {
    const CstNode& block = cst.node(id);
    const Tokens& tokens = reporter.tokens();
    const bool has_open = open_brace_of(tokens, block).valid();
    const bool has_members = cst.first_child(id).valid();
    const TokenId name{block.first_token};
    const std::string shown = quoted(name_of(block, reporter));
    if (has_open) {
        const TokenId last{block.end_token - 1};
        Diagnostic& finding = reporter.add(kMissingBrace, behind(tokens, last),
                                           fmt::format("missing '}}' of {}", shown));
        finding.related.push_back({reporter.span(name), fmt::format("{} begins here", shown)});
        finding.fixes.push_back({"insert '}'", true, {closing_edit(block, reporter)}});
        return;
    }
    const TokenId label = label_of(tokens, block);
    const ByteRange place = behind(tokens, label.valid() ? label : name);
    if (!has_members) {
        reporter.add(kMissingBrace, place, fmt::format("missing '{{' after {}", shown));
        return;
    }
    const bool both = block.unclosed != 0;
    Diagnostic& finding =
        reporter.add(kMissingBrace, place,
                     both ? fmt::format("missing braces around the contents of {}", shown)
                          : fmt::format("missing '{{' after {}", shown));
    std::vector<Edit> edits = {{reporter.span(place), " {"}};
    if (both) edits.push_back(closing_edit(block, reporter));
    finding.fixes.push_back({both ? "insert the braces" : "insert '{'", true, std::move(edits)});
}

void report_extra_brace(const CstNode& node, std::string_view where, Reporter& reporter) {
    const TokenId brace{node.first_token};
    Diagnostic& finding = reporter.add(
        kExtraBrace, brace,
        where.empty() ? std::string("this '}' has no '{' that it could close")
                      : fmt::format("this '}}' is one too many, {} goes on after it", where));
    finding.fixes.push_back({"remove '}'", true, {{reporter.span(brace), ""}}});
}

void report_nameless(const CstNode& node, Reporter& reporter) {
    const TokenId brace{node.first_token};
    Diagnostic& finding =
        reporter.add(kNamelessBlock, brace,
                     node.unclosed != 0 ? "this '{' has neither a name before it nor a '}' after it"
                                        : "this '{' has no name before it");
    const bool alone = node.end_token == node.first_token + 1;
    if (alone) finding.fixes.push_back({"remove '{'", true, {{reporter.span(brace), ""}}});
}

void report_stray_values(const CstNode& node, std::string_view where, Reporter& reporter) {
    const TokenId first{node.first_token};
    const TokenId last{node.end_token - 1};
    for (std::uint32_t i = first.value; i <= last.value; ++i) {
        if (report_invisible({i}, reporter)) return;
    }
    const source::Span span = reporter.span(first, last);
    const bool one = first == last;
    const std::string place =
        where.empty() ? std::string("outside any block") : fmt::format("in {}", where);
    Diagnostic& finding = reporter.add(kStrayValue, ByteRange{span.begin, span.end},
                                       one ? fmt::format("the value {} {} belongs to no field",
                                                         quoted(reporter.text(first)), place)
                                           : fmt::format("these {} values {} belong to no field",
                                                         node.end_token - node.first_token, place));
    finding.fixes.push_back({one ? "remove the value" : "remove the values", false, {{span, ""}}});
}

}  // namespace cobble::frontend
