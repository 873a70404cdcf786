// SPDX-License-Identifier: MIT
#include "frontend/parse/token_input.hpp"

#include "frontend/lex/words.hpp"

namespace cobble::frontend {
namespace {

using grammar::BlockRow;
using grammar::FieldRow;
using grammar::Layout;

bool has_braces(const BlockRow& row) { return row.layout != Layout::kInline; }

}  // namespace

grammar::WordId TokenInput::word() {
    if (word_at_ != current_) {
        word_at_ = current_;
        word_ = grammar::find_word(tokens_.text_of({current_}));
    }
    return word_;
}

bool TokenInput::at_field_name() {
    const OpenBlocks& open = builder_.open_blocks();
    values_begin_ = current_ + 1;
    values_due_ = 0;
    if (open.inside() == Inside::kMembers) {
        const FieldRow* row = grammar::field_named(open.top().row->id, word());
        if (row == nullptr) return false;
        values_due_ = static_cast<std::uint32_t>(grammar::arity(row->type));
        return true;
    }
    // A block that nobody knows: its fields are told by their names, their values go on as long as
    // they can.
    values_due_ = 0xffffffffU;
    return open.inside() == Inside::kUnknown && grammar::names_a_field(word());
}

bool TokenInput::at_inline_name() {
    const BlockRow* row = grammar::block_named(word());
    if (row == nullptr || has_braces(*row)) return false;
    values_begin_ = current_ + 1;
    const FieldRow& value = grammar::fields_of(row->id)[0];
    values_due_ = static_cast<std::uint32_t>(grammar::arity(value.type));
    return true;
}

bool TokenInput::at_block_name() {
    const BlockRow* row = grammar::block_named(word());
    if (row == nullptr || !has_braces(*row)) return false;
    head_ = row;
    return true;
}

bool TokenInput::at_label() {
    if (!brace_follows()) return false;
    const bool is_word = kind_at(current_) == TokenKind::kWord;
    if (is_word && word().valid()) return is_word_as_label();
    // After the name of a field it is an unknown block, not a label; and on another line only a
    // block that surely has braces can have meant it.
    const auto previous = grammar::find_word(tokens_.text_of({current_ - 1}));
    const BlockRow* row = grammar::block_named(previous);
    if (on_line_of_previous()) return !previous.valid() || row != nullptr;
    return row != nullptr && has_braces(*row) && is_word;
}

// `Material Sphere {`: a word of the language was meant as a label if what stands in the braces
// belongs in the block before it, and the word can be no block in that one.
bool TokenInput::is_word_as_label() {
    if (!on_line_of_previous()) return false;
    const BlockRow* labelled = grammar::find_block(tokens_.text_of({current_ - 1}));
    if (labelled == nullptr || !labelled->labelled || !has_braces(*labelled)) return false;
    const std::uint32_t inside = current_ + 2;
    if (!may_begin(*labelled, inside)) return false;
    const BlockRow* row = grammar::block_named(word());
    return row == nullptr || !grammar::may_stand_in(row->id, labelled->id) ||
           !may_begin(*row, inside);
}

bool TokenInput::may_begin(const BlockRow& block, std::uint32_t token) const {
    const TokenKind kind = kind_at(token);
    if (kind == TokenKind::kCloseBrace) return true;
    if (kind != TokenKind::kWord) return false;
    const grammar::WordId found = grammar::find_word(tokens_.text_of({token}));
    if (grammar::field_named(block.id, found) != nullptr) return true;
    const BlockRow* row = grammar::block_named(found);
    return row != nullptr && grammar::may_stand_in(row->id, block.id);
}

bool TokenInput::at_bare_label() {
    return !brace_follows() && on_line_of_previous() && !word().valid() &&
           is_label(tokens_.text_of({current_}));
}

bool TokenInput::at_member() {
    const TokenKind kind = kind_at(current_);
    if (head_->layout == Layout::kPositional) return is_literal(kind);
    if (kind != TokenKind::kWord) return false;
    if (grammar::field_named(head_->id, word()) != nullptr) return true;
    const BlockRow* row = grammar::block_named(word());
    return row != nullptr && grammar::may_stand_in(row->id, head_->id);
}

bool TokenInput::at_word_value() {
    if (kind_at(current_) == TokenKind::kWord && word().valid()) {
        // `MaterialIndex Sphere` on a line of its own: meant as a label, and said to be none.
        const BlockRow* row = grammar::find_block(tokens_.text_of({current_ - 1}));
        return row != nullptr && row->role == grammar::Role::kMaterialIndex && !brace_follows() &&
               on_line_of_previous() && tokens_.line_ends_after({current_});
    }
    if (brace_follows()) {
        // `MaterialIndex stone` above a { that has lost its name.
        return on_line_of_previous() && tokens_.line_ends_after({current_});
    }
    if (on_line_of_previous()) return true;
    // On the next line no value may follow it there, or it is the misspelt name of the next field.
    const TokenKind next = kind_at(current_ + 1);
    if (next == TokenKind::kEndOfFile || next == TokenKind::kCloseBrace) return true;
    if (tokens_.line_ends_after({current_})) return true;
    return next == TokenKind::kWord && grammar::find_word(tokens_.text_of({current_ + 1})).valid();
}

bool TokenInput::at_odd_value() {
    const bool is_word = kind_at(current_) == TokenKind::kWord;
    if (is_word && (brace_follows() || word().valid())) return false;
    if (is_word && looks_like_number(tokens_.text_of({current_}))) return true;
    return current_ - values_begin_ < values_due_ && on_line_of_previous();
}

bool TokenInput::at_bare_value() {
    const TokenKind kind = kind_at(current_);
    const Inside inside = builder_.open_blocks().inside();
    if (inside == Inside::kUnknown) return is_literal(kind);
    if (inside != Inside::kPositional) return false;
    if (is_literal(kind)) return true;
    if (!is_text(kind) || brace_follows()) return false;
    return kind != TokenKind::kWord || grammar::block_named(word()) == nullptr;
}

bool TokenInput::at_stray_value() {
    const TokenKind kind = kind_at(current_);
    if (kind == TokenKind::kWord) {
        return !brace_follows() && looks_like_number(tokens_.text_of({current_}));
    }
    return is_literal(kind) || is_text(kind);
}

bool TokenInput::at_prose() {
    if (!on_line_of_previous()) return false;
    return kind_at(current_) != TokenKind::kWord || (!brace_follows() && !word().valid());
}

bool TokenInput::recover() {
    const auto place = builder_.take_resume_place();
    if (!place) return false;
    current_ = *place;
    word_at_ = 0xffffffffU;
    return true;
}

bool TokenInput::recover_at_end() {
    builder_.look_back_from_end(current_);
    return recover();
}

}  // namespace cobble::frontend
