// SPDX-License-Identifier: MIT
// A drawing as SVG text (W3C, Scalable Vector Graphics 1.1): the few shapes that charts need.
//
// The text is the same everywhere: numbers have at most two decimals and no exponent, attributes
// come in one order. Letters stay letters, so that a chart can be searched and read aloud; which
// font they meet is not known, and their widths are bounded from above (text_width).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tools/driver/chart/box.hpp"
#include "tools/driver/chart/paint.hpp"

namespace cobble::driver::chart {

/// `text` with what XML has signs for escaped, and made safe to print (driver::printable): for
/// contents and for attributes in double quotes, of HTML too.
std::string escape_xml(std::string_view text);

/// A number as SVG and people read it: at most two decimals, none of them an idle zero, no "-0".
/// Not finite: "0".
std::string coordinate(double value);

/// No less than the width of `text` in the sans-serif fonts that are in use, DejaVu Sans, which is
/// the widest of them, included.
double text_width(std::string_view text, double size, bool bold = false);

/// `text`, or as much of its beginning as fits `width` with "…" behind it.
std::string fit(std::string_view text, double width, double size);

/// `text` broken at spaces into lines no wider than `width`; a word that is wider has a line of its
/// own.
std::vector<std::string> wrap(std::string_view text, double width, double size);

enum class Anchor : std::uint8_t { kStart, kMiddle, kEnd };
enum class Dash : std::uint8_t { kSolid, kDashed, kDotted };
enum class Mark : std::uint8_t { kNone, kDot, kDiamond, kHollowDiamond, kRing };

/// Marks reach no further than this from their point.
inline constexpr double kMarkRadius = 5;

struct TextStyle {
    double size = 12;
    Anchor anchor = Anchor::kStart;
    Paint paint = Paint::kInk;
    bool bold = false;
    bool upwards = false;  ///< turned a quarter to the left about its point
};

struct Stroke {
    Paint paint = Paint::kInk;
    double width = 1;
    Dash dash = Dash::kSolid;
};

/// What every drawing has for those who cannot see it.
struct Legend {
    std::string id;  ///< unique on a page; letters and hyphens
    std::string title;
    std::string description;
};

/// On paper of its own, so that it can be read on any background.
class Svg {
  public:
    Svg(double width, double height, const Legend& legend);

    void rect(const Box& box, Paint fill, double opacity = 1);
    void frame(const Box& box, const Stroke& stroke);
    void line(Point from, Point to, const Stroke& stroke);
    void polyline(std::span<const Point> points, const Stroke& stroke);
    void polygon(std::span<const Point> points, Paint fill, double opacity);
    /// `tip` is shown by viewers that are pointed at the mark; may be empty.
    void mark(Point at, Mark mark, Paint paint, std::string_view tip = {});
    /// `at` is on the base line.
    void text(Point at, std::string_view text, const TextStyle& style);

    /// The whole file, with a line end.
    [[nodiscard]] std::string finish() const { return text_ + "</svg>\n"; }

  private:
    std::string text_;
};

}  // namespace cobble::driver::chart
