// SPDX-License-Identifier: MIT
// Sums of samples that a picture takes in several passes, kept apart by scramble: how far the
// scrambles lie from each other tells how far their mean may be from the truth.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "renderer/film/accumulator.hpp"
#include "renderer/film/picture.hpp"

namespace cobble::renderer {

/// Memory: 28 bytes a pixel for each scramble, and 12 to 60 for the pictures beside the colour, 24
/// for squares.
class ScrambleSums {
  public:
    struct Wanted {
        bool depth = false, normals = false, albedo = false;
        /// Squares too: for passes of one sample, each of which counts as clamped to [0, 1].
        bool squares = false;
    };

    ScrambleSums(std::size_t pixels, std::uint32_t scrambles, Wanted wanted);

    [[nodiscard]] std::uint32_t scrambles() const { return scrambles_; }
    [[nodiscard]] bool has_squares() const { return !squares_.empty(); }
    [[nodiscard]] std::size_t pixels() const { return samples_.size() / scrambles_; }

    /// What a pass of scramble `scramble` saw of a pixel. Different pixels from different threads
    /// at once; the passes of one pixel in one order, so that sums have one sequence of bits.
    void add(std::size_t pixel, std::uint32_t scramble, const Pixel& seen);
    void add_color(std::size_t pixel, std::uint32_t scramble, math::Vec3d mean,
                   std::uint32_t samples);

    /// The mean over the samples of one scramble; 0 0 0 if it has none.
    [[nodiscard]] math::Vec3d mean_of(std::size_t pixel, std::uint32_t scramble) const;
    /// The mean of their squares, channel by channel, over the samples of all scrambles.
    [[nodiscard]] math::Vec3d mean_square(std::size_t pixel) const;
    [[nodiscard]] std::uint32_t samples_of(std::size_t pixel, std::uint32_t scramble) const {
        return samples_[pixel * scrambles_ + scramble];
    }
    /// Over all scrambles; what was not asked for is as in no samples.
    [[nodiscard]] Pixel pixel(std::size_t pixel) const;

    /// All there is as bytes, for a file that a render goes on from; and back: false, and nothing
    /// changed, if they are of other sums.
    [[nodiscard]] std::vector<std::uint8_t> bytes() const;
    [[nodiscard]] bool restore(const std::vector<std::uint8_t>& bytes);

  private:
    template <typename Visit>
    static void each_part(Visit&& visit, auto& self);

    std::uint32_t scrambles_;
    // By pixel, then scramble.
    std::vector<math::Vec3d> color_;
    std::vector<std::uint32_t> samples_;
    // By pixel; empty if not asked for.
    std::vector<std::uint32_t> hits_;
    std::vector<double> depth_;
    std::vector<math::Vec3d> normal_, albedo_;
    std::vector<math::Vec3d> squares_;
};

}  // namespace cobble::renderer
