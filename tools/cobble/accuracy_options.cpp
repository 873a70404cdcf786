// SPDX-License-Identifier: MIT
#include "tools/cobble/accuracy_options.hpp"

#include <CLI/CLI.hpp>

#include "renderer/passes/adaptive_rounds.hpp"
#include "tools/cobble/arguments.hpp"

namespace cobble {
namespace {

// A million samples a pixel, as `--samples` has it.
constexpr std::uint32_t kMostSamples = 1U << 20U;
// More scrambles than samples are of no use, and fewer tell less of the error.
constexpr std::uint32_t kMostScrambles = 64;

}  // namespace

void add_accuracy_options(CLI::App& sub, AccuracyOptions& options) {
    const std::string group = "Accuracy";
    require_above(sub.add_option("--error", options.error,
                                 "Take samples until each pixel's 95 % interval is at most this "
                                 "far to either side (1 is black to white)"),
                  0)
        ->type_name("E")
        ->group(group);
    sub.add_flag("--unbiased", options.unbiased,
                 "With --error: other samples, thrown away, decide how many a pixel takes")
        ->group(group);
    sub.add_flag("--guarantee", options.guarantee,
                 "With --error: a bound for any distribution; needs thousands of samples, and "
                 "clamps each to [0, 1]")
        ->group(group);
    require_whole(sub.add_option("--max-samples", options.most_samples,
                                 "With --error: samples a pixel at most"),
                  renderer::kFewestSamples, kMostSamples)
        ->type_name("N")
        ->capture_default_str()
        ->group(group);
    require_above(sub.add_option("--budget", options.budget,
                                 "As many samples as this time allows, told by a trial; prints the "
                                 "settings that make the same picture again"),
                  0)
        ->type_name("SECONDS")
        ->group(group);
    require_whole(sub.add_option("--scrambles", options.scrambles,
                                 "Share the samples out among N independent sets, and say how "
                                 "large the error is"),
                  1, kMostScrambles)
        ->type_name("N")
        ->capture_default_str()
        ->group(group);
}

std::string check_accuracy(const AccuracyOptions& options, bool compat) {
    const bool error = options.error > 0;
    const bool budget = options.budget > 0;
    if (compat && (error || budget || options.scrambles_given)) {
        return "'--error', '--budget' and '--scrambles' do not go with '--compat': a published "
               "program takes as many samples as its flags say";
    }
    if (error && budget) return "'--error' and '--budget' exclude each other";
    if (error && options.samples_given) {
        return "'--error' chooses the number of samples: '--max-samples' limits it, '--samples' "
               "does not";
    }
    if (budget && options.samples_given) {
        return "'--budget' chooses the number of samples: leave '--samples' out";
    }
    if (budget && options.scrambles_given && options.scrambles < 2) {
        return "'--budget' tells the error by scrambles: '--scrambles' wants 2 or more with it, or "
               "leave it out";
    }
    if (error && options.scrambles_given) {
        return "'--error' has its own number of scrambles: leave '--scrambles' out";
    }
    if (options.unbiased && options.guarantee) {
        return "'--unbiased' and '--guarantee' exclude each other: a guaranteed picture's samples "
               "are independent anyway";
    }
    if (!error && (options.unbiased || options.guarantee || options.most_given)) {
        return "'--unbiased', '--guarantee' and '--max-samples' go with '--error'";
    }
    return {};
}

std::uint64_t bytes_of_pixel(const AccuracyOptions& options) {
    // As ScrambleSums has them; a look at the error takes as much as a scramble again.
    constexpr std::uint64_t kOfScramble = 28;
    if (options.guarantee) return 2 * kOfScramble;
    if (options.error > 0) return (renderer::kScrambles + 1) * kOfScramble;
    if (options.budget > 0 && !options.scrambles_given) return renderer::kScrambles * kOfScramble;
    return options.scrambles > 1 ? options.scrambles * kOfScramble : 0;
}

void set_accuracy(const AccuracyOptions& options, bool shown_as_srgb,
                  renderer::Settings& settings) {
    settings.scrambles = options.scrambles;
    settings.shown_as_srgb = shown_as_srgb;
    if (options.budget > 0 && !options.scrambles_given) {
        settings.scrambles = renderer::kScrambles;
    }
    if (options.error <= 0) return;
    renderer::ErrorGoal goal;
    goal.error = options.error;
    goal.most_samples = options.most_samples;
    using Method = renderer::ErrorGoal::Method;
    goal.method = options.unbiased    ? Method::kUnbiased
                  : options.guarantee ? Method::kGuarantee
                                      : Method::kAdaptive;
    settings.goal = goal;
}

}  // namespace cobble
