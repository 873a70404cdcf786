// SPDX-License-Identifier: MIT
// What a block holds already, and so what else may be written in it.
//
// Input: where something is being typed. Output: counts by row of the vocabulary, read from the
// CST, so that broken members count too. The word that is being typed is no member. Cost: the
// members of the block.
#pragma once

#include <array>
#include <cstdint>

#include "frontend/editor/typing.hpp"

namespace cobble::frontend::editor {

/// The members of a block, or of the file.
struct Members {
    std::array<std::uint32_t, grammar::kFieldCount> fields{};
    std::array<std::uint32_t, grammar::kBlockCount> blocks{};
    std::uint32_t counted = 0;  ///< blocks that a `num...` field counts
    // In a Transform, where order is all: moves, then a Motion, then one object.
    bool object = false;
    bool object_before = false;
    bool move_behind = false;
    bool motion_before = false;
    bool matrix = false;  ///< a move that no Motion may hold
};

Members members_of(const CheckedScene& scene, const Typing& typing);

/// True if a block may be written there: the vocabulary allows it in the block around, and
/// neither what is there already nor the order that a Transform demands forbids it.
bool fits(const grammar::BlockRow& row, const Typing& typing, const Members& members);

}  // namespace cobble::frontend::editor
