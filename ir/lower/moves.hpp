// SPDX-License-Identifier: MIT
// The transforms inside one Transform block as numbers, and the map that they make at a time.
#pragma once

#include <array>
#include <vector>

#include "frontend/check/check.hpp"
#include "ir/math/affine.hpp"

namespace cobble::ir {

/// One keyword with its arguments at shutter times 0 and 1.
struct Move {
    grammar::BlockId kind{};
    std::array<double, 16> start{};
    std::array<double, 16> end{};  ///< equal to start for what is at rest
};

/// Of one Transform block, in order.
struct MoveList {
    std::vector<Move> moves;
    bool moving = false;    ///< some argument changes
    bool vanishes = false;  ///< a scale or a rotation axis passes through zero between the times
    /// How much the map bends over the shutter time, as degrees of rotation: turned angles, and
    /// scale factors f as |ln f| radians, which interpolated inverses follow equally well.
    double turn_degrees = 0;
};

/// Reads the children of a Transform block. Broken ones are passed over; a `Motion` that does not
/// match is ignored (both were reported).
MoveList read_moves(const frontend::CheckedScene& checked, frontend::BlockNodeId transform);

/// The map at `time` in [0, 1]: arguments are interpolated as a + time (b - a); each next map is
/// multiplied from the right, a Matrix4f from the left. The bottom row of a Matrix4f is ignored, as
/// in the published programs, which divide by no weight.
math::Affined compose(const MoveList& list, double time);

}  // namespace cobble::ir
