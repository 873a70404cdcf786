// SPDX-License-Identifier: MIT
// Makes the tree from what the grammar of tokens matches, and decides where braces are missing.
//
// Invariant: every token before the current place belongs to exactly one node, and the open blocks
// are those nodes whose end_token is 0.
#pragma once

#include <cstdint>
#include <optional>

#include "frontend/lex/tokens.hpp"
#include "frontend/parse/cst.hpp"
#include "frontend/parse/open_blocks.hpp"
#include "frontend/parse/recovery.hpp"
#include "grammar/vocabulary.hpp"

namespace cobble::frontend {

class TreeBuilder {
  public:
    TreeBuilder(const Tokens& tokens, Cst& cst);

    [[nodiscard]] const OpenBlocks& open_blocks() const { return open_; }

    // The tokens [begin, end) are ...
    void add_field(std::uint32_t begin, std::uint32_t end);
    void add_inline_block(std::uint32_t begin, std::uint32_t end);
    void add_numbers(std::uint32_t begin, std::uint32_t end);
    void add_error(NodeKind kind, std::uint32_t begin, std::uint32_t end);
    void add_unknown(std::uint32_t begin, std::uint32_t end);
    void add_lone_head(std::uint32_t begin, std::uint32_t end);
    /// ... A block begins here; `bare` without its {.
    void enter_block(std::uint32_t begin, std::uint32_t end, bool bare);
    void enter_nameless(std::uint32_t begin);
    void close_block(std::uint32_t brace);
    void finish(std::uint32_t end_of_file);

    /// If blocks are still open at the end, looks for a better place where they should have ended.
    void look_back_from_end(std::uint32_t end_of_file);
    /// The token to go on from, if it is not the next one. Asking forgets it.
    std::optional<std::uint32_t> take_resume_place();

  private:
    enum class Placing : std::uint8_t { kPlaced, kMisplaced, kResumed };

    std::uint32_t add_node(NodeKind kind, std::uint32_t begin, std::uint32_t end, bool error);
    void open_node(std::uint32_t begin, const grammar::BlockRow* row, bool bare, bool error,
                   NodeKind kind);
    void end_top(std::uint32_t end, bool unclosed);
    Placing place(const grammar::BlockRow& row, std::uint32_t begin);
    bool look_back(std::size_t depth, std::uint32_t place);
    bool look_back_for_extra(std::uint32_t place);
    bool afford(std::uint64_t cost);
    void cut_back(const Culprit& culprit, std::size_t depth);
    void leave_bare_positional(std::uint32_t at);
    [[nodiscard]] bool is_own_brace(std::uint32_t brace);
    Placing reopen_for(const grammar::BlockRow* row, grammar::WordId word, std::uint32_t begin);
    bool ends_enclosed_block(grammar::WordId word, std::uint32_t begin);
    [[nodiscard]] bool fits_top(std::uint32_t token) const;
    [[nodiscard]] const grammar::BlockRow* row_of(std::uint32_t token) const;
    [[nodiscard]] bool values_fit(grammar::ValueType type, std::uint32_t begin,
                                  std::uint32_t end) const;

    const Tokens& tokens_;
    Cst& cst_;
    OpenBlocks open_;
    std::optional<std::uint32_t> resume_;
    std::uint32_t last_closed_ = 0;  ///< the block that ended last
    /// How many more } than { the file has, less the } that blocks without { have taken. Counted
    /// when it is first asked for.
    std::optional<std::int64_t> surplus_;
    std::uint64_t budget_;  ///< how many tokens may still be read again
};

}  // namespace cobble::frontend
