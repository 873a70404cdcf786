// SPDX-License-Identifier: MIT
// The part of row_words.hpp that writes scene text.
#include <fmt/format.h>

#include "frontend/editor/row_words.hpp"

namespace cobble::frontend::editor {
namespace {

using grammar::BlockRow;
using grammar::FieldRow;
using grammar::Layout;

/// Builds both forms at once, so that they cannot differ in more than the tab stops.
class SampleWriter {
  public:
    void text(std::string_view piece) {
        sample_.plain += piece;
        for (const char c : piece) {
            // A } ends nothing outside of a tab stop, and not every client knows it escaped.
            if (c == '$' || c == '\\') sample_.snippet += '\\';
            sample_.snippet += c;
        }
    }
    void stop(std::string_view value) {
        sample_.plain += value;
        sample_.snippet += fmt::format("${{{}:{}}}", next_++, value);
    }
    void choice(std::string_view first, std::string_view second) {
        sample_.plain += first;
        sample_.snippet += fmt::format("${{{}|{},{}|}}", next_++, first, second);
    }
    /// Where the cursor stays in the end.
    void last() { sample_.snippet += "$0"; }

    void values(const FieldRow& field) {
        if (field.type == grammar::ValueType::kTextureFilter) {
            choice("bilinear", "nearest");
        } else {
            stop(sample_value(field));
        }
    }
    void field(const FieldRow& row) {
        text(row.name);
        text(" ");
        values(row);
    }
    /// The first of two colours, which would mix to one if both were the default.
    void first_of_two(const FieldRow& row) {
        text(row.name);
        text(" ");
        stop("1 1 1");
    }
    SampleText take() { return std::move(sample_); }

  private:
    SampleText sample_;
    int next_ = 1;
};

/// The fields that a fresh block is written with: those that it cannot do without, or else the
/// first, so that it says something.
std::vector<const FieldRow*> fields_to_write(const BlockRow& block) {
    std::vector<const FieldRow*> fields;
    for (const FieldRow& field : grammar::fields_of(block.id)) {
        if (field.presence != grammar::Presence::kOptional) fields.push_back(&field);
    }
    if (fields.empty() && block.layout == Layout::kFields) {
        const FieldRow& first = grammar::fields_of(block.id)[0];
        fields.push_back(&first);
        if (first.repeat == grammar::Repeat::kTwice) fields.push_back(&first);
    }
    return fields;
}

}  // namespace

SampleText sample_field(const FieldRow& field) {
    SampleWriter writer;
    const Layout layout = grammar::row(field.block).layout;
    if (layout == Layout::kFields || layout == Layout::kList) {
        writer.field(field);
    } else {
        writer.values(field);
    }
    return writer.take();
}

SampleText sample_block(grammar::BlockId id, std::string_view label) {
    const BlockRow& block = grammar::row(id);
    SampleWriter writer;
    writer.text(block.name);
    writer.text(" ");
    if (block.layout == Layout::kInline) {
        writer.values(grammar::fields_of(id)[0]);
        return writer.take();
    }
    if (block.layout == Layout::kPositional) {
        writer.text("{ ");
        writer.values(grammar::fields_of(id)[0]);
        writer.text(" }");
        return writer.take();
    }
    if (!label.empty() && block.labelled) {
        writer.stop(label);
        writer.text(" ");
    }
    writer.text("{\n");
    bool written_once = false;
    for (const FieldRow* field : fields_to_write(block)) {
        writer.text("    ");
        if (field->repeat == grammar::Repeat::kTwice && !written_once) {
            writer.first_of_two(*field);
            written_once = true;
        } else {
            writer.field(*field);
        }
        writer.text("\n");
    }
    if (block.layout == Layout::kList) {
        writer.text("    ");
        writer.last();
        writer.text("\n");
    }
    writer.text("}");
    return writer.take();
}

std::string example_block(grammar::BlockId id) {
    const BlockRow& block = grammar::row(id);
    std::string text = sample_block(id).plain;
    if (block.layout != Layout::kList) return text;
    // The first of each role is example enough; an object stands behind what applies to it.
    std::string lines;
    std::string object;
    std::uint32_t roles = 0;
    for (const BlockRow& row : grammar::blocks()) {
        if (!grammar::may_stand_in(row.id, id) || row.layout == Layout::kList) continue;
        const std::uint32_t role = 1U << static_cast<unsigned>(row.role);
        if ((roles & role) != 0) continue;
        roles |= role;
        std::string& part = row.role == grammar::Role::kObject ? object : lines;
        part.append(sample_block(row.id).plain).append("\n");
    }
    lines += object;
    if (lines.empty()) return text;
    lines.pop_back();
    for (std::size_t at = lines.find('\n'); at != std::string::npos;
         at = lines.find('\n', at + 1)) {
        lines.insert(at + 1, "    ");
    }
    return fmt::format("{} {{\n    {}\n}}", block.name, lines);
}

}  // namespace cobble::frontend::editor
