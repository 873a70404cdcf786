// SPDX-License-Identifier: MIT
#include "frontend/editor/completion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "frontend/editor/hover.hpp"
#include "frontend/editor/materials.hpp"
#include "frontend/editor/members.hpp"
#include "frontend/editor/row_words.hpp"
#include "frontend/editor/typing.hpp"

namespace cobble::frontend::editor {
namespace {

using grammar::BlockRow;
using grammar::FieldRow;
using grammar::Layout;
using grammar::Role;
using grammar::ValueType;

// What is missing comes first, then what a block is mostly made of.
enum Rank : std::uint32_t { kDue, kRequired, kExpected, kUsual, kRest };

/// A line for people who see it as it is.
std::string without_marks(std::string text) {
    std::erase(text, '`');
    return text;
}

/// "An infinite plane: the points P with P . normal = offset".
std::string first_sentence(std::string_view doc) {
    std::size_t end = doc.find('.');
    while (end != std::string_view::npos && end > 0 && doc[end - 1] == ' ') {
        end = doc.find('.', end + 1);
    }
    return without_marks(std::string(doc.substr(0, end)));
}

std::string joined(const std::vector<std::string>& paragraphs) {
    std::string text;
    for (const std::string& paragraph : paragraphs) {
        if (!text.empty()) text += "\n\n";
        text += paragraph;
    }
    return text;
}

class Completer {
  public:
    Completer(const CheckedScene& scene, std::uint32_t offset)
        : scene_(scene), offset_(offset), typing_(typing_at(scene, offset)) {}

    Completion run() {
        if (typing_.nothing) return {};
        if (typing_.wants_value()) add_values(*typing_.field);
        // Inside quotes there is a path or nothing.
        if (typing_.takes_member() && !in_string()) add_members();
        std::ranges::stable_sort(result_.items, {}, &CompletionItem::rank);
        return std::move(result_);
    }

  private:
    [[nodiscard]] TokenKind word_kind() const {
        return typing_.word.valid() ? scene_.tokens.kind(typing_.word) : TokenKind::kWord;
    }
    [[nodiscard]] bool in_string() const {
        return word_kind() == TokenKind::kString || word_kind() == TokenKind::kUnterminatedString;
    }

    /// True if values, a label or a brace follow the word on its line: it is a name that is being
    /// changed, and what stands behind it stays.
    [[nodiscard]] bool goes_on() const {
        if (!typing_.word.valid() || scene_.tokens.line_ends_after(typing_.word)) return false;
        const TokenId next{typing_.word.value + 1};
        switch (scene_.tokens.kind(next)) {
            case TokenKind::kCloseBrace:
            case TokenKind::kEndOfFile:
                return false;
            case TokenKind::kWord:
                return !grammar::is_vocabulary_name(scene_.tokens.text_of(next));
            default:
                return true;
        }
    }

    CompletionItem& add_name(std::string_view name, CompletionKind kind, SampleText text,
                             std::uint32_t rank) {
        if (goes_on()) text = {std::string(name), std::string(name)};
        return add(name, kind, std::move(text), rank);
    }

    CompletionItem& add(std::string_view label, CompletionKind kind, SampleText text,
                        std::uint32_t rank) {
        CompletionItem& item = result_.items.emplace_back();
        item.label = label;
        item.kind = kind;
        item.rank = rank;
        item.span = typing_.span;
        if (text.snippet != text.plain) item.snippet = std::move(text.snippet);
        item.insert = std::move(text.plain);
        return item;
    }
    void add_word(std::string_view word, CompletionKind kind, std::string_view detail) {
        add(word, kind, {std::string(word), std::string(word)}, kDue).detail = detail;
    }

    // --- Values ---

    void add_values(const FieldRow& field) {
        if (path_kind(field.type) != PathKind::kNone) {
            expect_path(path_kind(field.type));
        } else if (field.type == ValueType::kTextureFilter) {
            if (in_string()) return;
            add_word("bilinear", CompletionKind::kKeyword, "pixels blend into each other");
            add_word("nearest", CompletionKind::kKeyword, "pixels stay crisp");
        } else if (field.type == ValueType::kMaterialRef) {
            if (!in_string()) add_materials();
        } else {
            add_numbers(field);
        }
    }

    void expect_path(PathKind kind) {
        ByteRange span = typing_.span;
        const TokenKind token = word_kind();
        const bool quoted = typing_.word.valid() && in_string();
        if (quoted) {
            ++span.begin;
            if (token == TokenKind::kString) --span.end;
        }
        // Behind the closing quote the whole path is written.
        const std::uint32_t end = std::clamp(offset_, span.begin, span.end);
        result_.expects_path = {
            kind, std::string(scene_.tokens.text.substr(span.begin, end - span.begin)), span,
            quoted};
    }

    void add_materials() {
        std::unordered_set<std::string_view> seen;
        for (std::uint32_t i = 0; i < scene_.materials.size(); ++i) {
            const std::string_view label = label_text(scene_, scene_.materials[i]);
            // A second one of the same label cannot be meant by it.
            const bool named = !label.empty() && seen.insert(label).second;
            const std::string number = fmt::format("{}", i);
            const std::string text = named ? std::string(label) : number;
            CompletionItem& item = add(text, CompletionKind::kMaterial, {text, text}, kDue);
            item.detail = named ? fmt::format("material {}", i) : "a material without a label";
            item.documentation = material_summary(scene_, i);
            if (!named) continue;
            CompletionItem& by_number =
                add(number, CompletionKind::kMaterial, {number, number}, kUsual);
            by_number.detail = label;
            by_number.documentation = material_summary(scene_, i);
        }
    }

    /// A sample of the values that are still due.
    void add_numbers(const FieldRow& field) {
        // Over a number or a word there is nothing to offer that would be nearer to what is meant.
        if (typing_.word.valid()) return;
        std::string values = sample_value(field);
        if (field.type == ValueType::kCount) {
            values = fmt::format("{}", members_of(scene_, typing_).counted);
        }
        // Those that are there already stay.
        for (std::uint32_t i = 0; i < typing_.values_before; ++i) {
            values.erase(0, values.find(' ') + 1);
        }
        for (std::uint32_t i = 0; i < typing_.values_behind; ++i) {
            values.resize(std::min(values.rfind(' '), values.size()));
        }
        CompletionItem& item =
            add(values, CompletionKind::kValue, {values, fmt::format("${{1:{}}}", values)}, kDue);
        item.detail = without_marks(value_words(field));
        item.documentation = field.doc;
    }

    // --- Members ---

    void add_members() {
        const Members members = members_of(scene_, typing_);
        if (typing_.block != nullptr) add_fields(*typing_.block, members);
        for (const BlockRow& row : grammar::blocks()) {
            if (fits(row, typing_, members)) add_block(row);
        }
    }

    void add_fields(const BlockRow& block, const Members& members) {
        for (const FieldRow& field : grammar::fields_of(block.id)) {
            const std::uint32_t most = field.repeat == grammar::Repeat::kTwice ? 2 : 1;
            if (members.fields[static_cast<std::size_t>(field.id)] >= most) continue;
            std::uint32_t rank = block.layout == Layout::kList ? kRest : kUsual;
            if (field.presence == grammar::Presence::kRequired) rank = kRequired;
            if (field.presence == grammar::Presence::kExpected) rank = kExpected;
            SampleText text = sample_field(field);
            if (field.type == ValueType::kCount) {
                text.plain = fmt::format("{} {}", field.name, members.counted);
                text.snippet = fmt::format("{} ${{1:{}}}", field.name, members.counted);
            }
            CompletionItem& item =
                add_name(field.name, CompletionKind::kField, std::move(text), rank);
            item.detail = without_marks(value_words(field));
            item.documentation = joined(field_paragraphs(field));
        }
    }

    void add_block(const BlockRow& row) {
        const std::string label = row.role == Role::kMaterial ? fresh_label() : std::string();
        const bool fields_first =
            typing_.block != nullptr && typing_.block->layout == Layout::kFields;
        std::uint32_t rank = fields_first ? kRest : kUsual;
        // An object needs a material, and the first of them nothing else.
        if (row.role == Role::kMaterialIndex && !any_material_before()) rank = kRequired;
        SampleText sample = sample_block(row.id, label);
        if (row.role == Role::kMotion) sample = motion_sample(std::move(sample));
        CompletionItem& item = add_name(row.name, CompletionKind::kBlock, std::move(sample), rank);
        item.detail = first_sentence(row.doc);
        item.documentation = joined(block_paragraphs(row));
    }

    /// A Motion repeats the moves of its Transform: they are written as they are, to be changed.
    [[nodiscard]] SampleText motion_sample(SampleText empty) const {
        const BlockNodeId transform = block_of(scene_, typing_.around);
        if (!transform.valid()) return empty;
        SampleText sample = {"Motion {\n", "Motion {\n"};
        int stop = 1;
        for (const BlockNodeId child : scene_.ast.children_of(transform)) {
            const BlockNode& move = scene_.ast.block(child);
            const BlockRow& row = grammar::row(move.row);
            const auto fields = scene_.ast.fields_of(child);
            if (!grammar::may_stand_in(row.id, grammar::BlockId::kMotion) || move.broken) continue;
            if (fields.empty() || fields[0].broken) continue;
            const std::string values = values_text(scene_, fields[0]);
            const bool braces = row.layout == Layout::kPositional;
            const auto line = [&row, braces](std::string_view inside) {
                return fmt::format("    {} {}{}{}\n", row.name, braces ? "{ " : "", inside,
                                   braces ? " }" : "");
            };
            sample.plain += line(values);
            sample.snippet += line(fmt::format("${{{}:{}}}", stop++, values));
        }
        if (stop == 1) return empty;
        sample.plain += '}';
        sample.snippet += '}';
        return sample;
    }

    [[nodiscard]] bool any_material_before() const {
        for (const BlockNode& block : scene_.ast.blocks) {
            const TokenId name{scene_.cst.node(block.cst).first_token};
            if (scene_.tokens.range(name).begin >= typing_.span.begin) return false;
            if (block.row == grammar::BlockId::kMaterialIndex) return true;
        }
        return false;
    }

    /// A label that no material has. Counting on from their number, one of the first tries is free
    /// unless somebody has named them so.
    [[nodiscard]] std::string fresh_label() const {
        std::unordered_set<std::string_view> taken;
        for (std::uint32_t i = 0; i < scene_.ast.blocks.size(); ++i) {
            if (grammar::row(scene_.ast.blocks[i].row).role != Role::kMaterial) continue;
            taken.insert(label_text(scene_, {i}));
        }
        std::string label = "material";
        for (std::size_t n = 2; taken.contains(label); ++n) label = fmt::format("material{}", n);
        return label;
    }

    const CheckedScene& scene_;
    std::uint32_t offset_;
    Typing typing_;
    Completion result_;
};

}  // namespace

Completion complete(const CheckedScene& scene, std::string_view text, std::uint32_t offset) {
    // A file that is no text has no tokens, and nothing can be written in it.
    if (scene.tokens.text.size() != text.size()) return {};
    return Completer(scene, offset).run();
}

}  // namespace cobble::frontend::editor
