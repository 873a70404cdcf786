// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <string_view>
#include <unordered_map>

#include "frontend/check/checks.hpp"

namespace cobble::frontend {
namespace {

const source::DiagnosticCode kDuplicateLabel{
    "duplicate-label",
    source::Severity::kError,
    "two things of one kind have the same label",
    "A label stands for one thing: `MaterialIndex stone` must find one material. Things of "
    "different kinds (a material and a sphere) may share a label.",
    "Materials {\n"
    "    Material stone {\n"
    "        diffuseColor 0.5 0.5 0.5\n"
    "    }\n"
    "    Material stone {\n"
    "        diffuseColor 0.4 0.4 0.4\n"
    "    }\n"
    "}\n",
    "Rename one of the two."};

std::string_view kind_of(grammar::Role role) {
    switch (role) {
        case grammar::Role::kCamera:
            return "camera";
        case grammar::Role::kLight:
            return "light";
        case grammar::Role::kMaterial:
            return "material";
        case grammar::Role::kGroup:
            return "group";
        case grammar::Role::kTransform:
            return "transform";
        default:
            return "object";
    }
}

}  // namespace

void check_labels(CheckContext& context) {
    std::unordered_map<std::string_view, TokenId>
        seen[static_cast<std::size_t>(grammar::Role::kMotion) + 1];
    for (std::uint32_t i = 0; i < context.ast().blocks.size(); ++i) {
        const BlockNode& block = context.ast().blocks[i];
        if (!block.label.valid()) continue;
        const grammar::Role role = grammar::row(block.row).role;
        const std::string_view label = context.tokens().word_of(block.label);
        const auto [found, fresh] =
            seen[static_cast<std::size_t>(role)].try_emplace(label, block.label);
        if (fresh) continue;
        auto& diagnostic =
            context.report(kDuplicateLabel, context.span(block.label),
                           fmt::format("there is another {} '{}'", kind_of(role), label));
        diagnostic.related.push_back(
            {context.span(found->second), fmt::format("'{}' is first given here", label)});
    }
}

}  // namespace cobble::frontend
