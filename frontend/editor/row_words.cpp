// SPDX-License-Identifier: MIT
#include "frontend/editor/row_words.hpp"

#include <fmt/format.h>

#include <limits>

namespace cobble::frontend::editor {
namespace {

using grammar::BlockId;
using grammar::BlockRow;
using grammar::FieldId;
using grammar::FieldRow;
using grammar::ValueType;

bool is_finite(double x) {
    return x > -std::numeric_limits<double>::infinity() &&
           x < std::numeric_limits<double>::infinity();
}

std::string quoted_or_list(const std::vector<std::string_view>& names) {
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) list += i + 1 == names.size() ? " or " : ", ";
        list += fmt::format("`{}`", names[i]);
    }
    return list;
}

/// Fields for which the type's usual values would be wrong or of no use: a direction needs a
/// length, the corners of a triangle or box must not coincide.
std::string_view special_sample(FieldId field) {
    using enum FieldId;
    switch (field) {
        case kPerspectiveCamera_direction:
            return "0 0 -1";
        case kPerspectiveCamera_angle:
            return "40";
        case kDirectionalLight_direction:
            return "-1 -2 -1";
        case kPerspectiveCamera_up:
        case kPlane_normal:
            return "0 1 0";
        case kRotate_value:
            return "0 1 0 90";
        case kTriangle_vertex1:
            return "1 0 0";
        case kTriangle_vertex2:
            return "0 1 0";
        case kBox_max:
        case kScale_value:
            return "1 1 1";
        case kUniformScale_value:
            return "1";
        case kXRotate_value:
        case kYRotate_value:
        case kZRotate_value:
            return "90";
        default:
            return {};
    }
}

}  // namespace

std::string_view type_words(ValueType type) {
    using enum ValueType;
    switch (type) {
        case kNumber:
            return "number";
        case kInteger:
            return "integer";
        case kCount:
            return "number of members";
        case kVector2:
            return "2 numbers";
        case kVector3:
            return "3 numbers";
        case kColor:
            return "colour: 3 numbers or `#rrggbb`";
        case kNumbers4:
            return "4 numbers";
        case kNumbers16:
            return "16 numbers";
        case kImagePath:
            return "path of a picture";
        case kFolderPath:
            return "path of a folder";
        case kMeshPath:
            return "path of an `.obj` file";
        case kMaterialRef:
            return "number or label of a material";
        case kTextureFilter:
            return "`nearest` or `bilinear`";
    }
    return "";
}

std::string range_words(const grammar::Range& range) {
    const bool low = is_finite(range.low);
    const bool high = is_finite(range.high);
    std::string words;
    if (low && high) {
        words = fmt::format("from {} to {}", range.low, range.high);
        if (range.low_open && range.high_open) {
            words += ", both excluded";
        } else if (range.low_open || range.high_open) {
            words += fmt::format(", {} excluded", range.low_open ? range.low : range.high);
        }
    } else if (low) {
        words = fmt::format("{} {}", range.low_open ? "above" : "at least", range.low);
    } else if (high) {
        words = fmt::format("{} {}", range.high_open ? "below" : "at most", range.high);
    }
    if (range.zero_excluded) words += words.empty() ? "not 0" : ", not 0";
    if (is_finite(range.warn_above)) {
        words += fmt::format("{}a warning above {}", words.empty() ? "" : ", ", range.warn_above);
    }
    return words;
}

std::string value_words(const FieldRow& field) {
    std::string words(type_words(field.type));
    const auto add = [&words](std::string_view more) {
        if (!more.empty()) words.append(", ").append(more);
    };
    add(field.unit);
    add(range_words(field.range));
    if (!field.fallback.empty()) add(fmt::format("default `{}`", field.fallback));
    if (field.presence == grammar::Presence::kRequired) add("required");
    if (field.presence == grammar::Presence::kExpected) add("expected");
    if (field.repeat == grammar::Repeat::kTwice) add("given twice");
    return words;
}

std::string parents_words(BlockId block) {
    std::vector<std::string_view> names;
    for (const BlockRow& parent : grammar::blocks()) {
        if (grammar::may_stand_in(block, parent.id)) names.push_back(parent.name);
    }
    const bool top = grammar::may_stand_at_top(block);
    if (names.empty()) return top ? "Stands at the top level of the file." : "";
    return fmt::format("Stands {}in {}.", top ? "at the top level of the file or " : "",
                       quoted_or_list(names));
}

std::string members_words(BlockId block) {
    std::vector<std::string_view> names;
    for (const BlockRow& member : grammar::blocks()) {
        if (grammar::may_stand_in(member.id, block)) names.push_back(member.name);
    }
    return names.empty() ? "" : fmt::format("May hold {}.", quoted_or_list(names));
}

std::vector<std::string_view> components(const FieldRow& field) {
    using enum ValueType;
    switch (field.type) {
        case kVector2:
            return {"u", "v"};
        case kVector3:
            return {"x", "y", "z"};
        case kColor:
            return {"r", "g", "b"};
        case kNumbers4:
            return {"x", "y", "z", "degrees"};
        case kNumbers16:
            return {"c0r0", "c0r1", "c0r2", "c0r3", "c1r0", "c1r1", "c1r2", "c1r3",
                    "c2r0", "c2r1", "c2r2", "c2r3", "c3r0", "c3r1", "c3r2", "c3r3"};
        case kImagePath:
        case kFolderPath:
        case kMeshPath:
            return {"path"};
        case kMaterialRef:
            return {"material"};
        case kTextureFilter:
            return {"filter"};
        case kCount:
            return {"count"};
        case kInteger:
            return {"integer"};
        case kNumber:
            break;
    }
    return {"number"};
}

bool is_direction(FieldId field) {
    using enum FieldId;
    return field == kPerspectiveCamera_direction || field == kPerspectiveCamera_up ||
           field == kDirectionalLight_direction || field == kPlane_normal || field == kRotate_value;
}

std::string sample_value(const FieldRow& field) {
    if (const std::string_view special = special_sample(field.id); !special.empty()) {
        return std::string(special);
    }
    using enum ValueType;
    // A lamp whose default is black is of no use to anybody who writes it down.
    if (field.type == kColor) {
        return field.presence == grammar::Presence::kOptional && !field.fallback.empty()
                   ? std::string(field.fallback)
                   : "1 1 1";
    }
    if (!field.fallback.empty()) return std::string(field.fallback);
    switch (field.type) {
        case kVector2:
            return "1 1";
        case kVector3:
            return "0 0 0";
        case kNumbers4:
            return "0 0 0 0";
        case kNumbers16:
            return "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1";
        case kImagePath:
            return "picture.png";
        case kFolderPath:
            return "folder";
        case kMeshPath:
            return "mesh.obj";
        case kTextureFilter:
            return "bilinear";
        case kMaterialRef:
        case kCount:
            return "0";
        default:
            break;
    }
    // A number that the range allows, 1 if it can be.
    const grammar::Range& range = field.range;
    if (range.low >= 1) return fmt::format("{}", range.low + (range.low_open ? 1 : 0));
    if (range.high <= 1 && range.high_open) return fmt::format("{}", range.high / 2);
    return range.high < 1 ? fmt::format("{}", range.high) : "1";
}

}  // namespace cobble::frontend::editor
