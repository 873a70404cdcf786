// SPDX-License-Identifier: MIT
// What an adaptive picture will take, told by its first samples.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/estimate/achieved.hpp"
#include "renderer/settings.hpp"

namespace cobble::renderer {

/// First how many samples, by the half widths at the end of rounds 0 and 1; then how long they
/// take, by a pass over the pixels that need more: such pixels may cost several times as much as
/// others.
class AdaptiveForecast {
  public:
    /// At round 1's end. `before` and `now`: half widths by pixel, as look 1 has them; below 0
    /// where there is none. Errors are taken to fall on as they fell, by a power of the samples
    /// from 1/2 to 3/2.
    void set_widths(const std::vector<float>& before, const std::vector<float>& now,
                    const ErrorGoal& goal);
    /// Over all pixels. 0 until set_widths().
    [[nodiscard]] double samples() const { return samples_; }

    /// `seconds` are for `taken` samples; the last `pass_samples` of them took `pass_seconds`.
    void set_costs(double seconds, double taken, double pass_seconds, double pass_samples);
    /// `seconds` are for all samples, which are taken.
    void set_costs(double seconds) { seconds_ = seconds; }

    /// Nothing until both are known.
    [[nodiscard]] std::optional<Forecast> forecast() const;

  private:
    double pixels_ = 0, samples_ = 0;
    double seconds_ = -1;  ///< below 0: not known
};

}  // namespace cobble::renderer
