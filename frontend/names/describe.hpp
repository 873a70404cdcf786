// SPDX-License-Identifier: MIT
// Blocks and values in words, for messages.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "grammar/vocabulary.hpp"

namespace cobble::frontend {

/// What is due for a value: "a number", "a 3D vector", "a colour: three numbers or #rrggbb".
std::string_view expected_value(grammar::ValueType type);

/// "DirectionalLight takes direction x y z, color r g b, optionally angle a": every argument of a
/// block in the order of its documentation, the optional ones after the others,
/// and the blocks that may stand in it.
std::string what_it_takes(grammar::BlockId block);

/// "'a'", "'a' and 'b'", "'a', 'b' and 'c'".
std::string quoted_list(std::span<const std::string_view> names);

}  // namespace cobble::frontend
