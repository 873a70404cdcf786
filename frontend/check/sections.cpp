// SPDX-License-Identifier: MIT
// The blocks of the top level: each once, the camera and the Group always.
#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <vector>

#include "frontend/check/checks.hpp"

namespace cobble::frontend {
namespace {

const source::DiagnosticCode kMissingSection{
    "missing-section",
    source::Severity::kError,
    "the scene has no camera or no Group",
    "A scene needs a PerspectiveCamera to look through and a Group of objects to look at. "
    "Lights, Background and Materials may be left out.",
    "Group {\n"
    "}\n",
    "Add the block at the top level of the file."};

const source::DiagnosticCode kRepeatedSection{
    "repeated-section",
    source::Severity::kError,
    "a top-level block stands twice",
    "A scene has one camera, one list of lights, one background, one list of materials and one "
    "Group. Published programs forget the first of two without a word.",
    "Background {\n"
    "    color 0 0 0\n"
    "}\n"
    "Background {\n"
    "    color 1 1 1\n"
    "}\n",
    "Merge the two, or put a second Group inside the first."};

const source::DiagnosticCode kEmptyGroup{
    "empty-group",
    source::Severity::kWarning,
    "the Group holds no object",
    "There is nothing to look at: `cobble render` makes no picture of such a scene.",
    "Group {\n"
    "}\n",
    "Add an object, such as a Sphere, to the Group."};

/// True if the block holds an object at any depth, or something that may have been meant as one.
bool may_hold_object(const CheckContext& context, BlockNodeId group) {
    const auto& blocks = context.ast().blocks;
    std::vector<bool> inside(blocks.size(), false);
    inside[group.value] = true;
    for (std::uint32_t i = 0; i < blocks.size(); ++i) {
        const bool within = blocks[i].parent.valid() && inside[blocks[i].parent.value];
        inside[i] = inside[i] || within;
        if (!inside[i]) continue;
        const grammar::Role role = grammar::row(blocks[i].row).role;
        // What a Transform lacks is told of it.
        const bool object = role == grammar::Role::kObject || role == grammar::Role::kTransform;
        if ((within && object) || blocks[i].broken) return true;
        if (context.strange_members(BlockNodeId{i}) > 0) return true;
    }
    return false;
}

}  // namespace

void check_sections(CheckContext& context) {
    std::array<BlockNodeId, grammar::kBlockCount> first;
    for (const BlockNodeId root : context.ast().roots) {
        const grammar::BlockId row = context.block(root).row;
        if (!grammar::may_stand_at_top(row)) continue;
        BlockNodeId& seen = first[static_cast<std::size_t>(row)];
        if (!seen.valid()) {
            seen = root;
            continue;
        }
        if (context.block(root).broken) continue;
        auto& diagnostic =
            context.report(kRepeatedSection, context.name_span(root),
                           fmt::format("{} stands twice at the top level", context.name(root)));
        diagnostic.related.push_back({context.name_span(seen), "the first one is here"});
    }

    if (context.ast().structure_broken) return;
    const std::uint32_t last = context.tokens().size() - 1;
    for (const auto needed : {grammar::BlockId::kPerspectiveCamera, grammar::BlockId::kGroup}) {
        const std::string_view name = grammar::row(needed).name;
        if (first[static_cast<std::size_t>(needed)].valid()) continue;
        if (context.explained(BlockNodeId{}, name)) continue;
        context.report(kMissingSection, context.span(TokenId{last}),
                       fmt::format("the scene has no {}", name));
    }
    const BlockNodeId group = first[static_cast<std::size_t>(grammar::BlockId::kGroup)];
    if (group.valid() && !may_hold_object(context, group)) {
        context.report(kEmptyGroup, context.name_span(group), "the Group holds no object");
    }
}

}  // namespace cobble::frontend
