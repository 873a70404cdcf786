// SPDX-License-Identifier: MIT
// Whether two programs' pictures show the same.
#pragma once

#include <optional>
#include <string>

namespace cobble::bench {

/// Mean absolute difference of all channels, 0 to 1, after squares of `enlargement` x `enlargement`
/// pixels of each picture have become one. Nothing if either cannot be read, or their sizes differ.
std::optional<double> picture_difference(const std::string& path, unsigned enlargement,
                                         const std::string& other_path, unsigned other_enlargement);

}  // namespace cobble::bench
