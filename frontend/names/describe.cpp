// SPDX-License-Identifier: MIT
#include "frontend/names/describe.hpp"

#include <fmt/format.h>

namespace cobble::frontend {
namespace {

/// The values after a field's name, as one would write them on a board.
std::string_view placeholder(grammar::ValueType type) {
    using enum grammar::ValueType;
    switch (type) {
        case kNumber:
            return "number";
        case kInteger:
        case kCount:
            return "integer";
        case kVector2:
            return "u v";
        case kVector3:
            return "x y z";
        case kColor:
            return "r g b";
        case kNumbers4:
            return "x y z degrees";
        case kNumbers16:
            return "16 numbers";
        case kImagePath:
            return "image";
        case kFolderPath:
            return "folder";
        case kMeshPath:
            return "file";
        case kMaterialRef:
            return "material";
        case kTextureFilter:
            return "nearest|bilinear";
    }
    return "";
}

}  // namespace

std::string_view expected_value(grammar::ValueType type) {
    using enum grammar::ValueType;
    switch (type) {
        case kNumber:
            return "a number";
        case kInteger:
        case kCount:
            return "an integer";
        case kVector2:
            return "two numbers";
        case kVector3:
            return "a 3D vector";
        case kColor:
            return "a colour: three numbers or #rrggbb";
        case kNumbers4:
            return "four numbers";
        case kNumbers16:
            return "sixteen numbers";
        case kImagePath:
            return "the path of an image";
        case kFolderPath:
            return "the path of a folder";
        case kMeshPath:
            return "the path of an .obj file";
        case kMaterialRef:
            return "the number or the label of a material";
        case kTextureFilter:
            return "nearest or bilinear";
    }
    return "";
}

std::string what_it_takes(grammar::BlockId block) {
    std::string needed;
    std::string optional;
    for (const grammar::FieldRow& field : grammar::fields_of(block)) {
        const bool is_optional = field.presence == grammar::Presence::kOptional;
        std::string& list = is_optional ? optional : needed;
        if (!list.empty()) list += ", ";
        if (field.name != "value") list += fmt::format("{} ", field.name);
        list += placeholder(field.type);
    }
    if (!optional.empty()) {
        needed += fmt::format("{}optionally {}", needed.empty() ? "" : ", ", optional);
    }
    std::string members;
    for (const grammar::BlockRow& row : grammar::blocks()) {
        if (!grammar::may_stand_in(row.id, block)) continue;
        members += members.empty() ? " and holds " : ", ";
        members += row.name;
    }
    return fmt::format("{} takes {}{}", grammar::row(block).name,
                       needed.empty() ? "no arguments" : needed, members);
}

std::string quoted_list(std::span<const std::string_view> names) {
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) list += i + 1 == names.size() ? " and " : ", ";
        list += fmt::format("'{}'", names[i]);
    }
    return list;
}

}  // namespace cobble::frontend
