// SPDX-License-Identifier: MIT
// Motion: the transforms of its Transform once more, as they are when the shutter time is 1.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "frontend/check/checks.hpp"
#include "frontend/check/examples.hpp"
#include "frontend/check/vectors.hpp"

namespace cobble::frontend {
namespace {

const source::DiagnosticCode kRepeatedMotion{
    "repeated-motion",
    source::Severity::kError,
    "a Transform holds two Motions",
    "A Motion says where things are at shutter time 1, and there is one such time.",
    transform_example("Translate 0 0 0\n"
                      "Motion {\n"
                      "    Translate 1 0 0\n"
                      "}\n"
                      "Motion {\n"
                      "    Translate 2 0 0\n"
                      "}\n"),
    "Keep one of them; for a motion of two parts, nest two Transforms."};

const source::DiagnosticCode kMotionNotLast{
    "motion-not-last",
    source::Severity::kError,
    "a transform stands behind Motion",
    "Motion stands after all transforms of its Transform and directly before the object, so that "
    "the two lists can be compared at a glance.",
    transform_example("Motion {\n"
                      "    Translate 1 0 0\n"
                      "}\n"
                      "Translate 0 0 0\n"),
    "Move the Motion behind the transforms."};

const source::DiagnosticCode kMotionDiffers{
    "motion-differs",
    source::Severity::kError,
    "Motion lists other transforms than its Transform",
    "Arguments are interpolated one by one, so that each transform needs its counterpart: the "
    "same keywords in the same order, those that do not change included.",
    transform_example("Translate 0 0 0\n"
                      "YRotate 0\n"
                      "Motion {\n"
                      "    Translate 1 0 0\n"
                      "}\n"),
    "Repeat the transforms of the Transform in the Motion, and change their arguments only."};

const source::DiagnosticCode kMatrixCannotMove{
    "matrix-cannot-move",
    source::Severity::kError,
    "a Matrix4f in a Transform with Motion",
    "The numbers of a matrix cannot be interpolated one by one: halfway between two rotations "
    "lies no rotation.",
    transform_example("Matrix4f { 1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1 }\n"
                      "Translate 0 0 0\n"
                      "Motion {\n"
                      "    Translate 1 0 0\n"
                      "}\n"),
    "Give the matrix a Transform of its own around or inside the one that moves."};

const source::DiagnosticCode kMotionThroughZero{
    "motion-through-zero",
    source::Severity::kError,
    "a scale or an axis passes through zero",
    "Arguments are interpolated in a straight line. A factor that changes its sign is 0 at some "
    "moment, and so is an axis that turns into its opposite.",
    transform_example("Scale 1 1 1\n"
                      "Motion {\n"
                      "    Scale -1 1 1\n"
                      "}\n"),
    "Keep the sign of factors, and turn with a rotation instead."};

struct MovingTransform {
    BlockNodeId motion;
    std::vector<BlockNodeId> start;   ///< the transforms at time 0
    std::vector<BlockNodeId> finish;  ///< those of Motion
};

const FieldNode* numbers_of(const CheckContext& context, BlockNodeId move) {
    const auto fields = context.ast().fields_of(move);
    if (context.block(move).broken || fields.size() != 1 || fields[0].broken) return nullptr;
    return &fields[0];
}

/// True if the straight way from one argument to the other meets zero strictly between them.
bool passes_zero(const CheckContext& context, const FieldNode& from, const FieldNode& to) {
    if (from.row == grammar::FieldId::kRotate_value) {
        const auto a = three_numbers(context, &from);
        const auto b = three_numbers(context, &to);
        return a && b && are_opposite(*a, *b);
    }
    if (from.row != grammar::FieldId::kScale_value &&
        from.row != grammar::FieldId::kUniformScale_value) {
        return false;
    }
    const auto starts = context.ast().values_of(from);
    const auto ends = context.ast().values_of(to);
    for (std::size_t i = 0; i < std::min(starts.size(), ends.size()); ++i) {
        const double a = starts[i].number;
        const double b = ends[i].number;
        if ((a < 0 && b > 0) || (a > 0 && b < 0)) return true;
    }
    return false;
}

void compare(CheckContext& context, const MovingTransform& moving) {
    const std::size_t common = std::min(moving.start.size(), moving.finish.size());
    for (std::size_t i = 0; i < common; ++i) {
        if (context.block(moving.start[i]).row == context.block(moving.finish[i]).row) continue;
        auto& diagnostic = context.report(
            kMotionDiffers, context.name_span(moving.finish[i]),
            fmt::format("transform {} of Motion is {}, but that of the Transform is {}", i + 1,
                        context.name(moving.finish[i]), context.name(moving.start[i])));
        diagnostic.related.push_back({context.name_span(moving.start[i]), "its counterpart"});
        return;
    }
    if (moving.start.size() > common) {
        auto& diagnostic =
            context.report(kMotionDiffers, context.name_span(moving.motion),
                           fmt::format("Motion has no counterpart of transform {}, {}", common + 1,
                                       context.name(moving.start[common])));
        diagnostic.related.push_back({context.name_span(moving.start[common]), "it stands here"});
    } else if (moving.finish.size() > common) {
        context.report(kMotionDiffers, context.name_span(moving.finish[common]),
                       fmt::format("transform {} of Motion, {}, has no counterpart before it",
                                   common + 1, context.name(moving.finish[common])));
    }
    for (std::size_t i = 0; i < common; ++i) {
        const FieldNode* from = numbers_of(context, moving.start[i]);
        const FieldNode* to = numbers_of(context, moving.finish[i]);
        if (from == nullptr || to == nullptr || !passes_zero(context, *from, *to)) continue;
        const bool axis = from->row == grammar::FieldId::kRotate_value;
        auto& diagnostic = context.report(
            kMotionThroughZero, context.value_span(*to),
            fmt::format("{} of {} passes through zero during the motion",
                        axis ? "the axis" : "a factor", context.name(moving.finish[i])));
        diagnostic.related.push_back({context.value_span(*from), "it starts from here"});
    }
}

}  // namespace

void check_motion(CheckContext& context, BlockNodeId id) {
    MovingTransform moving;
    BlockNodeId behind;
    for (const BlockNodeId child : context.ast().children_of(id)) {
        const BlockNode& block = context.block(child);
        const grammar::Role role = context.row(child).role;
        if (role == grammar::Role::kMotion) {
            if (moving.motion.valid()) {
                auto& diagnostic =
                    context.report(kRepeatedMotion, context.name_span(child),
                                   "a Transform holds one Motion, and this is another");
                diagnostic.related.push_back(
                    {context.name_span(moving.motion), "the first one is here"});
                return;
            }
            moving.motion = child;
        } else if (role == grammar::Role::kMove) {
            if (moving.motion.valid() && !behind.valid()) behind = child;
            if (block.row != grammar::BlockId::kMatrix4f) moving.start.push_back(child);
        }
    }
    if (!moving.motion.valid() || context.block(moving.motion).broken) return;
    if (!context.reliable(id) || !context.reliable(moving.motion)) return;
    if (context.strange_members(id) > 0 || context.strange_members(moving.motion) > 0) return;

    if (behind.valid()) {
        auto& diagnostic =
            context.report(kMotionNotLast, context.name_span(moving.motion),
                           fmt::format("Motion stands before {}", context.name(behind)));
        diagnostic.related.push_back(
            {context.name_span(behind), "this transform must stand before Motion"});
    }
    for (const BlockNodeId child : context.ast().children_of(id)) {
        if (context.block(child).row != grammar::BlockId::kMatrix4f) continue;
        auto& diagnostic =
            context.report(kMatrixCannotMove, context.name_span(child), "a Matrix4f cannot move");
        diagnostic.related.push_back(
            {context.name_span(moving.motion), "this Motion would have to move it"});
    }
    for (const BlockNodeId child : context.ast().children_of(moving.motion)) {
        if (context.row(child).role == grammar::Role::kMove) moving.finish.push_back(child);
    }
    compare(context, moving);
}

}  // namespace cobble::frontend
