// SPDX-License-Identifier: MIT
#include "frontend/editor/readings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "frontend/ast/views.hpp"
#include "frontend/check/vectors.hpp"
#include "frontend/editor/colors.hpp"
#include "frontend/editor/row_words.hpp"

namespace cobble::frontend::editor {
namespace {

using grammar::FieldRow;
using grammar::ValueType;

/// A row's first clause, to go on in a sentence: "full vertical opening angle".
std::string first_clause(std::string_view doc) {
    std::string clause(doc.substr(0, doc.find_first_of(".;:")));
    // A name of the language keeps its letters.
    if (clause.size() > 1 && clause[0] >= 'A' && clause[0] <= 'Z' &&
        !(clause[1] >= 'A' && clause[1] <= 'Z')) {
        clause[0] = static_cast<char>(clause[0] - 'A' + 'a');
    }
    return clause;
}

/// "30 degrees", "1 world unit", "0.1 per square world unit".
std::string with_unit(double number, std::string_view unit) {
    std::string shown = short_number(number);
    constexpr std::string_view kPer = "1 / ";
    if (unit.starts_with(kPer)) {
        unit.remove_prefix(kPer.size());
        if (unit.ends_with('s')) unit.remove_suffix(1);
        return fmt::format("{} per {}", shown, unit);
    }
    if (unit.empty()) return shown;
    if ((number == 1 || number == -1) && unit.ends_with('s')) unit.remove_suffix(1);
    return fmt::format("{} {}", shown, unit);
}

std::string three(const Numbers3& v) {
    return fmt::format("{} {} {}", short_number(v[0]), short_number(v[1]), short_number(v[2]));
}

std::optional<Numbers3> first_three(const CheckedScene& scene, const FieldNode& field) {
    const auto values = scene.ast.values_of(field);
    if (field.broken || values.size() < 3) return std::nullopt;
    return Numbers3{values[0].number, values[1].number, values[2].number};
}

/// Its length and direction, as exact as doubles are: scaled first, so that no square overflows.
std::string direction_reading(const Numbers3& v) {
    const double largest = std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
    if (largest == 0) return "It has no length, and points nowhere.";
    const Numbers3 scaled = {v[0] / largest, v[1] / largest, v[2] / largest};
    const double size = length(scaled);
    const Numbers3 unit = {scaled[0] / size, scaled[1] / size, scaled[2] / size};
    return fmt::format("length {}, unit vector `{}`", short_number(size * largest), three(unit));
}

std::string color_reading(const Numbers3& c) {
    std::string text =
        fmt::format("`{}` (0 to 1), `{} {} {}` (0 to 255), `{}`", three(c), color_byte(c[0]),
                    color_byte(c[1]), color_byte(c[2]), color_hex(c[0], c[1], c[2]));
    if (c[0] > 1 || c[1] > 1 || c[2] > 1) text += " (cut off at 1)";
    return text;
}

}  // namespace

std::string_view value_doc(const grammar::FieldRow& field) {
    const grammar::BlockRow& block = grammar::row(field.block);
    const bool named =
        block.layout == grammar::Layout::kFields || block.layout == grammar::Layout::kList;
    return named ? field.doc : block.doc;
}

std::string short_number(double number) {
    // Adding 0 turns -0 into 0, which is what is meant.
    return fmt::format("{:.6g}", number + 0.0);
}

std::string number_reading(const CheckedScene& scene, const FieldNode& field,
                           std::uint32_t component) {
    const FieldRow& row = grammar::row(field.row);
    const auto values = scene.ast.values_of(field);
    if (component >= values.size()) return {};
    // The unit of an axis and an angle is that of the angle.
    std::string_view unit = row.unit;
    if (row.type == ValueType::kNumbers4) unit = component == 3 ? "degrees" : "";
    std::string text = with_unit(values[component].number, unit);
    // Of one component the name says what it is; the field's meaning is that of all of them.
    if (values.size() > 1) return text;
    return fmt::format("{}, {}", text, first_clause(value_doc(row)));
}

std::vector<std::string> field_readings(const CheckedScene& scene, const FieldNode& field) {
    std::vector<std::string> readings;
    const auto v = first_three(scene, field);
    if (!v) return readings;
    if (grammar::row(field.row).type == ValueType::kColor) readings.push_back(color_reading(*v));
    if (is_direction(field.row)) readings.push_back(direction_reading(*v));
    return readings;
}

std::string light_sentence(const CheckedScene& scene, BlockNodeId light) {
    const BlockView view(scene.tokens, scene.ast, light);
    if (scene.ast.block(light).row == grammar::BlockId::kDirectionalLight) {
        const auto color = field::DirectionalLight_color(view);
        if (!color) return {};
        const double angle = field::DirectionalLight_angle(view).value_or(0);
        return fmt::format(
            "Sends up to `{}` times a surface's colour to what faces it, at any distance; its "
            "shadows have {} edges.",
            three(*color), angle > 0 ? "soft" : "sharp");
    }
    if (scene.ast.block(light).row != grammar::BlockId::kPointLight) return {};
    const auto color = field::PointLight_color(view);
    if (!color) return "It has no colour, and so gives no light.";
    const double falloff = field::PointLight_falloff(view).value_or(0);
    const double radius = field::PointLight_radius(view).value_or(0);
    // color / (1 + falloff d^2) is half of color where falloff d^2 = 1.
    const std::string fades = falloff > 0 ? fmt::format("half of it {} world units away",
                                                        short_number(1 / std::sqrt(falloff)))
                                          : std::string("at any distance");
    return fmt::format(
        "Sends up to `{}` times a surface's colour to what faces it, {}; its shadows have {} "
        "edges.",
        three(*color), fades, radius > 0 ? "soft" : "sharp");
}

}  // namespace cobble::frontend::editor
