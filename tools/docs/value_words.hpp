// SPDX-License-Identifier: MIT
// What the pages call the values of a type.
#pragma once

#include <string>
#include <string_view>

#include "grammar/vocabulary.hpp"

namespace cobble::docs {

struct ValueWords {
    std::string rule;        ///< in the grammar of blocks
    std::string_view words;  ///< in the reference of the language
};

ValueWords value_words(grammar::ValueType type);

}  // namespace cobble::docs
