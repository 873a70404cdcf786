// SPDX-License-Identifier: MIT
// numLights, numMaterials and numObjects against what stands in the list.
#include <fmt/format.h>

#include <string>

#include "frontend/check/checks.hpp"

namespace cobble::frontend {
namespace {

const source::DiagnosticCode kWrongCount{
    "wrong-count",
    source::Severity::kError,
    "a count does not match its list",
    "`numLights`, `numMaterials` and `numObjects` are optional, but where one stands it must be "
    "right: the published programs read exactly that many members and stop. A `MaterialIndex` is "
    "no object.",
    "Group {\n"
    "    numObjects 2\n"
    "    MaterialIndex 0\n"
    "    Sphere {\n"
    "        center 0 0 0\n"
    "        radius 1\n"
    "    }\n"
    "}\n",
    "Write the right number, or leave the line out."};

std::string_view members_of(grammar::BlockId list) {
    switch (list) {
        case grammar::BlockId::kLights:
            return "light";
        case grammar::BlockId::kMaterials:
            return "material";
        default:
            return "object";
    }
}

}  // namespace

void check_count(CheckContext& context, BlockNodeId id) {
    const grammar::BlockId list = context.block(id).row;
    const FieldNode* field = nullptr;
    for (const FieldNode& candidate : context.ast().fields_of(id)) {
        if (grammar::row(candidate.row).type != grammar::ValueType::kCount) continue;
        // Two counts are a duplicate argument, and only one of them can be right.
        if (field != nullptr) return;
        field = &candidate;
    }
    if (field == nullptr || field->broken || field->value_count == 0) return;

    std::uint32_t count = 0;
    for (const BlockNodeId child : context.ast().children_of(id)) {
        const grammar::BlockId row = context.block(child).row;
        if (row == grammar::BlockId::kMaterialIndex || !grammar::may_stand_in(row, list)) continue;
        ++count;
    }
    const Value& value = context.ast().values_of(*field)[0];
    if (value.number == count) return;
    // A member that the parser could not place may or may not have been counted.
    if (!context.reliable(id)) return;
    const std::uint32_t strange = context.strange_members(id);
    if (value.number > count && value.number <= static_cast<double>(count) + strange) return;

    const std::string_view name = grammar::row(field->row).name;
    const std::string_view member = members_of(list);
    auto& diagnostic =
        context.report(kWrongCount, context.span(value.token),
                       fmt::format("'{}' is {}, but {} holds {} {}{}", name,
                                   context.shown(context.span(value.token)), context.name(id),
                                   count, member, count == 1 ? "" : "s"));
    diagnostic.fixes.push_back({fmt::format("change '{}' to {}", name, count),
                                true,
                                {{context.span(value.token), std::to_string(count)}}});
}

}  // namespace cobble::frontend
