// SPDX-License-Identifier: MIT
// From values to places along an axis, and the ticks that make an axis readable.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace cobble::driver::chart {

struct Tick {
    double unit = 0;    ///< along the axis, 0 its low end, 1 its high end
    std::string label;  ///< empty for the ticks between
};

/// A logarithmic axis over positive numbers. Ticks are labelled at decades, at 1, 2 and 5 where no
/// more than three of them are to be seen, and at every n-th decade where there are too many;
/// ticks between are at all digits from 1 to 9, or at all decades unless these are very many.
class LogScale {
  public:
    /// Holds all of `values` that are finite and above 0, with some room at both ends, and is at
    /// least a decade long; from 0.1 to 1 if there are none.
    explicit LogScale(std::span<const double> values);

    /// Where `value` lies, clamped to [0, 1]; what is not above 0 lies at 0.
    [[nodiscard]] double unit(double value) const;
    [[nodiscard]] std::vector<Tick> ticks() const;

  private:
    double low_ = -1, high_ = 0;  // common logarithms
};

/// A linear axis of shares, labelled in per cent.
class ShareScale {
  public:
    /// Holds 0 and all of `values` from -100 to 100 (10 000 %), with the upper end at a
    /// tick, and with little room below what is below 0.
    explicit ShareScale(std::span<const double> values);

    /// Where `value` lies, clamped to [0, 1]; 0's place if it is NaN.
    [[nodiscard]] double unit(double value) const;
    [[nodiscard]] std::vector<Tick> ticks() const;

  private:
    double low_ = 0, high_ = 1;
    double step_ = 0.2;
};

/// True for numbers that a logarithmic axis has a place for.
bool has_place(double value);

/// 10 to the power of a whole number, as people write it: "0.001", "100", else "10⁻⁶".
std::string power_text(int digit, int exponent);

}  // namespace cobble::driver::chart
