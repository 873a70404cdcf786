// SPDX-License-Identifier: MIT
// The identity of a scene.
#pragma once

#include <string>

#include "ir/scene/scene.hpp"

namespace cobble::ir {

/// SHA-256, as 64 hex digits, over a canonical little-endian encoding of values and of the contents
/// of assets (-0 as 0), without spans, labels, paths and unused materials: two files that mean the
/// same picture have one hash.
std::string hash(const Scene& scene);

}  // namespace cobble::ir
