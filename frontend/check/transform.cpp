// SPDX-License-Identifier: MIT
// Transform: transforms, then one object.
#include <fmt/format.h>

#include "frontend/check/checks.hpp"
#include "frontend/check/examples.hpp"

namespace cobble::frontend {
namespace {

const source::DiagnosticCode kTransformSecondObject{
    "transform-second-object",
    source::Severity::kError,
    "a Transform holds two objects",
    "A Transform moves one object, and published programs stop at a second one.",
    "Group {\n"
    "    MaterialIndex 0\n"
    "    Transform {\n"
    "        Translate 0 1 0\n"
    "        Sphere {\n"
    "            center 0 0 0\n"
    "            radius 1\n"
    "        }\n"
    "        Sphere {\n"
    "            center 2 0 0\n"
    "            radius 1\n"
    "        }\n"
    "    }\n"
    "}\n",
    "Put the objects into a Group inside the Transform."};

const source::DiagnosticCode kTransformWithoutObject{
    "transform-without-object",
    source::Severity::kError,
    "a Transform holds no object",
    "There is nothing that it could move.",
    "Group {\n"
    "    Transform {\n"
    "        Translate 0 1 0\n"
    "    }\n"
    "}\n",
    "Put an object, a Group or another Transform at its end, or remove it."};

const source::DiagnosticCode kTransformObjectNotLast{
    "transform-object-not-last",
    source::Severity::kWarning,
    "transforms stand behind the object that they move",
    "Every transform in the block applies to its object, wherever that stands, but published "
    "programs demand the object at the end.",
    "Group {\n"
    "    MaterialIndex 0\n"
    "    Transform {\n"
    "        Sphere {\n"
    "            center 0 0 0\n"
    "            radius 1\n"
    "        }\n"
    "        Translate 0 1 0\n"
    "    }\n"
    "}\n",
    "Move the object to the end of the block."};

const source::DiagnosticCode kTransformWithoutMove{
    "transform-without-move",
    source::Severity::kWarning,
    "a Transform changes nothing",
    "It holds an object but no Translate, Scale, rotation or matrix.",
    transform_example(""),
    "Take the object out of the Transform, or add a transform."};

bool is_object(grammar::Role role) {
    return role == grammar::Role::kObject || role == grammar::Role::kGroup ||
           role == grammar::Role::kTransform;
}

}  // namespace

void check_transform(CheckContext& context, BlockNodeId id) {
    BlockNodeId object;
    BlockNodeId late;  // the first transform behind the object
    bool moves = false;
    for (const BlockNodeId child : context.ast().children_of(id)) {
        const grammar::Role role = context.row(child).role;
        if (role == grammar::Role::kMove || role == grammar::Role::kMotion) {
            moves = true;
            if (object.valid() && !late.valid()) late = child;
        } else if (is_object(role)) {
            if (!object.valid()) {
                object = child;
                continue;
            }
            if (context.block(child).broken || !context.reliable(id)) continue;
            auto& diagnostic =
                context.report(kTransformSecondObject, context.name_span(child),
                               fmt::format("a Transform holds one object, and this {} is another",
                                           context.name(child)));
            diagnostic.related.push_back({context.name_span(object), "the first object is here"});
        }
    }
    if (late.valid()) {
        auto& diagnostic = context.report(
            kTransformObjectNotLast, context.name_span(object),
            fmt::format("{} stands before transforms that apply to it", context.name(object)));
        diagnostic.related.push_back(
            {context.name_span(late), fmt::format("{} applies to it as well", context.name(late))});
    }
    if ((object.valid() && moves) || !context.reliable(id) || context.strange_members(id) > 0) {
        return;
    }
    if (!object.valid()) {
        context.report(kTransformWithoutObject, context.name_span(id),
                       "the Transform holds no object");
    } else {
        context.report(kTransformWithoutMove, context.name_span(id),
                       "the Transform holds no transform");
    }
}

}  // namespace cobble::frontend
