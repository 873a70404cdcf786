// SPDX-License-Identifier: MIT
// What both kinds of chart have around their plots: a title and a key above, captions below.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tools/driver/chart/svg.hpp"

namespace cobble::driver::chart {

inline constexpr double kChartWidth = 760;
inline constexpr double kMargin = 20;
inline constexpr double kTextSize = 12;
inline constexpr double kTitleSize = 16;
inline constexpr double kLineHeight = 18;

// Below a plot: base lines of numbers and of the axis' title, then room for both; and at the end.
inline constexpr double kTickBase = kLineHeight - 2;
inline constexpr double kAxisTitleBase = 2 * kLineHeight + 2;
inline constexpr double kAxisHeight = 2 * kLineHeight + 14;
inline constexpr double kBottom = 8;

/// How much of their paint shades have.
inline constexpr double kBandOpacity = 0.22;

/// One thing that the key explains.
struct KeyEntry {
    enum class Sample : std::uint8_t { kLine, kShade, kBar };
    std::string name;
    Sample sample = Sample::kLine;
    Stroke stroke;  ///< of a line; its paint is that of the others
    bool line = true;
    Mark mark = Mark::kNone;  ///< on the line
};

/// The title, and the key from the left in as many rows as it takes.
class Heading {
  public:
    Heading(std::string title, std::vector<KeyEntry> entries);

    /// Where what comes below may begin.
    [[nodiscard]] double bottom() const { return bottom_; }
    void draw(Svg& svg) const;

  private:
    std::string title_;
    std::vector<KeyEntry> entries_;
    std::vector<Point> places_;
    double bottom_ = 0;
};

/// Captions in soft ink, broken into lines.
class Captions {
  public:
    explicit Captions(std::span<const std::string> captions);

    [[nodiscard]] double height() const { return kLineHeight * static_cast<double>(lines_.size()); }
    /// `top` is where they begin.
    void draw(Svg& svg, double top) const;

  private:
    std::vector<std::string> lines_;
};

}  // namespace cobble::driver::chart
