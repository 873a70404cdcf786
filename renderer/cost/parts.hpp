// SPDX-License-Identifier: MIT
// The parts of a study, one after the other. Each takes what time it may (`until`, a part of all
// the time there is) and gives what it got done; nothing means interrupted.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/cost/report.hpp"
#include "renderer/cost/studio.hpp"

namespace cobble::renderer {

/// The curve, and the best picture that came of it: the mean over its scrambles.
struct CurveStudy {
    ErrorCurve curve;
    Picture best;
    double best_rms = 0;  ///< estimated error of the best picture
    double prepare_seconds = 0;
    double sample_seconds = 0;  ///< of rendering, for one sample of each pixel
};
std::optional<CurveStudy> study_curve(const Studio& studio, double until);

/// One picture of `samples` a pixel.
std::optional<StageBill> study_stages(const Studio& studio, std::uint32_t samples);

/// Pictures of `samples` a pixel with and without each effect that is on, side by side at least
/// three times over: machines are not equally quick all the time.
struct EffectsStudy {
    std::vector<EffectBill> bills;
    std::uint32_t runs = 0;
};
std::optional<EffectsStudy> study_effects(const Studio& studio, std::uint32_t samples,
                                          double until);

/// Of the picture of `samples` a pixel.
std::optional<NoiseBill> study_noise(const Studio& studio, std::uint32_t samples,
                                     std::uint32_t pairs);

std::optional<PrecisionBill> study_precision(const Studio& studio, std::uint32_t samples);

std::optional<std::vector<Bias>> study_biases(const Studio& studio, std::uint32_t samples);

/// Choices of samples, light samples, bounces and precision, each run, and which of them are on the
/// front of time and error; those are run again, as many as there is time for, and what they were
/// seen to take and to come to is then the mean of both.
std::optional<std::vector<Rung>> study_rungs(const Studio& studio, const CurveStudy& curve,
                                             double until);

/// Sentences: what to do.
std::string recommend(const CostReport& report);

/// How far two pictures are from each other.
struct Distance {
    double rmse = 0, flip = 0, maximum = 0;
};
Distance distance(const Studio& studio, const Plane32& a, const Plane32& b);

}  // namespace cobble::renderer
