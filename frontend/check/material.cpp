// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "frontend/check/checks.hpp"

namespace cobble::frontend {
namespace {

const source::DiagnosticCode kRefractionBelowOne{
    "refraction-index-below-one",
    source::Severity::kWarning,
    "a refraction index between 0 and 1",
    "0 is an opaque material, and what is transparent has 1 (air) or more. A value between them "
    "is drawn, and stands for something thinner than air, such as a bubble seen from the water "
    "around it.",
    "Materials {\n"
    "    Material {\n"
    "        specularColor 1 1 1\n"
    "        refractionIndex 0.75\n"
    "    }\n"
    "}\n",
    "Write 1.33 for water, 1.5 for glass, or 0 for an opaque material."};

}  // namespace

void check_material(CheckContext& context, BlockNodeId id) {
    for (const FieldNode& field : context.ast().fields_of(id)) {
        if (field.broken || field.value_count != 1 ||
            grammar::row(field.row).name != "refractionIndex") {
            continue;
        }
        const Value& value = context.ast().values_of(field)[0];
        if (value.number > 0 && value.number < 1) {
            context.report(kRefractionBelowOne, context.span(value.token),
                           fmt::format("'refractionIndex' of {} is below 1", context.name(id)));
        }
    }
}

}  // namespace cobble::frontend
