// SPDX-License-Identifier: MIT
#include "frontend/parse/open_blocks.hpp"

namespace cobble::frontend {
namespace {

using grammar::BlockMask;
using grammar::BlockRow;
using grammar::Layout;

// The bit of a block without a known name: it takes everything but the sections of a file.
constexpr BlockMask kUnknownMask = BlockMask{1} << 63U;

BlockMask bit_of(const BlockRow* row) {
    return row == nullptr ? kUnknownMask : grammar::mask_of(row->id);
}

}  // namespace

void OpenBlocks::push(std::uint32_t node, const BlockRow* row, bool bare) {
    const BlockMask around = blocks_.empty() ? grammar::kFileMask : blocks_.back().accepting;
    blocks_.push_back({row, around | bit_of(row), node, bare});
    update_inside();
}

void OpenBlocks::pop() {
    blocks_.pop_back();
    update_inside();
}

void OpenBlocks::update_inside() {
    if (blocks_.empty()) {
        inside_ = Inside::kFile;
    } else if (blocks_.back().row == nullptr) {
        inside_ = Inside::kUnknown;
    } else {
        const Layout layout = blocks_.back().row->layout;
        // An inline block in braces holds what a positional one does.
        inside_ = layout == Layout::kPositional || layout == Layout::kInline ? Inside::kPositional
                                                                             : Inside::kMembers;
    }
}

std::size_t OpenBlocks::home_of(const BlockRow& row) const {
    BlockMask homes = row.parents;
    if (homes != grammar::kFileMask) homes |= kUnknownMask;
    const BlockMask accepting = blocks_.empty() ? grammar::kFileMask : blocks_.back().accepting;
    if ((homes & accepting) == 0) return kNowhere;
    std::size_t depth = blocks_.size();
    while (depth > 0 && (homes & bit_of(blocks_[depth - 1].row)) == 0) --depth;
    return depth;
}

}  // namespace cobble::frontend
