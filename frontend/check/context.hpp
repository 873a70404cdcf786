// SPDX-License-Identifier: MIT
// What every check gets: the tree to look at and a place to report to.
//
// A check is a function over one block, or over the whole scene, listed in checks.def. It looks at
// unbroken nodes only, builds no text unless it reports, and reports nothing that follows from
// what the parser has said: `reliable()` and `explained()` answer that.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/ast/ast.hpp"
#include "frontend/check/check.hpp"
#include "frontend/source/diagnostic.hpp"
#include "grammar/vocabulary.hpp"

namespace cobble::frontend {

class CheckContext {
  public:
    explicit CheckContext(CheckedScene& checked) : scene(checked) {}

    CheckedScene& scene;
    std::vector<source::Diagnostic> found;

    [[nodiscard]] const Ast& ast() const { return scene.ast; }
    [[nodiscard]] const Tokens& tokens() const { return scene.tokens; }
    [[nodiscard]] const BlockNode& block(BlockNodeId id) const { return scene.ast.block(id); }
    [[nodiscard]] const grammar::BlockRow& row(BlockNodeId id) const {
        return grammar::row(block(id).row);
    }
    [[nodiscard]] std::string_view name(BlockNodeId id) const { return row(id).name; }

    // --- Places ---
    [[nodiscard]] source::Span span(TokenId token) const;
    /// From the first token to the last, both included.
    [[nodiscard]] source::Span span(TokenId first, TokenId last) const;
    [[nodiscard]] source::Span name_span(BlockNodeId id) const;
    [[nodiscard]] source::Span name_span(const FieldNode& field) const;
    /// All values of a field; its name where it has none.
    [[nodiscard]] source::Span value_span(const FieldNode& field) const;
    /// The bytes to delete so that a node leaves no trace: its whole lines where nothing else
    /// stands on them, else its tokens and the blanks before them.
    [[nodiscard]] source::Span removal_span(NodeId node) const;
    [[nodiscard]] std::string_view text(source::Span span) const {
        return scene.tokens.text.substr(span.begin, span.end - span.begin);
    }

    /// The same for messages: cut short if it is long.
    [[nodiscard]] std::string shown(source::Span span) const;

    // --- What has been said already ---
    /// False where a brace or a section is known to be wrong and the contents of `id` may have
    /// gone astray because of it: then "missing", "unused" and counts are guesses.
    [[nodiscard]] bool reliable(BlockNodeId id) const;
    /// The members of a block (or of the file, for an invalid id) that the parser has complained
    /// about because they have no meaning there.
    [[nodiscard]] std::uint32_t strange_members(BlockNodeId id) const;
    /// True if the parser has complained about a member of `id` (or of the file) that was evidently
    /// meant to be `wanted`: a near name, another dialect's word for it, an unknown block that
    /// begins with what stands in such a block, or values without a name.
    [[nodiscard]] bool explained(BlockNodeId id, std::string_view wanted) const;

    // --- Reporting ---
    /// Adds a finding with its code's severity. The reference holds until the next report. Past
    /// source::kMostFindings of one severity nothing is kept.
    source::Diagnostic& report(const source::DiagnosticCode& code, source::Span span,
                               std::string message);

    /// How many findings of this severity there were, kept or not.
    [[nodiscard]] std::size_t count(source::Severity severity) const {
        return counts_[static_cast<std::size_t>(severity)];
    }

  private:
    [[nodiscard]] NodeId node_of(BlockNodeId id) const {
        return id.valid() ? block(id).cst : NodeId{0};
    }
    std::array<std::size_t, 3> counts_{};  ///< by severity
    [[nodiscard]] std::string_view first_word(NodeId node) const {
        return tokens().text_of(TokenId{scene.cst.node(node).first_token});
    }
    /// True if `member`, a child of the block `parent` or of the file, has no meaning there.
    [[nodiscard]] bool is_strange(BlockNodeId parent, NodeId member) const;
    /// True if the first member of the block `unknown` may stand in the block called `wanted`.
    [[nodiscard]] bool begins_like(NodeId unknown, std::string_view wanted) const;
    /// True if `member`, a field of `parent`, has more values than it takes: the last of them may
    /// be those of another field whose name is missing.
    [[nodiscard]] bool has_surplus(BlockNodeId parent, NodeId member) const;

    source::Diagnostic spare_;
};

}  // namespace cobble::frontend
