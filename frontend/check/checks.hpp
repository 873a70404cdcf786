// SPDX-License-Identifier: MIT
// The functions of checks.def.
#pragma once

#include "frontend/check/context.hpp"

namespace cobble::frontend {

#define COBBLE_BLOCK_CHECK(function, blocks) void function(CheckContext& context, BlockNodeId id);
#define COBBLE_SCENE_CHECK(function) void function(CheckContext& context);
#include "frontend/check/checks.def"

}  // namespace cobble::frontend
