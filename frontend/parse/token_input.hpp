// SPDX-License-Identifier: MIT
// Tokens as the input of the grammar of tokens (grammar/structure.hpp).
//
// It answers what a token is at its place: a question of its kind, of its neighbours, and of the
// vocabulary given the innermost open block. A place is a token's index.
#pragma once

#include <cstdint>

#include <tao/pegtl.hpp>

#include "frontend/lex/tokens.hpp"
#include "frontend/parse/tree_builder.hpp"
#include "grammar/structure.hpp"
#include "grammar/vocabulary.hpp"

namespace cobble::frontend {

class TokenInput {
  public:
    using iterator_t = std::uint32_t;

    /// What an action sees: the tokens [begin, end) that its rule has matched.
    class action_t {
      public:
        action_t(std::uint32_t begin, const TokenInput& in) : begin_(begin), in_(&in) {}
        [[nodiscard]] std::uint32_t begin() const { return begin_; }
        [[nodiscard]] std::uint32_t end() const { return in_->current_; }
        [[nodiscard]] const TokenInput& input() const { return *in_; }

      private:
        std::uint32_t begin_;
        const TokenInput* in_;
    };

    TokenInput(const Tokens& tokens, TreeBuilder& builder)
        : tokens_(tokens), builder_(builder), size_(tokens.size()) {}

    // What PEGTL asks of an input.
    [[nodiscard]] bool empty() const { return current_ == size_; }
    void bump() { ++current_; }
    template <tao::pegtl::rewind_mode mode>
    [[nodiscard]] auto mark() {
        return tao::pegtl::internal::marker<iterator_t, mode>(current_);
    }

    // What the grammar asks.
    template <grammar::structure::Symbol symbol>
    [[nodiscard]] bool is() {
        using enum grammar::structure::Symbol;
        if (empty()) return false;
        const TokenKind kind = kind_at(current_);
        if constexpr (symbol == kOpen) return kind == TokenKind::kOpenBrace;
        if constexpr (symbol == kClose) return kind == TokenKind::kCloseBrace;
        if constexpr (symbol == kEnd) return kind == TokenKind::kEndOfFile;
        if constexpr (symbol == kLiteral) return is_literal(kind);
        if constexpr (symbol == kName) return kind == TokenKind::kWord;
        if constexpr (symbol == kFieldName) return kind == TokenKind::kWord && at_field_name();
        if constexpr (symbol == kInlineName) return kind == TokenKind::kWord && at_inline_name();
        if constexpr (symbol == kBlockName) return kind == TokenKind::kWord && at_block_name();
        if constexpr (symbol == kLabel) return is_value(kind) && at_label();
        if constexpr (symbol == kBareLabel) return kind == TokenKind::kWord && at_bare_label();
        if constexpr (symbol == kMember) return at_member();
        if constexpr (symbol == kWordValue) return is_text(kind) && at_word_value();
        if constexpr (symbol == kOddValue) return is_text(kind) && at_odd_value();
        if constexpr (symbol == kBareValue) return at_bare_value();
        if constexpr (symbol == kStrayValue) return at_stray_value();
        if constexpr (symbol == kProse) return is_text(kind) && at_prose();
    }
    bool recover();
    bool recover_at_end();

  private:
    static bool is_literal(TokenKind kind) {
        return kind == TokenKind::kNumber || kind == TokenKind::kColor;
    }
    static bool is_value(TokenKind kind) { return is_literal(kind) || is_text(kind); }
    static bool is_text(TokenKind kind) {
        return kind == TokenKind::kWord || kind == TokenKind::kString ||
               kind == TokenKind::kUnterminatedString;
    }
    [[nodiscard]] TokenKind kind_at(std::uint32_t at) const {
        return static_cast<TokenKind>(tokens_.tokens[at].kind);
    }
    [[nodiscard]] bool brace_follows() const {
        return current_ + 1 < size_ && kind_at(current_ + 1) == TokenKind::kOpenBrace;
    }
    [[nodiscard]] bool on_line_of_previous() const {
        return current_ > 0 && !tokens_.line_ends_after({current_ - 1});
    }
    /// The word at the current token, looked up once for each place.
    grammar::WordId word();

    bool at_field_name();
    bool at_inline_name();
    bool at_block_name();
    bool at_label();
    bool is_word_as_label();
    [[nodiscard]] bool may_begin(const grammar::BlockRow& block, std::uint32_t token) const;
    bool at_bare_label();
    bool at_member();
    bool at_word_value();
    bool at_odd_value();
    bool at_bare_value();
    bool at_stray_value();
    bool at_prose();

    const Tokens& tokens_;
    TreeBuilder& builder_;
    std::uint32_t size_;
    std::uint32_t current_ = 0;
    std::uint32_t word_at_ = 0xffffffffU;  ///< the place that word_ was looked up for
    grammar::WordId word_;
    const grammar::BlockRow* head_ = nullptr;  ///< the last name of a block with braces
    std::uint32_t values_begin_ = 0;           ///< the first token after the last name of a field
    std::uint32_t values_due_ = 0;             ///< how many values that field takes
};

}  // namespace cobble::frontend
