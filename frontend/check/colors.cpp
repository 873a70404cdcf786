// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "frontend/check/checks.hpp"
#include "frontend/check/vectors.hpp"

namespace cobble::frontend {
namespace {

const source::DiagnosticCode kColorOutOfRange{
    "color-out-of-range",
    source::Severity::kError,
    "a colour component is outside 0 to 1",
    "Colours of surfaces and of the background have components from 0 to 1: a surface that sends "
    "back more light than it gets does not exist. Lights may be brighter than 1, but not negative.",
    "Materials {\n"
    "    Material {\n"
    "        diffuseColor 255 128 0\n"
    "    }\n"
    "}\n",
    "Divide components from 0 to 255 by 255, or write the colour as `#ff8000`."};

const source::DiagnosticCode kLightColorAboveOne{
    "light-color-above-one",
    source::Severity::kWarning,
    "a light is brighter than 1",
    "This is allowed, and useful for a lamp with a `falloff`, but whatever it lights fully is "
    "cut off at white.",
    "Lights {\n"
    "    DirectionalLight {\n"
    "        direction 0 -1 0\n"
    "        color 2 2 2\n"
    "    }\n"
    "}\n",
    "Keep the components at or below 1, unless the brightness is meant."};

/// A component above this was meant as a byte rather than as a very bright light.
constexpr double kSurelyByte = 10;

/// `255 128 0` as #ff8000, if that can be what was meant.
bool offer_hex(const CheckContext& context, const FieldNode& field,
               source::Diagnostic& diagnostic) {
    const auto values = context.ast().values_of(field);
    if (values.size() != 3) return false;
    const bool bytes = std::ranges::all_of(values, [](const Value& value) {
        return value.number >= 0 && value.number <= 255 && std::floor(value.number) == value.number;
    });
    const double largest = std::ranges::max(values, {}, &Value::number).number;
    if (!bytes || largest <= kSurelyByte) return false;
    const std::string hex =
        fmt::format("#{:02x}{:02x}{:02x}", static_cast<int>(values[0].number),
                    static_cast<int>(values[1].number), static_cast<int>(values[2].number));
    diagnostic.fixes.push_back({fmt::format("write {}, taking the components as 0 to 255", hex),
                                false,
                                {{context.value_span(field), hex}}});
    return true;
}

void check_color(CheckContext& context, BlockNodeId id, const FieldNode& field,
                 const grammar::FieldRow& row) {
    const grammar::Range& range = row.range;
    bool found = false;
    for (const Value& value : context.ast().values_of(field)) {
        if (value.number >= range.low && value.number <= range.high) continue;
        // Said already, as a number out of range.
        if (!fits_single(value.number)) {
            found = true;
            continue;
        }
        const source::Span place = context.span(value.token);
        const bool bounded = range.high < std::numeric_limits<double>::infinity();
        auto& diagnostic = context.report(
            kColorOutOfRange, place,
            fmt::format("'{}' of {} {}, not {}", row.name, context.name(id),
                        bounded ? "must lie between 0 and 1" : "must not be negative",
                        context.shown(place)));
        found = true;
        // The other components are the same mistake then.
        if (value.number > 1 && offer_hex(context, field, diagnostic)) return;
    }
    if (found) return;
    for (const Value& value : context.ast().values_of(field)) {
        if (value.number <= range.warn_above) continue;
        context.report(kLightColorAboveOne, context.span(value.token),
                       fmt::format("'{}' of {} is brighter than {}", row.name, context.name(id),
                                   range.warn_above));
        return;
    }
}

}  // namespace

void check_colors(CheckContext& context, BlockNodeId id) {
    for (const FieldNode& field : context.ast().fields_of(id)) {
        if (field.broken) continue;
        const grammar::FieldRow& row = grammar::row(field.row);
        if (row.type == grammar::ValueType::kColor) check_color(context, id, field, row);
    }
}

}  // namespace cobble::frontend
