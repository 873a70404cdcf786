// SPDX-License-Identifier: MIT
// The blocks of the top level: each once, the camera and the Group always.
#include <fmt/format.h>

#include <array>

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
}

}  // namespace cobble::frontend
