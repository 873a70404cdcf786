// SPDX-License-Identifier: MIT
// Characters that cannot be seen, or look like a blank, but are none to the language.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace cobble::frontend {

struct Invisible {
    std::size_t at;         ///< its first byte
    std::size_t bytes;      ///< how many it takes
    std::string_view name;  ///< "U+00A0, a no-break space"
    bool blank;             ///< looks like a blank; otherwise it has no width
};

/// The first such character of `text` at or after `from`. Cost: one pass up to it.
std::optional<Invisible> find_invisible(std::string_view text, std::size_t from = 0);

/// `word` without them, up to the first that looks like a blank and stands behind something: the
/// name that was meant.
std::string visible_name(std::string_view word);

}  // namespace cobble::frontend
