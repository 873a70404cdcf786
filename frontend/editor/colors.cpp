// SPDX-License-Identifier: MIT
#include "frontend/editor/colors.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace cobble::frontend::editor {
namespace {

/// From 0 to 1; what is no number is 0.
double cut(double component) { return component > 0 ? std::min(component, 1.0) : 0.0; }

bool holds_comment(const Tokens& tokens, ByteRange range) {
    const auto found =
        std::ranges::lower_bound(tokens.comments, range.begin, {}, &ByteRange::begin);
    return found != tokens.comments.end() && found->begin < range.end;
}

}  // namespace

std::vector<ColorValue> colors(const CheckedScene& scene, std::string_view) {
    std::vector<ColorValue> result;
    for (const FieldNode& field : scene.ast.fields) {
        if (field.broken || grammar::row(field.row).type != grammar::ValueType::kColor) continue;
        const auto values = scene.ast.values_of(field);
        if (values.size() != 3) continue;
        const ByteRange span{scene.tokens.range(values.front().token).begin,
                             scene.tokens.range(values.back().token).end};
        if (holds_comment(scene.tokens, span)) continue;
        ColorValue color;
        color.span = span;
        color.r = cut(values[0].number);
        color.g = cut(values[1].number);
        color.b = cut(values[2].number);
        color.as_hex = scene.tokens.kind(values[0].token) == TokenKind::kColor;
        color.cut_off = color.r != values[0].number || color.g != values[1].number ||
                        color.b != values[2].number;
        result.push_back(color);
    }
    // Fields are stored where their block ends.
    std::ranges::sort(result, {}, [](const ColorValue& color) { return color.span.begin; });
    return result;
}

int color_byte(double component) { return static_cast<int>(cut(component) * 255 + 0.5); }

std::string color_number(double component) {
    component = cut(component);
    std::string shortest = fmt::format("{}", component);
    const bool exponent = shortest.find('e') != std::string::npos;
    const std::size_t point = shortest.find('.');
    const std::size_t decimals = point == std::string::npos ? 0 : shortest.size() - point - 1;
    // A sum of sixteenths, thirty-secondths and so on is exact in as many decimals as its
    // denominator has doublings; beyond 64ths nobody writes one on purpose.
    const double scaled = component * 64;
    const bool exact = scaled == static_cast<double>(static_cast<int>(scaled));
    if (!exponent && (decimals <= 3 || exact)) return shortest;
    std::string rounded = fmt::format("{:.3f}", component);
    rounded.erase(rounded.find_last_not_of('0') + 1);
    if (rounded.ends_with('.')) rounded.pop_back();
    return rounded;
}

std::string color_hex(double r, double g, double b) {
    return fmt::format("#{:02x}{:02x}{:02x}", color_byte(r), color_byte(g), color_byte(b));
}

std::array<std::string, 2> color_presentations(double r, double g, double b) {
    return {fmt::format("{} {} {}", color_number(r), color_number(g), color_number(b)),
            color_hex(r, g, b)};
}

}  // namespace cobble::frontend::editor
