// SPDX-License-Identifier: MIT
#include "frontend/check/vectors.hpp"

#include <fmt/format.h>

#include "frontend/check/checks.hpp"

namespace cobble::frontend {
namespace {

const source::DiagnosticCode kZeroVector{
    "zero-vector",
    source::Severity::kError,
    "a direction, a normal or an axis has no length",
    "`0 0 0` points nowhere. The length of a direction does not matter, but it must have one.",
    "Group {\n"
    "    MaterialIndex 0\n"
    "    Plane {\n"
    "        normal 0 0 0\n"
    "        offset 1\n"
    "    }\n"
    "}\n",
    "Write a vector with at least one component that is not 0, such as `0 1 0`."};

bool is_direction(grammar::FieldId field) {
    using enum grammar::FieldId;
    return field == kPerspectiveCamera_direction || field == kPerspectiveCamera_up ||
           field == kDirectionalLight_direction || field == kPlane_normal || field == kRotate_value;
}

}  // namespace

std::optional<Numbers3> three_numbers(const CheckContext& context, const FieldNode* field) {
    if (field == nullptr || field->broken || field->value_count < 3) return std::nullopt;
    const auto values = context.ast().values_of(*field);
    Numbers3 numbers;
    for (std::size_t i = 0; i < 3; ++i) {
        numbers[i] = values[i].number;
        if (!fits_single(numbers[i])) return std::nullopt;
    }
    return numbers;
}

void check_zero_vectors(CheckContext& context, BlockNodeId id) {
    for (const FieldNode& field : context.ast().fields_of(id)) {
        if (!is_direction(field.row)) continue;
        const auto vector = three_numbers(context, &field);
        if (!vector || !is_zero(*vector)) continue;
        const bool rotate = field.row == grammar::FieldId::kRotate_value;
        const auto values = context.ast().values_of(field);
        context.report(kZeroVector, context.span(values[0].token, values[2].token),
                       rotate ? std::string("the axis of Rotate has no length")
                              : fmt::format("'{}' of {} has no length",
                                            grammar::row(field.row).name, context.name(id)));
    }
}

}  // namespace cobble::frontend
