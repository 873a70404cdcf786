// SPDX-License-Identifier: MIT
// The blocks that are open while the tree is built, innermost last, and what may stand in them.
#pragma once

#include <cstdint>
#include <vector>

#include "grammar/vocabulary.hpp"

namespace cobble::frontend {

/// What the innermost open block takes.
enum class Inside : std::uint8_t {
    kFile,        ///< nothing is open
    kMembers,     ///< named fields and blocks
    kPositional,  ///< bare numbers
    kUnknown,     ///< anything: the block has no name, or one that nobody knows
};

class OpenBlocks {
  public:
    struct Block {
        const grammar::BlockRow* row;  ///< null if it has no known name
        grammar::BlockMask
            accepting;       ///< this and all blocks around it, as bits of `parents` masks
        std::uint32_t node;  ///< its node in the tree
        bool bare;           ///< it was opened without a {
    };

    static constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

    [[nodiscard]] bool empty() const { return blocks_.empty(); }
    [[nodiscard]] std::size_t depth() const { return blocks_.size(); }
    [[nodiscard]] const Block& top() const { return blocks_.back(); }
    [[nodiscard]] const Block& at(std::size_t depth) const { return blocks_[depth]; }
    [[nodiscard]] Inside inside() const { return inside_; }

    void push(std::uint32_t node, const grammar::BlockRow* row, bool bare);
    void pop();

    /// The depth to close down to so that `row` may stand there: depth() if it may stand in the
    /// innermost block, less if only in one around it, kNowhere if in none. Cost: the number of
    /// blocks that will be closed.
    [[nodiscard]] std::size_t home_of(const grammar::BlockRow& row) const;

  private:
    void update_inside();

    std::vector<Block> blocks_;
    Inside inside_ = Inside::kFile;
};

}  // namespace cobble::frontend
