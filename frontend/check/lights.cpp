// SPDX-License-Identifier: MIT
#include "frontend/check/checks.hpp"

namespace cobble::frontend {
namespace {

const source::DiagnosticCode kNoLights{
    "no-lights",
    source::Severity::kWarning,
    "the scene has no lights",
    "Without lights the ambient light counts as `1 1 1`, whatever Background says, as it does in "
    "the published programs: every surface has its plain colour.",
    "Lights {\n"
    "}\n",
    "Add a light to Lights."};

}  // namespace

void check_lights(CheckContext& context) {
    // What is unknown at the top level may hold the lights, and an empty file lacks more than them.
    if (context.ast().structure_broken || context.ast().roots.empty()) return;
    if (context.strange_members(BlockNodeId{}) > 0) return;
    source::Span place;
    for (const BlockNodeId root : context.ast().roots) {
        const BlockNode& block = context.block(root);
        if (block.row != grammar::BlockId::kLights) continue;
        // Something that was meant to be a light is no less of one for being misspelt.
        if (block.broken || block.child_count > 0 || context.strange_members(root) > 0) return;
        place = context.name_span(root);
    }
    if (!place.valid()) {
        place = context.span(TokenId{context.tokens().size() - 1});
    }
    auto& diagnostic = context.report(kNoLights, place, "the scene has no lights");
    diagnostic.notes.push_back("the ambient light counts as 1 1 1 instead");
}

}  // namespace cobble::frontend
