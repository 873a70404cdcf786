// SPDX-License-Identifier: MIT
// The colours of a file, and how a new one is written.
//
// Input: a checked scene and its text. Output: the values of every colour that can be read, in
// order of the file. A colour with a comment between its components is left out, because whoever
// replaces the colour would delete the comment. Cost: one pass over the fields.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/check/check.hpp"

namespace cobble::frontend::editor {

struct ColorValue {
    ByteRange span;  ///< of its values, without the field's name
    double r, g, b;  ///< from 0 to 1; what lies outside, as a strong light's does, is cut off
    bool as_hex;     ///< written as #rrggbb
    bool cut_off;    ///< a component lay outside 0 to 1
};

std::vector<ColorValue> colors(const CheckedScene& scene, std::string_view text);

/// Both ways to write a colour: "0.5 0.5 0.5", then "#808080". Components are cut off to 0 to 1; a
/// number has the fewest digits that give it back, but at most 3 decimals unless they are exact
/// (0.0625), because pickers send 255ths.
std::array<std::string, 2> color_presentations(double r, double g, double b);

/// One component as color_presentations writes it.
std::string color_number(double component);

/// A component from 0 to 255, rounded; what lies outside is cut off.
int color_byte(double component);

/// "#rrggbb".
std::string color_hex(double r, double g, double b);

}  // namespace cobble::frontend::editor
