// SPDX-License-Identifier: MIT
#include "frontend/format/layout.hpp"

#include <algorithm>

#include "grammar/vocabulary.hpp"

namespace cobble::frontend {
namespace {

bool is_block(NodeKind kind) { return kind == NodeKind::kBlock || kind == NodeKind::kNameless; }

bool is_wrong(const CstNode& node) {
    switch (static_cast<NodeKind>(node.kind)) {
        case NodeKind::kStrayValue:
        case NodeKind::kStrayClose:
        case NodeKind::kNameless:
        case NodeKind::kUnknown:
            return true;
        default:
            return node.has_error || node.unclosed;
    }
}

/// True if the block has a label that does not stand on the line of its name: an error that putting
/// the two on one line would hide.
bool has_far_label(const Tokens& tokens, const CstNode& node) {
    const std::uint32_t next = node.first_token + 1;
    return static_cast<NodeKind>(node.kind) == NodeKind::kBlock && next < node.end_token &&
           tokens.kind({next}) != TokenKind::kOpenBrace &&
           tokens.line_ends_after({node.first_token});
}

/// The nodes to leave as they are: the innermost block around each error, or the whole top-level
/// block if a brace is missing in it, since then nobody knows what belongs to what.
std::vector<bool> find_broken(const Tokens& tokens, const Cst& cst, bool& has_errors) {
    std::vector<bool> broken(cst.nodes.size(), false);
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 1; i < cst.nodes.size(); ++i) {
        const CstNode& node = cst.nodes[i];
        while (!open.empty() && i >= cst.nodes[open.back()].end_node) open.pop_back();
        const bool block = is_block(static_cast<NodeKind>(node.kind));
        if (is_wrong(node) || has_far_label(tokens, node)) {
            has_errors = true;
            const bool whole = node.unclosed != 0;
            if (open.empty()) {
                broken[i] = true;
            } else if (whole) {
                broken[open.front()] = true;
            } else {
                broken[block ? i : open.back()] = true;
            }
        }
        if (block) open.push_back(i);
    }
    if (cst.nodes[0].has_error) has_errors = true;
    return broken;
}

/// How many numbers stand on a line of a positional block: rows of a matrix, else all of them.
std::uint32_t numbers_per_line(const Tokens& tokens, TokenId name) {
    const grammar::BlockRow* row = grammar::find_block(tokens.text_of(name));
    if (row == nullptr || row->layout != grammar::Layout::kPositional) return 0;
    const auto fields = grammar::fields_of(row->id);
    constexpr int kMatrixNumbers = 16;
    constexpr std::uint32_t kMatrixRow = 4;
    const bool matrix = !fields.empty() && grammar::arity(fields[0].type) == kMatrixNumbers;
    return matrix ? kMatrixRow : UINT32_MAX;
}

class LayoutMaker {
  public:
    LayoutMaker(const Tokens& tokens, const Cst& cst) : tokens_(tokens), cst_(cst) {
        layout_.gaps.resize(tokens.size());
        broken_ = find_broken(tokens, cst, layout_.has_errors);
    }

    Layout make() {
        const auto count = static_cast<std::uint32_t>(cst_.nodes.size());
        std::uint32_t i = 1;
        while (i < count) {
            while (!open_.empty() && i >= open_.back().end_node) open_.pop_back();
            begin_member(i);
            const CstNode& node = cst_.nodes[i];
            if (broken_[i]) {
                i = node.end_node;
                continue;
            }
            switch (static_cast<NodeKind>(node.kind)) {
                case NodeKind::kBlock:
                    block(node);
                    break;
                case NodeKind::kNumbers:
                    numbers(node);
                    break;
                default:
                    values(node);
            }
            ++i;
        }
        Gap& end = layout_.gaps.back();
        end = {.kind = GapKind::kLine, .blank_first = true, .blank_between = true};
        return std::move(layout_);
    }

  private:
    struct Open {
        std::uint32_t end_node;
        std::uint32_t first_member;      ///< the token after its {
        std::uint32_t numbers_per_line;  ///< of a positional block, else 0
    };

    [[nodiscard]] std::uint8_t level(std::size_t extra = 0) const {
        return static_cast<std::uint8_t>(
            std::min<std::size_t>(open_.size() + extra, kMaxIndentLevels));
    }

    void begin_member(std::uint32_t index) {
        const CstNode& node = cst_.nodes[index];
        const bool first =
            open_.empty() ? node.first_token == 0 : node.first_token == open_.back().first_member;
        Gap& gap = layout_.gaps[node.first_token];
        gap = {.kind = GapKind::kLine,
               .level = level(),
               .comment_level = level(),
               .blank_first = !first,
               .blank_last = true,
               .blank_between = true};
        const bool stray = !is_block(static_cast<NodeKind>(node.kind)) && broken_[index];
        // Text that is no block keeps its line, also where a block follows on it, and so do two
        // broken blocks: a line end may decide what the parser takes them for.
        const bool keeps_line = stray || (node.first_token == stray_end_) ||
                                (broken_[index] && node.first_token == broken_end_);
        if (keeps_line) {
            gap.kind = GapKind::kStrayIndent;
        } else if (broken_[index]) {
            gap.kind = GapKind::kOwnIndent;
        }
        if (broken_[index]) broken_end_ = node.end_token;
        if (stray) stray_end_ = node.end_token;
    }

    void block(const CstNode& node) {
        const std::uint32_t close = node.end_token - 1;
        std::uint32_t token = node.first_token;
        while (token < close && tokens_.kind({token}) != TokenKind::kOpenBrace) {
            ++token;
            layout_.gaps[token] = {
                .kind = GapKind::kSpace, .level = level(), .comment_level = level()};
        }
        const std::uint32_t per_line = numbers_per_line(tokens_, {node.first_token});
        const bool empty = token + 1 >= close;
        const bool one_line = per_line == UINT32_MAX;
        layout_.gaps[close] = {.kind = empty      ? GapKind::kGlue
                                       : one_line ? GapKind::kSpace
                                                  : GapKind::kLine,
                               .level = level(),
                               .comment_level = level(1),
                               .blank_first = !empty && !one_line,
                               .blank_between = !one_line};
        open_.push_back({node.end_node, token + 1, per_line});
    }

    void numbers(const CstNode& node) {
        const std::uint32_t per_line = open_.empty() ? 0 : open_.back().numbers_per_line;
        if (per_line == 0) {
            values(node);
            return;
        }
        const bool one_line = per_line == UINT32_MAX;
        for (std::uint32_t token = node.first_token; token < node.end_token; ++token) {
            const std::uint32_t index = token - node.first_token;
            const std::size_t deeper = one_line ? 0 : 1;
            if (!one_line && index % per_line == 0) {
                // begin_member() has laid out the first.
                if (index != 0) {
                    layout_.gaps[token] = {
                        .kind = GapKind::kLine, .level = level(), .comment_level = level()};
                }
            } else {
                layout_.gaps[token] = {.kind = GapKind::kSpace,
                                       .level = level(deeper),
                                       .comment_level = level(deeper)};
            }
        }
    }

    void values(const CstNode& node) {
        for (std::uint32_t token = node.first_token + 1; token < node.end_token; ++token) {
            layout_.gaps[token] = {
                .kind = GapKind::kSpace, .level = level(1), .comment_level = level(1)};
        }
    }

    const Tokens& tokens_;
    const Cst& cst_;
    Layout layout_;
    std::vector<bool> broken_;
    std::vector<Open> open_;
    std::uint32_t broken_end_ = UINT32_MAX;  ///< the token after the last broken member
    std::uint32_t stray_end_ = UINT32_MAX;   ///< the token after the last one that is no block
};

}  // namespace

Layout lay_out(const Tokens& tokens, const Cst& cst) { return LayoutMaker(tokens, cst).make(); }

}  // namespace cobble::frontend
