// SPDX-License-Identifier: MIT
#include "frontend/ast/name_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/ast/edits.hpp"
#include "frontend/ast/text_errors.hpp"
#include "frontend/lex/words.hpp"
#include "frontend/names/describe.hpp"
#include "frontend/names/dialects.hpp"
#include "frontend/names/suggest.hpp"

namespace cobble::frontend {
namespace {

using grammar::BlockRow;
using grammar::FieldId;
using grammar::FieldRow;
using grammar::Layout;
using source::Diagnostic;
using source::DiagnosticCode;
using source::Severity;

const DiagnosticCode kUnexpectedArgument(
    "unexpected-argument", Severity::kError, "a block has no argument of this name",
    "Each block takes its own arguments. One that it does not know is not read, so what it was "
    "meant to say is lost. Names are spelt exactly, capital letters included.",
    "PerspectiveCamera {\n    center 0 0 10\n    direction 0 0 -1\n    up 0 1 0\n    angle 30\n"
    "    angles 30\n}\n",
    "Write the argument's right name, move it to the block that it belongs in, or remove it.");

const DiagnosticCode kUnknownName(
    "unknown-name", Severity::kError, "a name is no word of the language",
    "Blocks are found by their names. One that the language does not know is left out, with all "
    "that stands in it.",
    "Group {\n    Spere {\n        center 0 0 0\n        radius 1\n    }\n}\n",
    "Write the right name. For a word of another dialect the message says what to use today. "
    "Comments begin with `//`.");

const DiagnosticCode kMisplacedBlock("misplaced-block", Severity::kError,
                                     "a block stands where it may not",
                                     "Each kind of block has its place: lights in Lights, "
                                     "materials in Materials, objects in a Group "
                                     "or Transform. Elsewhere it has no effect.",
                                     "Lights {\n    Noise {\n        octaves 4\n    }\n}\n",
                                     "Move the block to where the message says it belongs.");

const DiagnosticCode kUnexpectedBraces(
    "unexpected-braces", Severity::kError, "values stand in braces where none belong",
    "Transforms such as Translate, MaterialIndex, and all arguments take their values without "
    "braces; only Rotate and Matrix4f have them. The language of 2003 had braces there.",
    "Transform {\n    Translate { 1 0 0 }\n    Sphere {\n        center 0 0 0\n        radius 1\n  "
    "  "
    "}\n}\n",
    "Remove the braces: `Translate 1 0 0`.");

const DiagnosticCode kBadLabel(
    "bad-label", Severity::kError, "a label cannot be used here",
    "A label is a letter or underscore and then letters, digits, underscores and hyphens, without "
    "quotes, no word of the language, and on the line of the block's name. Cameras, lights, "
    "materials, objects, Group and Transform "
    "may have one.",
    "Materials {\n    PhongMaterial 1st {\n    }\n}\n",
    "Choose a label such as `first`, or remove it.");

std::string place_of(const BlockRow* around) {
    return around == nullptr ? std::string("outside any block")
                             : fmt::format("in {}", around->name);
}

// Every block of the vocabulary that may stand in one place.
std::vector<const BlockRow*> blocks_for(const BlockRow* around) {
    std::vector<const BlockRow*> found;
    for (const BlockRow& row : grammar::blocks()) {
        const bool fits = around == nullptr ? grammar::may_stand_at_top(row.id)
                                            : grammar::may_stand_in(row.id, around->id);
        if (fits) found.push_back(&row);
    }
    return found;
}

bool has_named_fields(const BlockRow& row) {
    return row.layout == Layout::kFields || row.layout == Layout::kList;
}

// The blocks that take an argument of this name.
std::vector<std::string_view> blocks_with_field(std::string_view name) {
    std::vector<std::string_view> found;
    for (const BlockRow& row : grammar::blocks()) {
        if (grammar::find_field(row.id, name) != nullptr) found.push_back(row.name);
    }
    return found;
}

std::vector<std::string_view> homes_of(const BlockRow& row) {
    std::vector<std::string_view> found;
    for (const BlockRow& home : grammar::blocks()) {
        if (grammar::may_stand_in(row.id, home.id)) found.push_back(home.name);
    }
    return found;
}

std::string did_you_mean(std::span<const std::string_view> names) {
    return names.size() == 1 ? fmt::format("did you mean '{}'?", names[0])
                             : fmt::format("did you mean one of {}?", quoted_list(names));
}

// What a block's name was meant as, where that block may not stand: a near name, as `Material` for
// `Materials`, or one that it begins, as `Material 0` for `MaterialIndex 0`.
std::vector<std::string_view> meant_names(const BlockRow& row, const BlockRow* around,
                                          bool has_braces) {
    std::vector<std::string_view> names;
    for (const BlockRow* candidate : blocks_for(around)) {
        if (has_braces == (candidate->layout != Layout::kInline)) names.push_back(candidate->name);
    }
    auto near = near_names(row.name, names);
    if (!near.empty()) return near;
    std::erase_if(names, [&row](std::string_view name) { return !name.starts_with(row.name); });
    return names;
}

class UnknownName {
  public:
    UnknownName(const CstNode& node, const BlockRow* around, std::span<const FieldId> present,
                Reporter& reporter)
        : node_(node),
          around_(around),
          present_(present),
          reporter_(reporter),
          word_(reporter.text({node.first_token})),
          is_block_(static_cast<NodeKind>(node.kind) == NodeKind::kBlock) {}

    void report() {
        const bool in_braces =
            is_block_ && around_ != nullptr && grammar::find_field(around_->id, word_) != nullptr;
        if (in_braces) return report_inline_braces(node_, reporter_);
        const bool argument = !is_block_ && around_ != nullptr;
        Diagnostic& finding = reporter_.add(
            argument ? kUnexpectedArgument : kUnknownName, TokenId{node_.first_token},
            argument ? fmt::format("unexpected argument {} {}", quoted(word_), place_of(around_))
                     : fmt::format("unknown {} {} {}", is_block_ ? "block" : "name", quoted(word_),
                                   place_of(around_)));
        if (add_dialect(finding)) return;
        if (!add_near_names(finding)) add_other_notes(finding);
        if (!is_block_ && finding.fixes.empty()) add_removal(finding);
    }

  private:
    bool add_dialect(Diagnostic& finding) {
        const std::string_view block = around_ == nullptr ? std::string_view{} : around_->name;
        const DialectWord* entry = find_dialect_word(word_, block);
        if (entry == nullptr) return false;
        finding.notes.push_back(
            fmt::format("a word of {}: {}", name_of(entry->dialect), entry->advice));
        auto fix = dialect_fix(*entry, finding.span.source, reporter_.tokens(),
                               TokenId{node_.first_token}, TokenId{node_.end_token});
        if (fix) finding.fixes.push_back(std::move(*fix));
        return true;
    }

    [[nodiscard]] std::vector<std::string_view> candidates() const {
        std::vector<std::string_view> names;
        for (const BlockRow* row : blocks_for(around_)) {
            if (is_block_ == (row->layout != Layout::kInline)) names.push_back(row->name);
        }
        if (is_block_ || around_ == nullptr || !has_named_fields(*around_)) return names;
        for (const FieldRow& field : grammar::fields_of(around_->id)) names.push_back(field.name);
        return names;
    }

    [[nodiscard]] bool is_present(std::string_view name) const {
        return std::ranges::any_of(present_,
                                   [name](FieldId id) { return grammar::row(id).name == name; });
    }

    bool add_near_names(Diagnostic& finding) {
        const auto near = near_names(word_, candidates());
        if (near.empty()) return false;
        finding.notes.push_back(did_you_mean(near));
        if (is_present(near[0])) return true;
        finding.fixes.push_back({fmt::format("write '{}'", near[0]),
                                 near.size() == 1,
                                 {{finding.span, std::string(near[0])}}});
        return true;
    }

    void add_other_notes(Diagnostic& finding) const {
        const auto others = blocks_with_field(word_);
        if (!others.empty()) {
            finding.notes.push_back(
                fmt::format("{} belongs in {}", quoted(word_), quoted_list(others)));
        } else if (word_.find_first_of("#;%*!/-") == 0) {
            finding.notes.emplace_back("comments begin with //");
        } else if (around_ != nullptr && has_named_fields(*around_)) {
            if (!is_block_) finding.notes.push_back(what_it_takes(around_->id));
        }
    }

    void add_removal(Diagnostic& finding) const {
        const TokenId first{node_.first_token};
        const TokenId last{node_.end_token - 1};
        const ByteRange own{finding.span.begin, reporter_.tokens().range(last).end};
        const std::string_view text =
            reporter_.tokens().text.substr(own.begin, own.end - own.begin);
        const ByteRange removed = removal_range(reporter_.tokens(), first, last);
        finding.fixes.push_back(
            {fmt::format("remove {}", quoted(text)), false, {{reporter_.span(removed), ""}}});
    }

    const CstNode& node_;
    const BlockRow* around_;
    std::span<const FieldId> present_;
    Reporter& reporter_;
    std::string_view word_;
    bool is_block_;
};

}  // namespace

void report_unknown_name(const CstNode& node, const BlockRow* around,
                         std::span<const FieldId> present, Reporter& reporter) {
    if (report_invisible({node.first_token}, reporter)) return;
    UnknownName(node, around, present, reporter).report();
}

bool report_misplaced(const Cst& cst, NodeId block, const BlockRow& row, const BlockRow* around,
                      Reporter& reporter) {
    const CstNode& node = cst.node(block);
    Diagnostic& finding =
        reporter.add(kMisplacedBlock, TokenId{node.first_token},
                     fmt::format("'{}' may not stand {}", row.name, place_of(around)));
    const bool has_braces = open_brace_of(reporter.tokens(), node).valid();
    const auto meant = meant_names(row, around, has_braces);
    if (!meant.empty()) {
        finding.notes.push_back(did_you_mean(meant));
        finding.fixes.push_back({fmt::format("write '{}'", meant[0]),
                                 meant.size() == 1,
                                 {{finding.span, std::string(meant[0])}}});
        return true;
    }
    const auto homes = homes_of(row);
    std::string belongs = homes.empty() ? std::string() : "in " + quoted_list(homes);
    if (grammar::may_stand_at_top(row.id)) {
        belongs = homes.empty() ? "at the top level" : "at the top level or " + belongs;
    }
    finding.notes.push_back(fmt::format("'{}' belongs {}", row.name, belongs));
    return false;
}

void report_inline_braces(const CstNode& node, Reporter& reporter) {
    const TokenId name{node.first_token};
    Diagnostic& finding = reporter.add(
        kUnexpectedBraces, name,
        fmt::format("{} takes its values without braces", quoted(reporter.text(name))));
    const TokenId open = open_brace_of(reporter.tokens(), node);
    const TokenId close{node.end_token - 1};
    if (node.unclosed != 0 || open.value != node.first_token + 1) return;
    if (close.value == open.value + 1) return;  // nothing between them
    const bool touches =
        reporter.tokens().range(open).end == reporter.tokens().range({open.value + 1}).begin;
    finding.fixes.push_back(
        {"remove the braces",
         true,
         {{reporter.span(removal_range(reporter.tokens(), open, open)), touches ? " " : ""},
          {reporter.span(removal_range(reporter.tokens(), close, close)), ""}}});
}

bool report_word_as_label(TokenId label, Reporter& reporter) {
    const std::string_view text = reporter.text(label);
    if (!grammar::is_vocabulary_name(text)) return false;
    Diagnostic& finding =
        reporter.add(kBadLabel, label,
                     fmt::format("'{}' is a word of the language and cannot be a label", text));
    // Words of the language differ in more than the capital letter that the names of blocks have.
    std::string other(text);
    if (other[0] >= 'A' && other[0] <= 'Z') other[0] = static_cast<char>(other[0] - 'A' + 'a');
    if (grammar::is_vocabulary_name(other)) other += '_';
    finding.fixes.push_back({fmt::format("write '{}'", other), false, {{finding.span, other}}});
    return true;
}

bool accept_label(const BlockRow& row, TokenId label, Reporter& reporter) {
    const std::string_view text = reporter.text(label);
    if (!row.labelled) {
        Diagnostic& finding = reporter.add(
            kBadLabel, label, fmt::format("'{}' takes no label, found {}", row.name, quoted(text)));
        const ByteRange removed = removal_range(reporter.tokens(), label, label);
        finding.fixes.push_back({"remove the label", true, {{reporter.span(removed), ""}}});
        return false;
    }
    if (report_invisible(label, reporter)) return false;
    if (report_word_as_label(label, reporter)) return false;
    if (reporter.tokens().kind(label) == TokenKind::kWord && is_label(text)) {
        if (!reporter.tokens().line_ends_after({label.value - 1})) return true;
        reporter.add(kBadLabel, label,
                     fmt::format("the label {} does not stand on the line of its '{}'",
                                 quoted(text), row.name));
        return true;
    }
    reporter.add(kBadLabel, label, fmt::format("{} cannot be a label", quoted(text)))
        .notes.emplace_back(
            "a label is a letter or underscore, then letters, digits, underscores "
            "and hyphens");
    return false;
}

}  // namespace cobble::frontend
