// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <utility>

#include "frontend/ast/ast.hpp"
#include "frontend/ast/brace_errors.hpp"
#include "frontend/ast/name_errors.hpp"
#include "frontend/ast/reporter.hpp"
#include "frontend/ast/text_errors.hpp"
#include "frontend/ast/value_binder.hpp"

namespace cobble::frontend {
namespace {

using grammar::BlockRow;
using grammar::FieldRow;
using grammar::Layout;

// The members of the blocks that are open wait on three common stacks; when a block ends, its own
// are the topmost, and move to where they are neighbours.
class Binder {
  public:
    Binder(source::SourceId source, const Tokens& tokens, const Cst& cst)
        : tokens_(tokens), cst_(cst), reporter_(source, tokens) {
        bound_.ast.source = source;
        // Three quarters of the tokens of published scenes are values, a fifth names of fields.
        bound_.ast.values.reserve(tokens.size() * 3 / 4);
        bound_.ast.fields.reserve(cst.nodes.size());
    }

    BoundAst run() {
        levels_.push_back(level_of(NodeId{0}, BlockNodeId{}, nullptr, false));
        const auto count = static_cast<std::uint32_t>(cst_.nodes.size());
        for (std::uint32_t i = 1; i < count; ++i) {
            end_levels_before(i);
            bind_node({i});
        }
        end_levels_before(count);
        report_text_errors(reporter_);
        bound_.diagnostics = reporter_.take();
        return std::move(bound_);
    }

  private:
    struct Level {
        NodeId node;
        BlockNodeId block;    ///< invalid for the file and for blocks that nobody knows
        const BlockRow* row;  ///< null for the same
        bool ignored;         ///< nobody knows what its members mean
        bool misplaced;       ///< its name is wrong here, and its members may show that
        std::uint32_t first_child;
        std::uint32_t first_field;
        std::uint32_t first_unknown;
    };

    Level level_of(NodeId node, BlockNodeId block, const BlockRow* row, bool misplaced) {
        return {node,
                block,
                row,
                false,
                misplaced,
                size_of(children_),
                size_of(fields_),
                size_of(unknown_)};
    }

    // What stands in an ignored block is ignored at any depth: the outermost one is a level enough.
    void ignore_members(NodeId node) {
        if (levels_.back().ignored) return;
        levels_.push_back(level_of(node, {}, nullptr, false));
        levels_.back().ignored = true;
    }

    void end_levels_before(std::uint32_t node) {
        while (!levels_.empty() && cst_.node(levels_.back().node).end_node <= node) end_level();
    }

    void end_level() {
        const Level& level = levels_.back();
        report_unknown(level);
        Ast& ast = bound_.ast;
        if (level.block.valid()) {
            BlockNode& block = ast.blocks[level.block.value];
            block.first_child = size_of(ast.children);
            block.child_count = static_cast<std::uint32_t>(children_.size() - level.first_child);
            append_from(ast.children, children_, level.first_child);
            block.first_field = size_of(ast.fields);
            block.field_count = static_cast<std::uint32_t>(fields_.size() - level.first_field);
            append_from(ast.fields, fields_, level.first_field);
        } else if (!level.ignored) {
            append_from(ast.roots, children_, level.first_child);
        }
        children_.resize(level.first_child);
        fields_.resize(level.first_field);
        levels_.pop_back();
    }

    template <typename T>
    static std::uint32_t size_of(const std::vector<T>& items) {
        return static_cast<std::uint32_t>(items.size());
    }
    template <typename T>
    static void append_from(std::vector<T>& to, const std::vector<T>& from, std::size_t first) {
        to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(first), from.end());
    }

    // Unknown names wait for the end of their block, because what to suggest depends on what else
    // stands in it.
    void report_unknown(const Level& level) {
        if (unknown_.size() > level.first_unknown) {
            std::vector<grammar::FieldId> present;
            for (std::size_t i = level.first_field; i < fields_.size(); ++i) {
                present.push_back(fields_[i].row);
            }
            for (std::size_t i = level.first_unknown; i < unknown_.size(); ++i) {
                if (level.misplaced && is_word_of_language(unknown_[i])) continue;
                report_unknown_name(cst_.node(unknown_[i]), level.row, present, reporter_);
            }
        }
        unknown_.resize(level.first_unknown);
    }

    [[nodiscard]] bool is_word_of_language(NodeId id) const {
        return grammar::find_word(tokens_.text_of({cst_.node(id).first_token})).valid();
    }

    void bind_node(NodeId id) {
        const CstNode& node = cst_.node(id);
        const bool ignored = levels_.back().ignored;
        switch (cst_.kind(id)) {
            case NodeKind::kField:
                if (!ignored) bind_field(id);
                break;
            case NodeKind::kNumbers:
                if (!ignored) bind_numbers(id);
                break;
            case NodeKind::kBlock:
                bind_block(id);
                break;
            case NodeKind::kNameless:
                if (!ignored) report_nameless(node, reporter_);
                bound_.ast.structure_broken = true;
                ignore_members(id);
                break;
            case NodeKind::kStrayClose:
                report_extra_brace(node, place_name(), reporter_);
                bound_.ast.structure_broken = true;
                break;
            case NodeKind::kStrayValue:
                if (!ignored) report_stray_values(node, place_name(), reporter_);
                break;
            case NodeKind::kUnknown:
                if (!ignored) unknown_.push_back(id);
                break;
            case NodeKind::kFile:
                break;
        }
    }

    [[nodiscard]] std::string_view place_name() const {
        return levels_.back().row == nullptr ? std::string_view{} : levels_.back().row->name;
    }

    void bind_field(NodeId id) {
        const CstNode& node = cst_.node(id);
        const TokenId name{node.first_token};
        const std::string_view text = tokens_.text_of(name);
        const grammar::WordId word = grammar::find_word(text);
        const ValueRun run{name, node.first_token + 1, node.end_token, text};
        if (const BlockRow* row = grammar::block_named(word)) {
            bind_inline(id, *row, run);
            return;
        }
        const BlockRow* around = levels_.back().row;
        const FieldRow* row = around == nullptr ? nullptr : grammar::field_named(around->id, word);
        if (row != nullptr) fields_.push_back(bind_values(*row, run, id, bound_.ast, reporter_));
    }

    // A block without braces has no members: it is done at once.
    void bind_inline(NodeId id, const BlockRow& row, const ValueRun& run) {
        const FieldNode field =
            bind_values(grammar::fields_of(row.id)[0], run, id, bound_.ast, reporter_);
        const bool fits = fits_here(row);
        if (!fits && !levels_.back().misplaced)
            report_misplaced(cst_, id, row, around(), reporter_);
        BlockNode& block = add_block(id, row);
        block.broken = !fits;
        block.first_field = size_of(bound_.ast.fields);
        block.field_count = 1;
        block.first_child = size_of(bound_.ast.children);
        bound_.ast.fields.push_back(field);
    }

    BlockNode& add_block(NodeId id, const BlockRow& row) {
        const BlockNodeId block{size_of(bound_.ast.blocks)};
        children_.push_back(block);
        BlockNode& node = bound_.ast.blocks.emplace_back();
        node.row = row.id;
        node.parent = levels_.back().block;
        node.cst = id;
        return node;
    }

    [[nodiscard]] const BlockRow* around() const { return levels_.back().row; }

    [[nodiscard]] bool fits_here(const BlockRow& row) const {
        return around() == nullptr ? grammar::may_stand_at_top(row.id)
                                   : grammar::may_stand_in(row.id, around()->id);
    }

    void bind_block(NodeId id) {
        const CstNode& node = cst_.node(id);
        const bool ignored = levels_.back().ignored;
        const TokenId brace = open_brace_of(tokens_, node);
        const bool alone = !brace.valid() && node.end_node == id.value + 1;
        const BlockRow* row = grammar::find_block(tokens_.text_of({node.first_token}));
        const bool misplaced = !ignored && row != nullptr && !fits_here(*row);
        if (!brace.valid() || node.unclosed != 0) {
            bound_.ast.structure_broken = true;
            // A name alone where it may not stand was meant as another one.
            // And where numbers are missing too, their count says it all.
            const bool said = holds_nameless(id) || (alone && misplaced) ||
                              (!brace.valid() && row != nullptr && wrong_count(id, *row));
            if (!said) report_missing_braces(cst_, id, reporter_);
        }
        if (ignored || row == nullptr) {
            if (!ignored) unknown_.push_back(id);
            ignore_members(id);
            return;
        }
        if (misplaced) {
            // A misplaced section is missed elsewhere.
            if (grammar::may_stand_at_top(row->id)) bound_.ast.structure_broken = true;
            const bool misspelt =
                !levels_.back().misplaced && report_misplaced(cst_, id, *row, around(), reporter_);
            if (misspelt) {
                ignore_members(id);
                return;
            }
        }
        BlockNode& block = add_block(id, *row);
        block.broken = misplaced || alone;
        const BlockNodeId block_id{size_of(bound_.ast.blocks) - 1};
        const TokenId label = label_of(tokens_, node);
        if (label.valid() && accept_label(*row, label, reporter_)) block.label = label;
        if (row->layout == Layout::kInline) {
            block.broken = true;
            if (!misplaced) report_inline_braces(node, reporter_);
        } else if (row->layout == Layout::kPositional && !alone && !holds_numbers(id)) {
            const ValueRun none{{node.first_token}, 0, 0, row->name};
            fields_at_level(block_id, id, *row, none);
            return;
        }
        levels_.push_back(level_of(id, block_id, row, misplaced));
    }

    void fields_at_level(BlockNodeId block_id, NodeId id, const BlockRow& row,
                         const ValueRun& run) {
        levels_.push_back(level_of(id, block_id, &row, false));
        fields_.push_back(
            bind_values(grammar::fields_of(row.id)[0], run, id, bound_.ast, reporter_));
    }

    [[nodiscard]] bool holds(NodeId parent, NodeKind kind) const {
        for (NodeId child = cst_.first_child(parent); child.valid();
             child = cst_.next_child(parent, child)) {
            if (cst_.kind(child) == kind) return true;
        }
        return false;
    }
    // An unclosed block with a nameless one in it: the second { is the mistake, and said to be.
    [[nodiscard]] bool holds_nameless(NodeId id) const { return holds(id, NodeKind::kNameless); }
    [[nodiscard]] bool holds_numbers(NodeId id) const { return holds(id, NodeKind::kNumbers); }

    /// A positional block with another number of numbers than it takes.
    [[nodiscard]] bool wrong_count(NodeId id, const BlockRow& row) const {
        if (row.layout != Layout::kPositional || !holds_numbers(id)) return false;
        const CstNode& numbers = cst_.node(cst_.first_child(id));
        const auto due = grammar::arity(grammar::fields_of(row.id)[0].type);
        return numbers.end_token - numbers.first_token != static_cast<std::uint32_t>(due);
    }

    void bind_numbers(NodeId id) {
        const Level& level = levels_.back();
        if (level.row == nullptr || level.row->layout == Layout::kInline) return;
        const CstNode& node = cst_.node(id);
        const CstNode& block = cst_.node(level.node);
        const TokenId name{block.first_token};
        ValueRun run{name, node.first_token, node.end_token, level.row->name};
        if (!open_brace_of(tokens_, block).valid()) run.hint = "they stand in braces, { and }";
        fields_.push_back(
            bind_values(grammar::fields_of(level.row->id)[0], run, id, bound_.ast, reporter_));
    }

    const Tokens& tokens_;
    const Cst& cst_;
    Reporter reporter_;
    BoundAst bound_;
    std::vector<Level> levels_;
    std::vector<BlockNodeId> children_;
    std::vector<FieldNode> fields_;
    std::vector<NodeId> unknown_;
};

}  // namespace

BoundAst bind(source::SourceId source, const Tokens& tokens, const Cst& cst) {
    return Binder(source, tokens, cst).run();
}

}  // namespace cobble::frontend
