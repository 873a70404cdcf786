// SPDX-License-Identifier: MIT
// Large scenes to measure with: valid, varied as people and exporters write, the same each time.
#pragma once

#include <cstddef>
#include <string>

namespace cobble::bench {

struct GeneratedScene {
    std::string scene;  ///< checks without an error or warning
    std::string json;   ///< the same content as compact JSON: the peer's input
};

/// A scene of about `bytes` bytes (within one group of objects, some 20 KB).
GeneratedScene generate_scene(std::size_t bytes);

}  // namespace cobble::bench
