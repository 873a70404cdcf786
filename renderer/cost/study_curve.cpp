// SPDX-License-Identifier: MIT
#include <cmath>
#include <utility>

#include "renderer/cost/curve.hpp"
#include "renderer/cost/parts.hpp"
#include "renderer/passes/adaptive_rounds.hpp"

namespace cobble::renderer {
namespace {

/// A scramble: beyond it nobody wants to know.
constexpr std::uint32_t kMostSamples = 1U << 14U;

}  // namespace

std::optional<CurveStudy> study_curve(const Studio& studio, double until) {
    CurveStudy result;
    std::vector<Scatters> points;
    // The first picture of a program takes longer than those after it.
    if (!studio.run(studio.settings(1))) return std::nullopt;
    for (std::uint32_t samples = 1; samples <= kMostSamples; samples *= 2) {
        Settings settings = studio.settings(samples * kScrambles);
        settings.scrambles = kScrambles;
        const double before = studio.seconds();
        std::optional<Run> run = studio.run(settings);
        if (!run) return std::nullopt;
        const double of_picture = run->render_seconds / kScrambles;
        points.push_back(scatter_of(*run->sums, samples, run->prepare_seconds + of_picture,
                                    studio.options().light));
        result.best = std::move(run->picture);
        result.best_rms = std::sqrt(points.back().mean_square / kScrambles);
        result.prepare_seconds = run->prepare_seconds;
        result.sample_seconds = of_picture / samples;
        // The next point takes twice as long.
        const double took = studio.seconds() - before;
        const bool enough = points.size() >= 3;
        if (enough && studio.seconds() + 2 * took > until * studio.options().seconds) break;
        if (!(points.back().mean_square > 0) && enough) break;
    }
    result.curve = make_curve(points);
    return result;
}

}  // namespace cobble::renderer
