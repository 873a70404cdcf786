// SPDX-License-Identifier: MIT
// Numbers outside the range that the vocabulary gives them.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

#include "frontend/check/checks.hpp"
#include "frontend/check/examples.hpp"
#include "frontend/check/vectors.hpp"

namespace cobble::frontend {
namespace {

const source::DiagnosticCode kValueOutOfRange{
    "value-out-of-range",
    source::Severity::kError,
    "a value is outside its allowed range",
    "The value has no meaning there: an exponent below zero, more aperture blades than can be "
    "drawn, a number that single precision cannot hold.",
    "Materials {\n"
    "    Material {\n"
    "        shininess -20\n"
    "    }\n"
    "}\n",
    "Write a value within the range that the message names."};

const source::DiagnosticCode kAngleOutOfRange{
    "angle-out-of-range",
    source::Severity::kError,
    "the camera's opening angle is impossible",
    "`angle` is the full vertical opening angle in degrees. At 0 nothing is seen, and at 180 the "
    "picture plane is infinitely wide.",
    camera_example("angle 180\n"),
    "Write an angle above 0 and below 180 degrees; 30 to 60 look natural."};

const source::DiagnosticCode kRadiusNotPositive{"radius-not-positive",
                                                source::Severity::kError,
                                                "a sphere's radius is zero or negative",
                                                "Such a sphere has no surface to hit.",
                                                "Group {\n"
                                                "    MaterialIndex 0\n"
                                                "    Sphere {\n"
                                                "        center 0 0 0\n"
                                                "        radius 0\n"
                                                "    }\n"
                                                "}\n",
                                                "Write a radius above 0."};

/// Below this numbers lose digits in single precision, and then become 0.
constexpr double kSmallest = std::numeric_limits<float>::min();

/// True if 0 is forbidden, so that a number that nearly is 0 is a mistake as well. Elsewhere such
/// numbers are what rounding leaves of a 0, and as good as one.
bool excludes_zero(const grammar::Range& range) {
    return range.zero_excluded || (range.low_open && range.low == 0);
}

const source::DiagnosticCode& code_for(grammar::FieldId field) {
    if (field == grammar::FieldId::kPerspectiveCamera_angle) return kAngleOutOfRange;
    if (field == grammar::FieldId::kSphere_radius) return kRadiusNotPositive;
    return kValueOutOfRange;
}

bool inside(const grammar::Range& range, double number) {
    if (range.zero_excluded && number == 0) return false;
    if (range.low_open ? !(number > range.low) : !(number >= range.low)) return false;
    return range.high_open ? number < range.high : number <= range.high;
}

/// "must be above 0 and below 180, not 200"
std::string demand(const grammar::Range& range, std::string_view found) {
    if (range.zero_excluded) return "must not be 0";
    const bool low = range.low > -std::numeric_limits<double>::infinity();
    const bool high = range.high < std::numeric_limits<double>::infinity();
    if (low && high && !range.low_open && !range.high_open) {
        return fmt::format("must lie between {} and {}, not {}", range.low, range.high, found);
    }
    std::string text = "must be ";
    if (low) text += fmt::format("{} {}", range.low_open ? "above" : "at least", range.low);
    if (low && high) text += " and ";
    if (high) text += fmt::format("{} {}", range.high_open ? "below" : "at most", range.high);
    text += fmt::format(", not {}", found);
    return text;
}

/// 'radius' of Sphere, or Translate for its bare numbers.
std::string subject(const CheckContext& context, BlockNodeId id, const grammar::FieldRow& field) {
    if (field.name == "value") return fmt::format("a number of {}", context.name(id));
    return fmt::format("'{}' of {}", field.name, context.name(id));
}

void check_number(CheckContext& context, BlockNodeId id, const grammar::FieldRow& row,
                  const Value& value) {
    const double size = std::fabs(value.number);
    const source::Span place = context.span(value.token);
    if (!fits_single(value.number)) {
        auto& diagnostic = context.report(
            kValueOutOfRange, place, fmt::format("{} is too large", subject(context, id, row)));
        diagnostic.notes.emplace_back("the largest number is 3.4e38, in either direction");
        return;
    }
    const bool is_color = row.type == grammar::ValueType::kColor;
    if (!is_color && !inside(row.range, value.number)) {
        auto& diagnostic = context.report(
            code_for(row.id), place,
            subject(context, id, row) + " " + demand(row.range, context.shown(place)));
        if (!row.unit.empty()) diagnostic.notes.push_back(fmt::format("unit: {}", row.unit));
        return;
    }
    if (size < kSmallest && excludes_zero(row.range)) {
        auto& diagnostic = context.report(
            kValueOutOfRange, place, fmt::format("{} is too small", subject(context, id, row)));
        diagnostic.notes.emplace_back(
            "the smallest number that is not 0 in single precision, with all its digits, is "
            "1.2e-38");
    }
}

}  // namespace

void check_number_ranges(CheckContext& context, BlockNodeId id) {
    using grammar::ValueType;
    for (const FieldNode& field : context.ast().fields_of(id)) {
        if (field.broken) continue;
        const grammar::FieldRow& row = grammar::row(field.row);
        // Colours, counts and references have checks of their own.
        if (grammar::is_word(row.type) || row.type == ValueType::kCount ||
            row.type == ValueType::kMaterialRef) {
            continue;
        }
        for (const Value& value : context.ast().values_of(field)) {
            check_number(context, id, row, value);
        }
    }
}

}  // namespace cobble::frontend
