// SPDX-License-Identifier: MIT
#include "frontend/parse/tree_builder.hpp"

#include "frontend/parse/layout.hpp"

namespace cobble::frontend {
namespace {

using grammar::BlockRow;
using grammar::FieldRow;
using grammar::ValueType;

bool takes_color(ValueType type) { return type == ValueType::kColor; }

}  // namespace

TreeBuilder::TreeBuilder(const Tokens& tokens, Cst& cst)
    : tokens_(tokens),
      cst_(cst),
      // Looking back reads tokens again; four times the file keeps the whole linear.
      budget_(std::uint64_t{4} * tokens.size() + 64) {
    add_node(NodeKind::kFile, 0, 0, false);
}

std::uint32_t TreeBuilder::add_node(NodeKind kind, std::uint32_t begin, std::uint32_t end,
                                    bool error) {
    CstNode node{};
    node.kind = static_cast<std::uint32_t>(kind) & 0xffU;
    node.has_error = error ? 1 : 0;
    node.first_token = begin;
    node.end_token = end;
    const auto index = static_cast<std::uint32_t>(cst_.nodes.size());
    node.end_node = end == 0 ? 0 : index + 1;
    cst_.nodes.push_back(node);
    return index;
}

const BlockRow* TreeBuilder::row_of(std::uint32_t token) const {
    return tokens_.kind({token}) == TokenKind::kWord ? grammar::find_block(tokens_.text_of({token}))
                                                     : nullptr;
}

bool TreeBuilder::values_fit(ValueType type, std::uint32_t begin, std::uint32_t end) const {
    std::uint32_t numbers = 0;
    std::uint32_t words = 0;
    for (std::uint32_t i = begin; i < end; ++i) {
        switch (tokens_.kind({i})) {
            case TokenKind::kNumber:
                ++numbers;
                break;
            case TokenKind::kColor:
                if (!takes_color(type)) return false;
                numbers += 3;
                break;
            case TokenKind::kUnterminatedString:
                return false;
            default:
                ++words;
        }
    }
    const auto due = static_cast<std::uint32_t>(grammar::arity(type));
    if (grammar::is_word(type)) return words == due && numbers == 0;
    if (type == ValueType::kMaterialRef) return words + numbers == 1;
    return numbers == due && words == 0;
}

void TreeBuilder::add_field(std::uint32_t begin, std::uint32_t end) {
    bool error = false;
    if (open_.inside() == Inside::kMembers) {
        const FieldRow* row = grammar::find_field(open_.top().row->id, tokens_.text_of({begin}));
        error = row != nullptr && !values_fit(row->type, begin + 1, end);
    }
    add_node(NodeKind::kField, begin, end, error);
}

void TreeBuilder::add_inline_block(std::uint32_t begin, std::uint32_t end) {
    const BlockRow& row = *row_of(begin);
    const Placing placing = place(row, begin);
    if (placing == Placing::kResumed) return;
    const bool fits = values_fit(grammar::fields_of(row.id)[0].type, begin + 1, end);
    add_node(NodeKind::kField, begin, end, placing == Placing::kMisplaced || !fits);
}

void TreeBuilder::add_numbers(std::uint32_t begin, std::uint32_t end) {
    const BlockRow* row = open_.top().row;
    const bool fits = row == nullptr || values_fit(grammar::fields_of(row->id)[0].type, begin, end);
    add_node(NodeKind::kNumbers, begin, end, !fits);
}

void TreeBuilder::add_error(NodeKind kind, std::uint32_t begin, std::uint32_t end) {
    leave_bare_positional(begin);
    add_node(kind, begin, end, true);
}

void TreeBuilder::add_unknown(std::uint32_t begin, std::uint32_t end) {
    leave_bare_positional(begin);
    const grammar::WordId word = grammar::find_word(tokens_.text_of({begin}));
    if (grammar::names_a_field(word)) {
        const Placing placing = reopen_for(nullptr, word, begin);
        if (placing == Placing::kResumed) return;
        if (placing == Placing::kPlaced || ends_enclosed_block(word, begin)) {
            resume_ = begin;
            return;
        }
    }
    add_node(NodeKind::kUnknown, begin, end, true);
}

void TreeBuilder::add_lone_head(std::uint32_t begin, std::uint32_t end) {
    if (place(*row_of(begin), begin) == Placing::kResumed) return;
    add_node(NodeKind::kBlock, begin, end, true);
}

void TreeBuilder::open_node(std::uint32_t begin, const BlockRow* row, bool bare, bool error,
                            NodeKind kind) {
    open_.push(add_node(kind, begin, 0, error), row, bare);
}

void TreeBuilder::enter_block(std::uint32_t begin, std::uint32_t end, bool bare) {
    const BlockRow* row = row_of(begin);
    Placing placing = Placing::kPlaced;
    if (row == nullptr) {
        leave_bare_positional(begin);
    } else {
        placing = place(*row, begin);
    }
    if (placing == Placing::kResumed) return;
    const bool inline_in_braces = row != nullptr && row->layout == grammar::Layout::kInline;
    const bool error = row == nullptr || bare || inline_in_braces || placing == Placing::kMisplaced;
    open_node(begin, row, bare, error, NodeKind::kBlock);
    // Its { is found again by this alone: the word could as well name a block of its own.
    const bool word_label = !bare && end == begin + 3 &&
                            tokens_.kind({begin + 1}) == TokenKind::kWord &&
                            grammar::is_vocabulary_name(tokens_.text_of({begin + 1}));
    cst_.nodes[open_.top().node].word_label = word_label ? 1 : 0;
}

void TreeBuilder::enter_nameless(std::uint32_t begin) {
    leave_bare_positional(begin);
    const bool doubled = begin > 0 && tokens_.kind({begin - 1}) == TokenKind::kOpenBrace;
    if (doubled && fits_top(begin + 1)) {
        add_node(NodeKind::kNameless, begin, begin + 1, true);
    } else {
        open_node(begin, nullptr, false, true, NodeKind::kNameless);
    }
}

void TreeBuilder::end_top(std::uint32_t end, bool unclosed) {
    CstNode& node = cst_.nodes[open_.top().node];
    node.end_token = end;
    node.end_node = static_cast<std::uint32_t>(cst_.nodes.size());
    if (unclosed) {
        node.unclosed = 1;
        node.has_error = 1;
    }
    last_closed_ = open_.top().node;
    open_.pop();
}

void TreeBuilder::close_block(std::uint32_t brace) {
    if (open_.inside() == Inside::kPositional && open_.top().bare && !is_own_brace(brace)) {
        leave_bare_positional(brace);
    }
    if (open_.empty()) {
        if (look_back_for_extra(brace)) return;
        add_node(NodeKind::kStrayClose, brace, brace + 1, true);
    } else {
        end_top(brace + 1, false);
    }
}

// True if the } after `Rotate 0 1 0 90` without { is its own. Where the braces of the file add up,
// the { was not lost alone, and the } is that of the block around; else the } stands behind the
// numbers, or like the name.
bool TreeBuilder::is_own_brace(std::uint32_t brace) {
    if (!surplus_) {
        surplus_ = 0;
        for (std::uint32_t i = 0; i < tokens_.size(); ++i) {
            const TokenKind kind = tokens_.kind({i});
            if (kind == TokenKind::kCloseBrace) ++*surplus_;
            if (kind == TokenKind::kOpenBrace) --*surplus_;
        }
    }
    if (*surplus_ <= 0) return false;
    const auto indent = indent_of(tokens_, brace);
    const std::uint32_t name = cst_.nodes[open_.top().node].first_token;
    if (indent && indent != indent_of(tokens_, name)) return false;
    --*surplus_;
    return true;
}

void TreeBuilder::finish(std::uint32_t end_of_file) {
    while (!open_.empty()) end_top(end_of_file, true);
    CstNode& file = cst_.nodes[0];
    file.end_token = end_of_file + 1;
    file.end_node = static_cast<std::uint32_t>(cst_.nodes.size());
}

// --- Where does it stand, and which brace is missing? --------------------------------------------

bool TreeBuilder::fits_top(std::uint32_t token) const {
    if (open_.empty() || open_.top().row == nullptr) return false;
    const BlockRow& top = *open_.top().row;
    if (open_.inside() == Inside::kPositional) return tokens_.kind({token}) == TokenKind::kNumber;
    if (tokens_.kind({token}) != TokenKind::kWord) return false;
    const grammar::WordId word = grammar::find_word(tokens_.text_of({token}));
    const BlockRow* row = grammar::block_named(word);
    return row != nullptr ? grammar::may_stand_in(row->id, top.id)
                          : grammar::field_named(top.id, word) != nullptr;
}

TreeBuilder::Placing TreeBuilder::place(const BlockRow& row, std::uint32_t begin) {
    std::size_t depth = open_.home_of(row);
    if (depth == OpenBlocks::kNowhere) {
        leave_bare_positional(begin);
        return reopen_for(&row, {}, begin);
    }
    if (depth == open_.depth()) return Placing::kPlaced;
    // What is indented as a member of the innermost block was meant as one: no brace is missing.
    const auto indent = indent_of(tokens_, begin);
    const auto around = indent_of(tokens_, cst_.nodes[open_.top().node].first_token);
    if (indent && around && is_deeper(*indent, *around)) return Placing::kMisplaced;
    if (look_back(depth, begin)) return Placing::kResumed;
    while (open_.depth() > depth) end_top(begin, true);
    return Placing::kPlaced;
}

void TreeBuilder::look_back_from_end(std::uint32_t end_of_file) {
    if (!open_.empty()) look_back(0, end_of_file);
}

// The blocks from `depth` on lack a brace somewhere before `place`. If the layout tells where, the
// tree is cut back to there.
bool TreeBuilder::look_back(std::size_t depth, std::uint32_t place) {
    const std::uint32_t root = open_.at(depth).node;
    if (!afford(place - cst_.nodes[root].first_token)) return false;
    const BlockRow* around = depth == 0 ? nullptr : open_.at(depth - 1).row;
    const auto found = find_missing_close(tokens_, cst_, root, around, depth == 0);
    if (!found) return false;
    cut_back(*found, depth);
    end_top(found->token, true);
    resume_ = found->token;
    return true;
}

// The block that has just been closed may have ended too early: perhaps a } inside it, or its own,
// was too many.
bool TreeBuilder::look_back_for_extra(std::uint32_t place) {
    const std::uint32_t root = last_closed_;
    if (root == 0 || cst_.nodes[root].end_token != place) return false;
    if (!afford(place - cst_.nodes[root].first_token)) return false;
    const auto found = find_extra_close(tokens_, cst_, root);
    if (!found) return false;
    cut_back(*found, open_.depth());
    add_node(NodeKind::kStrayClose, found->token, found->token + 1, true);
    resume_ = found->token + 1;
    return true;
}

bool TreeBuilder::afford(std::uint64_t cost) {
    if (cost > budget_) return false;
    budget_ -= cost;
    return true;
}

void TreeBuilder::cut_back(const Culprit& culprit, std::size_t depth) {
    cst_.nodes.resize(culprit.node_count);
    last_closed_ = 0;
    while (open_.depth() > depth) open_.pop();
    for (const std::uint32_t node : culprit.open_blocks) {
        CstNode& block = cst_.nodes[node];
        block.end_token = 0;
        block.end_node = 0;
        block.unclosed = 0;
        open_.push(node, row_of(block.first_token), !open_brace_of(tokens_, block).valid());
    }
}

std::optional<std::uint32_t> TreeBuilder::take_resume_place() {
    const auto place = resume_;
    resume_.reset();
    return place;
}

void TreeBuilder::leave_bare_positional(std::uint32_t at) {
    if (open_.inside() == Inside::kPositional && open_.top().bare) end_top(at, true);
}

// What fits nowhere here, but would fit in the block that has just been closed, tells that a } was
// one too many, if the layout agrees.
TreeBuilder::Placing TreeBuilder::reopen_for(const BlockRow* row, grammar::WordId word,
                                             std::uint32_t begin) {
    const std::uint32_t last = last_closed_;
    if (last == 0 || cst_.nodes[last].end_token != begin) return Placing::kMisplaced;
    CstNode& block = cst_.nodes[last];
    const BlockRow* its_row = row_of(block.first_token);
    if (its_row == nullptr || block.unclosed != 0) return Placing::kMisplaced;
    const bool fits = row != nullptr ? grammar::may_stand_in(row->id, its_row->id)
                                     : grammar::field_named(its_row->id, word) != nullptr;
    if (!fits) return Placing::kMisplaced;
    if (look_back_for_extra(begin)) return Placing::kResumed;
    const std::uint32_t brace = begin - 1;
    if (!close_looks_extra(tokens_, block.first_token, brace, begin)) return Placing::kMisplaced;
    block.end_token = 0;
    block.end_node = 0;
    last_closed_ = 0;
    open_.push(last, its_row, !open_brace_of(tokens_, block).valid());
    add_node(NodeKind::kStrayClose, brace, begin, true);
    return Placing::kPlaced;
}

// A field of the block around the innermost one that is indented like the innermost one's name.
bool TreeBuilder::ends_enclosed_block(grammar::WordId word, std::uint32_t begin) {
    if (open_.depth() < 2) return false;
    const BlockRow* around = open_.at(open_.depth() - 2).row;
    if (around == nullptr || grammar::field_named(around->id, word) == nullptr) return false;
    const CstNode& block = cst_.nodes[open_.top().node];
    const std::uint32_t first_child = open_.top().node + 1;
    if (first_child >= cst_.nodes.size()) return false;
    if (!stands_beside(tokens_, begin, block.first_token, cst_.nodes[first_child].first_token)) {
        return false;
    }
    end_top(begin, true);
    return true;
}

}  // namespace cobble::frontend
