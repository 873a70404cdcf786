// SPDX-License-Identifier: MIT
// The coordinate systems of a scene: one per Transform block, composed outside in.
// Input: a checked scene. Output: a flat array of frames, parents before children. Invariant: cost
// and memory grow with the number of frames, however deep they nest; nothing recurses.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "frontend/check/check.hpp"
#include "ir/lower/moves.hpp"
#include "ir/scene/scene.hpp"

namespace cobble::ir {

/// At most this many segments per motion: 43 full turns at 15 degrees each.
inline constexpr std::uint32_t kMaxSegments = 1024;
/// At most this angle per segment.
inline constexpr double kSegmentDegrees = 15;

struct Frame {
    std::uint32_t parent = 0;  ///< the root (the world) is its own parent
    MoveList local;
    bool moving = false;         ///< it or an ancestor moves
    bool vanishes = false;       ///< it or an ancestor is singular at some time
    bool coarse = false;         ///< needs more segments than it gets
    std::uint32_t segments = 1;  ///< K for objects of this frame: a power of two
    std::uint32_t stored = 1;    ///< steps in `maps`: twice what the finest descendant needs
    std::uint32_t first_map = 0;

    double turn_degrees = 0;  ///< summed along the ancestors
};

class Frames {
  public:
    explicit Frames(const frontend::CheckedScene& checked);

    /// The frame of a block's children (for a Transform: inside it); 0 is the world.
    [[nodiscard]] std::uint32_t inside(frontend::BlockNodeId block) const {
        return inside_[block.value];
    }
    [[nodiscard]] const Frame& frame(std::uint32_t id) const { return frames_[id]; }
    [[nodiscard]] std::size_t size() const { return frames_.size(); }

    /// Object to world at key `k` of `frame(id).segments`; for a frame at rest, k = 0.
    [[nodiscard]] const math::Affined& map(std::uint32_t id, std::uint32_t k) const {
        const Frame& f = frames_[id];
        return maps_[f.first_map + k * (f.stored / f.segments)];
    }
    /// Object to world halfway between keys `k` and `k + 1` of a moving frame.
    [[nodiscard]] const math::Affined& map_between(std::uint32_t id, std::uint32_t k) const {
        const Frame& f = frames_[id];
        return maps_[f.first_map + (2 * k + 1) * (f.stored / (2 * f.segments))];
    }

    /// How many keys an object of this frame has: 1 at rest, else segments + 1.
    [[nodiscard]] std::uint32_t keys(std::uint32_t id) const {
        return frames_[id].moving ? frames_[id].segments + 1 : 1;
    }

  private:
    void collect(const frontend::CheckedScene& checked);
    void choose_segments();
    void evaluate();

    std::vector<Frame> frames_;
    std::vector<std::uint32_t> inside_;
    std::vector<math::Affined> maps_;
};

}  // namespace cobble::ir
