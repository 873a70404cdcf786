// SPDX-License-Identifier: MIT
#include "ir/lower/frames.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace cobble::ir {

Frames::Frames(const frontend::CheckedScene& checked) {
    collect(checked);
    choose_segments();
    evaluate();
}

void Frames::collect(const frontend::CheckedScene& checked) {
    const auto& blocks = checked.ast.blocks;
    frames_.emplace_back();
    inside_.assign(blocks.size(), 0);
    // Blocks are in preorder, so that a parent's frame is known before its children's.
    for (std::uint32_t i = 0; i < blocks.size(); ++i) {
        const auto& block = blocks[i];
        const std::uint32_t outer = block.parent.valid() ? inside_[block.parent.value] : 0;
        inside_[i] = outer;
        if (block.row != grammar::BlockId::kTransform) continue;
        Frame frame;
        frame.parent = outer;
        frame.local = read_moves(checked, {i});
        frame.moving = frames_[outer].moving || frame.local.moving;
        frame.vanishes = frames_[outer].vanishes || frame.local.vanishes;
        frame.turn_degrees = frames_[outer].turn_degrees + frame.local.turn_degrees;
        inside_[i] = static_cast<std::uint32_t>(frames_.size());
        frames_.push_back(std::move(frame));
    }
}

void Frames::choose_segments() {
    // All maps together take at most 2^22 * 96 bytes: a million nested motions get few segments
    // each rather than all memory.
    constexpr std::size_t kMaxMaps = std::size_t{1} << 22;
    const auto moving = static_cast<std::size_t>(std::count_if(
        frames_.begin(), frames_.end(), [](const Frame& frame) { return frame.moving; }));
    std::uint32_t limit = kMaxSegments;
    while (limit > 1 && moving * (2 * limit + 1) > kMaxMaps) limit /= 2;
    for (Frame& frame : frames_) {
        if (!frame.moving) continue;
        const double wanted = std::ceil(frame.turn_degrees / kSegmentDegrees);
        frame.coarse = !(wanted <= limit);
        frame.segments =
            frame.coarse ? limit : std::bit_ceil(std::max(1U, static_cast<std::uint32_t>(wanted)));
        frame.stored = 2 * frame.segments;  // the points between keys tell the chord error
    }
    for (std::size_t i = frames_.size(); i-- > 1;) {
        const Frame& frame = frames_[i];
        Frame& parent = frames_[frame.parent];
        if (parent.moving) parent.stored = std::max(parent.stored, frame.stored);
    }
}

void Frames::evaluate() {
    for (Frame& frame : frames_) {
        const Frame& parent = frames_[frame.parent];
        frame.first_map = static_cast<std::uint32_t>(maps_.size());
        const std::uint32_t count = frame.moving ? frame.stored + 1 : 1;
        const math::Affined fixed = compose(frame.local, 0);
        for (std::uint32_t k = 0; k < count; ++k) {
            const math::Affined local =
                frame.local.moving ? compose(frame.local, static_cast<double>(k) / frame.stored)
                                   : fixed;
            if (&frame == &parent) {
                maps_.push_back(local);
                continue;
            }
            // The parent stores at least as many keys, and both counts are powers of two.
            const std::uint32_t step = parent.moving ? parent.stored / frame.stored : 0;
            maps_.push_back(maps_[parent.first_map + k * step] * local);
        }
    }
}

}  // namespace cobble::ir
