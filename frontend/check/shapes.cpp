// SPDX-License-Identifier: MIT
// What single objects demand beyond the ranges of their numbers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "frontend/ast/reporter.hpp"
#include "frontend/check/checks.hpp"
#include "frontend/check/vectors.hpp"

namespace cobble::frontend {
namespace {

const source::DiagnosticCode kDegenerateTriangle{
    "degenerate-triangle",
    source::Severity::kWarning,
    "a triangle without area",
    "Two of its corners are the same, or all three lie on one line, so that no ray can hit it.",
    "Group {\n"
    "    MaterialIndex 0\n"
    "    Triangle {\n"
    "        vertex0 0 0 0\n"
    "        vertex1 1 1 1\n"
    "        vertex2 2 2 2\n"
    "    }\n"
    "}\n",
    "Move a corner, or remove the triangle."};

const source::DiagnosticCode kBoxInsideOut{
    "box-inside-out",
    source::Severity::kError,
    "a box whose min is not below its max",
    "`min` is the corner with the smallest coordinates and `max` the one with the largest; each "
    "component of `min` must be below that of `max`.",
    "Group {\n"
    "    MaterialIndex 0\n"
    "    Box {\n"
    "        min 0 1 0\n"
    "        max 1 0 1\n"
    "    }\n"
    "}\n",
    "Exchange the components that are the wrong way round."};

const source::DiagnosticCode kNotAnObjPath{
    "not-an-obj-path",
    source::Severity::kError,
    "a mesh file that does not end in .obj",
    "`obj_file` is read as Wavefront OBJ, and published programs refuse any other ending, upper "
    "case included.",
    "Group {\n"
    "    MaterialIndex 0\n"
    "    TriangleMesh {\n"
    "        obj_file bunny.ply\n"
    "    }\n"
    "}\n",
    "Convert the mesh to OBJ, or correct the path."};

/// Corners are decimals rounded to double: a height within this many units in the last place of
/// the largest coordinate cannot be told from none (two roundings a corner, three corners, and as
/// many again in the differences and the cross product).
constexpr double kRoundings = 16 * 0x1p-53;

double largest(const Numbers3& v) {
    return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
}

}  // namespace

void check_triangle(CheckContext& context, BlockNodeId id) {
    using enum grammar::FieldId;
    const auto a = three_numbers(context, context.ast().find(id, kTriangle_vertex0));
    const auto b = three_numbers(context, context.ast().find(id, kTriangle_vertex1));
    const auto c = three_numbers(context, context.ast().find(id, kTriangle_vertex2));
    if (!a || !b || !c) return;
    const Numbers3 ab = minus(*b, *a);
    const Numbers3 ac = minus(*c, *a);
    const double scale = std::max({largest(*a), largest(*b), largest(*c)});
    const double longest = std::max(length(ab), length(ac));
    if (length(cross(ab, ac)) > kRoundings * (scale * longest)) return;
    auto& diagnostic =
        context.report(kDegenerateTriangle, context.name_span(id), "the triangle has no area");
    const bool shared = is_zero(ab) || is_zero(ac) || is_zero(minus(*c, *b));
    diagnostic.notes.emplace_back(shared ? "two of its corners are the same"
                                         : "its corners lie on one line");
}

void check_mesh(CheckContext& context, BlockNodeId id) {
    const FieldNode* field = context.ast().find(id, grammar::FieldId::kTriangleMesh_obj_file);
    if (field == nullptr || field->value_count == 0) return;
    const TokenId token = context.ast().values_of(*field)[0].token;
    const std::string_view path = context.tokens().word_of(token);
    if (path.ends_with(".obj")) return;
    context.report(kNotAnObjPath, context.span(token),
                   fmt::format("'obj_file' must end in .obj, and {} does not", quoted(path)));
}

void check_box(CheckContext& context, BlockNodeId id) {
    const FieldNode* min_field = context.ast().find(id, grammar::FieldId::kBox_min);
    const FieldNode* max_field = context.ast().find(id, grammar::FieldId::kBox_max);
    const auto min = three_numbers(context, min_field);
    const auto max = three_numbers(context, max_field);
    if (!min || !max) return;
    std::string axes;
    source::Fix fix{"exchange the components that are the wrong way round", false, {}};
    bool flat = false;
    for (std::size_t i = 0; i < 3; ++i) {
        if ((*min)[i] < (*max)[i]) continue;
        flat = flat || (*min)[i] == (*max)[i];
        if (!axes.empty()) axes += ", ";
        axes += "xyz"[i];
        const source::Span low = context.span(context.ast().values_of(*min_field)[i].token);
        const source::Span high = context.span(context.ast().values_of(*max_field)[i].token);
        fix.edits.push_back({low, std::string(context.text(high))});
        fix.edits.push_back({high, std::string(context.text(low))});
    }
    if (axes.empty()) return;
    auto& diagnostic = context.report(kBoxInsideOut, context.value_span(*min_field),
                                      fmt::format("'min' of Box is not below 'max' in {}", axes));
    diagnostic.related.push_back({context.value_span(*max_field), "'max' is here"});
    if (!flat) diagnostic.fixes.push_back(std::move(fix));
}

}  // namespace cobble::frontend
