// SPDX-License-Identifier: MIT
// The options of `render` that say how exact a picture is to be, or how long it may take.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "renderer/settings.hpp"

namespace CLI {
class App;
}

namespace cobble {

struct AccuracyOptions {
    std::uint32_t scrambles = 1;
    std::uint32_t most_samples = 1U << 16U;
    double error = 0;   ///< 0: none to reach
    double budget = 0;  ///< seconds; 0: none
    bool unbiased = false;
    bool guarantee = false;
    bool samples_given = false, scrambles_given = false, most_given = false;
};

void add_accuracy_options(CLI::App& sub, AccuracyOptions& options);

/// What of them does not go together; "" if all does. `compat`: a published program's way is
/// followed, which takes as many samples as its flags say.
std::string check_accuracy(const AccuracyOptions& options, bool compat);

/// Memory that the sums of several scrambles take for each pixel.
std::uint64_t bytes_of_pixel(const AccuracyOptions& options);

/// `shown_as_srgb`: the picture is light, and encoded where it is shown.
void set_accuracy(const AccuracyOptions& options, bool shown_as_srgb, renderer::Settings& settings);

}  // namespace cobble
