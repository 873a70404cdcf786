// SPDX-License-Identifier: MIT
// The shape of a file: its blocks as a tree, what can be folded, and growing selections.
//
// Input: a checked scene and its text; broken files give what could be read of them. Output: flat
// arrays of byte ranges inside the text. Cost: the outline is one pass over the blocks, folding one
// over the text, a selection the siblings along one path.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/check/check.hpp"

namespace cobble::frontend::editor {

struct OutlineItem {
    std::string name;    ///< the block's label, or else its name
    std::string detail;  ///< "Sphere, glass, radius 1": what the name does not say
    grammar::Role role;
    BlockNodeId block;
    ByteRange span;       ///< the whole block
    ByteRange name_span;  ///< its label or name, inside `span`
    std::uint32_t depth;  ///< 0 for blocks of the top level
    std::uint32_t end;    ///< its descendants are the items between its own index and this one
};

/// The blocks of the file in preorder, but for MaterialIndex and the single moves of a Transform,
/// which show in the details of what they apply to.
std::vector<OutlineItem> outline(const CheckedScene& scene, std::string_view text);

enum class FoldKind : std::uint8_t { kBlock, kComment };

/// `begin` and `end` stand on different lines. A block folds from its { to before its }, so that
/// both stay to be seen; comments from the first one's end to the last one's.
struct Fold {
    ByteRange span;
    FoldKind kind;
};

/// Blocks and runs of at least two comments that stand alone on neighbouring lines; in order of
/// their begin.
std::vector<Fold> folds(const CheckedScene& scene, std::string_view text);

/// What to select around an offset, from the smallest to the whole file: the token, its field's
/// values, the field, the members of the block, the block, and so on outward. Each holds the one
/// before it, the offset, and more bytes.
std::vector<ByteRange> selections(const CheckedScene& scene, std::string_view text,
                                  std::uint32_t offset);

}  // namespace cobble::frontend::editor
