// SPDX-License-Identifier: MIT
// Transforms that flatten space.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "frontend/check/checks.hpp"
#include "frontend/check/examples.hpp"
#include "frontend/check/vectors.hpp"

namespace cobble::frontend {
namespace {

const source::DiagnosticCode kSingularTransform{
    "singular-transform",
    source::Severity::kError,
    "a transform that cannot be undone",
    "A factor of 0 or a singular matrix flattens the object to a sheet, a line or a point. Rays "
    "are taken into the object's own space by the inverse, which does not exist then.",
    transform_example("Scale 1 0 1\n"),
    "Write a small factor, such as 0.001, in place of 0."};

const source::DiagnosticCode kMatrixNotAffine{
    "matrix-not-affine",
    source::Severity::kWarning,
    "a matrix whose last row is not 0 0 0 1",
    "`Matrix4f` is written column by column, so that its last row is every fourth number. A "
    "transform of objects has `0 0 0 1` there; anything else is ignored.",
    transform_example("Matrix4f { 1 0 0 2  0 1 0 0  0 0 1 0  0 0 0 1 }\n"),
    "If the matrix is written row by row, transpose it."};

/// Rounding of a 3x3 determinant in double, in units of the product of its columns' lengths: nine
/// products and five sums, each with half a unit in the last place.
constexpr double kDeterminantRounding = 16 * 0x1p-53;

void check_matrix(CheckContext& context, BlockNodeId id, const FieldNode& field) {
    const auto values = context.ast().values_of(field);
    if (values.size() != 16) return;
    std::array<Numbers3, 3> columns;
    for (std::size_t i = 0; i < 16; ++i) {
        if (!fits_single(values[i].number)) return;
        if (i < 12 && i % 4 < 3) columns[i / 4][i % 4] = values[i].number;
    }
    const double determinant = dot(columns[0], cross(columns[1], columns[2]));
    const double size = length(columns[0]) * length(columns[1]) * length(columns[2]);
    if (!(std::fabs(determinant) > kDeterminantRounding * size)) {
        context.report(kSingularTransform, context.name_span(id),
                       "the matrix is singular: it cannot be undone");
        return;
    }
    if (values[3].number == 0 && values[7].number == 0 && values[11].number == 0 &&
        values[15].number == 1) {
        return;
    }
    auto& diagnostic = context.report(kMatrixNotAffine, context.name_span(id),
                                      "the last row of the matrix is not 0 0 0 1");
    diagnostic.notes.emplace_back("the numbers stand column by column");
}

}  // namespace

void check_singular_move(CheckContext& context, BlockNodeId id) {
    for (const FieldNode& field : context.ast().fields_of(id)) {
        if (field.broken) continue;
        if (context.block(id).row == grammar::BlockId::kMatrix4f) {
            check_matrix(context, id, field);
            continue;
        }
        for (const Value& value : context.ast().values_of(field)) {
            if (!is_zero(value.number)) continue;
            context.report(kSingularTransform, context.span(value.token),
                           fmt::format("a factor of {} must not be 0", context.name(id)));
        }
    }
}

}  // namespace cobble::frontend
