// SPDX-License-Identifier: MIT
// Values of a field as sentences, for hovering over them.
//
// Input: a checked scene and an unbroken field of it. Output: plain Markdown. Cost: constant.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/check/check.hpp"

namespace cobble::frontend::editor {

/// A number as people read it: at most six digits.
std::string short_number(double number);

/// What the values of a field mean; for a block that is its own field, what the block does.
std::string_view value_doc(const grammar::FieldRow& field);

/// "30 degrees, full vertical opening angle": the one value of a field with its unit, and what it
/// is; of several values only "1 world unit". Empty for a component that is not there.
std::string number_reading(const CheckedScene& scene, const FieldNode& field,
                           std::uint32_t component);

/// What the values say together: a colour in three notations, a direction's length and unit
/// vector. Empty for others.
std::vector<std::string> field_readings(const CheckedScene& scene, const FieldNode& field);

/// What a light gives to the picture: "Sends up to `1 0.9 0.7` ...". Empty if its colour cannot be
/// read, or the block is no light.
std::string light_sentence(const CheckedScene& scene, BlockNodeId light);

}  // namespace cobble::frontend::editor
