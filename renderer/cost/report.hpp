// SPDX-License-Identifier: MIT
// What accuracy costs in time: everything that a study of one scene on one machine found, as plain
// records. Who measures fills it in, who shows it reads it; nothing is computed here.
//
// Errors are in display units (0 black, 1 white) over all pixels and channels. RMSE is the root of
// the mean square; FLIP (renderer/metrics/flip.hpp) is the mean over pixels. Seconds are of the
// wall clock, for a whole picture with its preparation. Intervals hold the true value with a
// confidence of 95 %.
//
// A study may stop early, or a part may not apply to the scene: what was not measured is empty, or
// NaN where it is a number alone. Readers must expect both, and must not take a zero for nothing.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "ir/scene/effects.hpp"
#include "renderer/film/picture.hpp"
#include "renderer/settings.hpp"
#include "renderer/tile/stage_clock.hpp"

namespace cobble::renderer {

inline constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

/// A 95 % interval, low <= high.
struct Interval {
    double low = kNotMeasured;
    double high = kNotMeasured;
};

/// A picture of `samples` a pixel.
struct CurvePoint {
    std::uint32_t samples = 0;
    double seconds = kNotMeasured;
    double error = kNotMeasured;  ///< RMSE from the picture of endlessly many samples
    Interval band;                ///< of the error
};

/// How the error falls as the number of samples is doubled; bias is not part of it.
struct ErrorCurve {
    std::vector<CurvePoint> points;  ///< by samples, upwards
    double slope = kNotMeasured;  ///< d log(error) / d log(samples); -0.5 for independent samples
    Interval slope_band;
    std::uint32_t replicates = 0;  ///< independent pictures that each point was estimated from
};

/// What switching one effect off would save and lose, everything else as it is.
struct EffectBill {
    ir::Effect effect = ir::Effect::kCount_;
    std::int64_t rays = 0;          ///< saved, of one picture; below 0 if more are traced without
    double seconds = kNotMeasured;  ///< saved, of one picture; below 0 if it takes longer without
    Interval seconds_band;
    double share = kNotMeasured;  ///< those seconds as a part of the picture's
    double rmse = kNotMeasured;   ///< of the picture without the effect from the one with it
    double flip = kNotMeasured;
    double maximum = kNotMeasured;  ///< largest difference of one channel of one pixel
};

/// Where the time of a picture goes. Together the stages and the waiting are the time of all
/// workers, `workers` times `seconds`.
struct StageBill {
    struct Stage {
        TimedStage stage = TimedStage::kCount_;
        double seconds = kNotMeasured;  ///< of all workers
    };
    std::uint32_t samples = 0;  ///< a pixel; 0: no bill
    std::uint32_t workers = 0;
    double seconds = kNotMeasured;  ///< of rendering, without the preparation
    std::vector<Stage> stages;      ///< those that there are, in the order of a ray's life
    double waiting = kNotMeasured;  ///< of workers that had no tile to work on, and between tiles
};

/// How much of the variance of a pixel's value is due to one source of random numbers: alone, and
/// with all its interactions (Sobol's first-order and total index).
struct NoiseShare {
    std::string name;  ///< "pixel" (where in the pixel a ray goes), or an effect's name
    double first = kNotMeasured;
    double total = kNotMeasured;
    Interval first_band;
    Interval total_band;
};

/// Of the estimator of `samples` a pixel: shares depend on that number. First-order shares and
/// `together` sum to 1; totals overlap, and do not.
struct NoiseBill {
    std::uint32_t samples = 0;
    std::uint32_t seeds = 0;         ///< of each source; 0: no bill
    std::vector<NoiseShare> shares;  ///< the pixel's alone if no effect is sampled
    double together = kNotMeasured;  ///< what interactions of two and more sources make
    Interval together_band;
};

/// One picture in float and in double.
struct PrecisionBill {
    double float_seconds = kNotMeasured;
    double double_seconds = kNotMeasured;
    std::uint64_t differing_pixels = 0;  ///< a channel differs by more than 1/255
    std::uint64_t pixels = 0;            ///< of the picture; 0: not measured
    std::uint64_t changed_hits = 0;      ///< camera rays that hit another primitive
};

/// An error that more samples will not mend.
struct Bias {
    std::string name;     ///< "bounce limit", "clamping", "texture filter"
    std::string meaning;  ///< what was compared with what, one sentence
    double rmse = kNotMeasured;
    double flip = kNotMeasured;
    double maximum = kNotMeasured;
};

/// One choice of settings.
struct Rung {
    std::uint32_t samples = 0;        ///< a pixel
    std::uint32_t light_samples = 0;  ///< a light and hit; 0: the scene has no light with a size
    std::uint32_t bounces = 0;
    Precision precision = Precision::kFloat;
    double seconds = kNotMeasured;
    double error = kNotMeasured;  ///< RMSE from the best picture of the study: noise and bias
    double flip = kNotMeasured;   ///< from the same picture
    bool on_front = false;        ///< no other rung is both quicker and nearer
    bool verified = false;        ///< both were measured again, with another seed
    std::string name;             ///< for people: "16 spp x 4 light", "2 spp (preview)"
    Plane32 picture;              ///< display values, three channels; empty if not kept
    Plane32 error_map;  ///< largest channel's |difference| of each pixel, one channel; empty if not
};

struct CostReport {
    std::string scene;  ///< as it was named
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t threads = 0;
    std::uint64_t seed = 0;
    // As asked about; choices may have others.
    std::uint32_t light_samples = 1;
    std::uint32_t bounces = 0;
    Precision asked_precision = Precision::kFloat;
    ErrorCurve curve;
    StageBill stages;
    std::vector<EffectBill> effects;   ///< of those that the scene calls for
    std::uint32_t effect_samples = 0;  ///< a pixel, of the pictures with and without them
    std::uint32_t effect_runs = 0;     ///< of each of these pictures
    NoiseBill noise;
    PrecisionBill precision;
    std::vector<Bias> biases;
    std::vector<Rung> rungs;
    std::string recommendation;  ///< sentences; empty if the study did not get that far
    double study_seconds = kNotMeasured;
    double pixels_per_degree = 0;  ///< that FLIP assumed
};

}  // namespace cobble::renderer
