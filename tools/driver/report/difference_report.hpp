// SPDX-License-Identifier: MIT
// How far two pictures are from each other, for people and as JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "renderer/metrics/compare.hpp"

namespace cobble::driver {

struct DifferenceReport {
    const renderer::Comparison& comparison;
    std::string_view a, b;  ///< paths
    std::uint32_t width = 0, height = 0;
    std::optional<double> tolerance;  ///< that the comparison was made with

    /// Whether no value differs by more than the tolerance. A pixel that is no number is no match.
    [[nodiscard]] bool within_tolerance() const {
        return comparison.beyond_tolerance == 0 && comparison.not_finite == 0;
    }
};

/// One line a figure.
std::string difference_to_text(const DifferenceReport& report);

/// {"cobble_diff": 1, "a", "b", "width", "height", "mse", "rel_mse", "mae", "maximum",
/// "percentile_99", "flip": {"mean", "maximum", "pixels_per_degree"}, "pixels": {"all",
/// "differing", "not_finite", "beyond_tolerance"}, "clamped_values", "tolerance",
/// "within_tolerance"}: the last two, and beyond_tolerance, are null without a tolerance.
std::string difference_to_json(const DifferenceReport& report);

}  // namespace cobble::driver
