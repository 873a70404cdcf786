// SPDX-License-Identifier: MIT
#include "frontend/parse/recovery.hpp"

#include <algorithm>
#include <string_view>

#include "frontend/parse/layout.hpp"

namespace cobble::frontend {
namespace {

using grammar::BlockRow;
using Indent = std::optional<std::string_view>;

constexpr std::size_t kLevels = 64;

// Nobody indents as deep as this: a file that nests deeper is no work of hands, and a search
// through millions of levels would take more memory than all the rest.
constexpr std::size_t kDeepest = 4096;

struct Level {
    std::uint32_t node;
    const BlockRow* row;
    Indent indent;
    Indent child_indent;  ///< of the first child
    bool has_child;
    bool has_object;  ///< what a Transform is for
};

enum class Wanted : std::uint8_t { kMissing, kExtra };

class Search {
  public:
    Search(const Tokens& tokens, const Cst& cst, const BlockRow* around, bool at_top)
        : tokens_(tokens), cst_(cst), around_(around), at_top_(at_top), wanted_(Wanted::kMissing) {}
    Search(const Tokens& tokens, const Cst& cst)
        : tokens_(tokens), cst_(cst), around_(nullptr), at_top_(true), wanted_(Wanted::kExtra) {}

    std::optional<Culprit> run(std::uint32_t root) {
        enter(root);
        for (std::uint32_t i = root + 1; i < cst_.nodes.size(); ++i) {
            if (auto found = leave_closed(i)) return found;
            const CstNode& node = cst_.nodes[i];
            const Indent indent = indent_of(tokens_, node.first_token);
            Level& top = levels_.back();
            if (!top.has_child) {
                top.has_child = true;
                top.child_indent = indent;
            } else if (wanted_ == Wanted::kMissing &&
                       (stands_beside_top(indent) || is_second_object(node)) &&
                       fits_beside_top(node)) {
                return found_at(node.first_token, i);
            }
            if (is_block(node)) {
                if (levels_.size() == kDeepest) return std::nullopt;
                if (is_object(node)) top.has_object = true;
                enter(i);
            }
        }
        return leave_closed(static_cast<std::uint32_t>(cst_.nodes.size()));
    }

  private:
    static bool is_block(const CstNode& node) {
        const auto kind = static_cast<NodeKind>(node.kind);
        return (kind == NodeKind::kBlock || kind == NodeKind::kNameless) &&
               node.end_token != node.first_token + 1;
    }

    const BlockRow* row_of(const CstNode& node) const {
        return grammar::find_block(tokens_.text_of({node.first_token}));
    }

    void enter(std::uint32_t node) {
        const CstNode& block = cst_.nodes[node];
        levels_.push_back({node, row_of(block), indent_of(tokens_, block.first_token), std::nullopt,
                           false, false});
    }

    // Leaves the blocks that end before the node `next`, looking at their closing braces.
    std::optional<Culprit> leave_closed(std::uint32_t next) {
        while (!levels_.empty()) {
            const CstNode& block = cst_.nodes[levels_.back().node];
            if (block.end_token == 0 || block.end_node != next) return std::nullopt;
            const std::uint32_t brace = block.end_token - 1;
            const Indent indent = indent_of(tokens_, brace);
            const bool odd = wanted_ == Wanted::kMissing ? stands_like_outer(indent)
                                                         : stands_deeper(brace, indent);
            // A name without braces ends with whatever its last value is.
            const bool closed =
                block.unclosed == 0 && tokens_.kind({brace}) == TokenKind::kCloseBrace;
            if (closed && odd) return found_at(brace, next);
            levels_.pop_back();
        }
        return std::nullopt;
    }

    [[nodiscard]] bool stands_like_outer(const Indent& brace) const {
        const Level& top = levels_.back();
        if (!brace || !top.indent || brace == top.indent) return false;
        const std::size_t count = std::min(levels_.size(), kLevels);
        return std::any_of(levels_.rbegin() + 1, levels_.rbegin() + static_cast<long>(count),
                           [&brace](const Level& level) { return level.indent == brace; });
    }

    [[nodiscard]] bool stands_deeper(std::uint32_t brace, const Indent& indent) const {
        const Level& top = levels_.back();
        if (!top.indent) return false;
        if (indent) return is_deeper(*indent, *top.indent);
        // `} }` at the end of several lines.
        if (tokens_.kind({brace - 1}) != TokenKind::kCloseBrace) return false;
        const std::uint32_t begin = tokens_.tokens[cst_.nodes[top.node].first_token].begin;
        const std::uint32_t end = tokens_.tokens[brace].begin;
        return tokens_.text.substr(begin, end - begin).find_first_of("\r\n") !=
               std::string_view::npos;
    }

    [[nodiscard]] bool is_object(const CstNode& node) const {
        const BlockRow* row = row_of(node);
        return row != nullptr &&
               (row->role == grammar::Role::kObject || row->role == grammar::Role::kGroup ||
                row->role == grammar::Role::kTransform);
    }

    // A Transform moves one object: a second one was meant to stand behind it.
    [[nodiscard]] bool is_second_object(const CstNode& node) const {
        const Level& top = levels_.back();
        return top.has_object && top.row != nullptr && top.row->role == grammar::Role::kTransform &&
               is_block(node) && is_object(node);
    }

    [[nodiscard]] bool stands_beside_top(const Indent& item) const {
        const Level& top = levels_.back();
        // A Transform does not end before the object that it moves, however that is indented.
        const bool is_transform = top.row != nullptr && top.row->role == grammar::Role::kTransform;
        if (is_transform && !top.has_object) return false;
        return item && item == top.indent && item != top.child_indent;
    }

    [[nodiscard]] bool fits_beside_top(const CstNode& node) const {
        const bool at_root = levels_.size() == 1;
        const BlockRow* parent = at_root ? around_ : levels_[levels_.size() - 2].row;
        const auto word = grammar::find_word(tokens_.text_of({node.first_token}));
        const BlockRow* row = grammar::block_named(word);
        if (at_root && at_top_) return row != nullptr && grammar::may_stand_at_top(row->id);
        if (parent == nullptr) return false;
        return row != nullptr ? grammar::may_stand_in(row->id, parent->id)
                              : grammar::field_named(parent->id, word) != nullptr;
    }

    [[nodiscard]] Culprit found_at(std::uint32_t token, std::uint32_t node_count) const {
        Culprit found{token, node_count, {}};
        found.open_blocks.reserve(levels_.size());
        for (const Level& level : levels_) found.open_blocks.push_back(level.node);
        return found;
    }

    const Tokens& tokens_;
    const Cst& cst_;
    const BlockRow* around_;
    bool at_top_;
    Wanted wanted_;
    std::vector<Level> levels_;
};

}  // namespace

std::optional<Culprit> find_missing_close(const Tokens& tokens, const Cst& cst, std::uint32_t root,
                                          const BlockRow* around, bool at_top) {
    return Search(tokens, cst, around, at_top).run(root);
}

std::optional<Culprit> find_extra_close(const Tokens& tokens, const Cst& cst, std::uint32_t root) {
    return Search(tokens, cst).run(root);
}

}  // namespace cobble::frontend
