// SPDX-License-Identifier: MIT
#include "tests/driver/cost/study.hpp"

#include <cstddef>
#include <limits>

namespace cobble::test {
namespace {

using renderer::CostReport;
using renderer::Plane32;
using renderer::Rung;

Plane32 gradient(std::uint32_t channels, float scale) {
    Plane32 plane{8, 6, channels, {}};
    for (std::uint32_t y = 0; y < plane.height; ++y) {
        for (std::uint32_t x = 0; x < plane.width; ++x) {
            for (std::uint32_t c = 0; c < channels; ++c) {
                plane.values.push_back(scale * static_cast<float>(x + y + c) / 14);
            }
        }
    }
    return plane;
}

void add_curve(CostReport& report) {
    report.curve.replicates = 8;
    report.curve.slope = -0.643;
    report.curve.slope_band = {-0.671, -0.615};
    report.curve.points = {
        {1, 0.0213, 0.0961, {0.0925, 0.0999}},     {2, 0.0391, 0.0648, {0.0622, 0.0676}},
        {4, 0.0747, 0.0421, {0.0403, 0.0441}},     {8, 0.146, 0.0274, {0.0261, 0.0288}},
        {16, 0.288, 0.01731, {0.0164, 0.0183}},    {32, 0.572, 0.01102, {0.0104, 0.0118}},
        {64, 1.141, 0.00689, {0.00641, 0.00748}},  {128, 2.279, 0.00437, {0.00401, 0.00482}},
        {256, 4.554, 0.00281, {0.00250, 0.00322}},
    };
}

void add_bills(CostReport& report) {
    using ir::Effect;
    report.effects = {
        {Effect::kDepthOfField, 0, 0.0123, {0.0102, 0.0144}, 0.043, 0.0312, 0.0418, 0.7821},
        {Effect::kSoftShadows, 0, 0.0191, {0.017, 0.0212}, 0.066, 0.0207, 0.0263, 0.5112},
        {Effect::kShadows, 4915200, 0.1012, {0.0991, 0.1033}, 0.351, 0.1284, 0.1391, 0.8934},
        {Effect::kReflection, 1203381, 0.0524, {0.0503, 0.0545}, 0.182, 0.0713, 0.0655, 0.6471},
        {Effect::kTextures, 0, -0.0011, {-0.0032, 0.001}, -0.0038, 0.0891, 0.0977, 0.7012},
    };
    report.effect_samples = 16;
    report.effect_runs = 5;
    using renderer::TimedStage;
    report.stages = {16,
                     2,
                     0.288,
                     {{TimedStage::kCamera, 0.031},
                      {TimedStage::kHits, 0.187},
                      {TimedStage::kSurfaces, 0.093},
                      {TimedStage::kLights, 0.041},
                      {TimedStage::kShadows, 0.151},
                      {TimedStage::kColors, 0.012},
                      {TimedStage::kOnward, 0.034},
                      {TimedStage::kPixels, 0.009}},
                     0.018};
    report.noise.samples = 16;
    report.noise.seeds = 16;
    report.noise.shares = {
        {"pixel", 0.213, 0.298, {0.187, 0.241}, {0.262, 0.337}},
        {"depth-of-field", 0.402, 0.517, {0.371, 0.433}, {0.474, 0.561}},
        {"soft-shadows", 0.231, 0.322, {0.203, 0.260}, {0.284, 0.362}},
    };
    report.noise.together = 0.154;
    report.noise.together_band = {0.121, 0.186};
    report.precision = {0.288, 0.391, 12, 307200, 3};
    report.biases = {
        {"bounce limit",
         "4 bounces compared with 16, at 64 samples a pixel, the same numbers drawn", 0.00131,
         0.00087, 0.1412},
        {"clamping", "values above 1 are cut at 1 in the picture: compared with what was computed",
         0.00212, 0, 0.3381},
        {"texture filter",
         "no filter makes far textures smaller: compared with 4x4 the pixels, "
         "averaged",
         0.00461, 0.00533, 0.2714},
    };
}

Rung rung(std::uint32_t samples, std::uint32_t bounces, double seconds, double error,
          std::string name) {
    Rung result;
    result.samples = samples;
    result.light_samples = 1;
    result.bounces = bounces;
    result.seconds = seconds;
    result.error = error;
    result.flip = error * 1.2;
    result.on_front = !name.empty();
    result.verified = result.on_front;
    result.name = std::move(name);
    return result;
}

void add_rungs(CostReport& report) {
    report.rungs = {
        rung(1, 4, 0.0213, 0.0963, "1 spp (preview)"),
        rung(4, 2, 0.0691, 0.0434, "4 spp x 2 light"),
        rung(4, 4, 0.0747, 0.0438, ""),
        rung(16, 4, 0.288, 0.0175, "16 spp"),
        rung(16, 8, 0.297, 0.0176, ""),
        rung(64, 4, 1.141, 0.00701, "64 spp"),
        rung(128, 8, 2.41, 0.00442, "128 spp (final)"),
        rung(128, 8, 3.31, 0.00443, ""),
    };
    report.rungs[1].light_samples = 2;
    report.rungs[5].verified = false;
    // On the front without a name; and on it in double.
    report.rungs[3].name.clear();
    report.rungs[6].precision = report.rungs[7].precision = renderer::Precision::kDouble;
    for (const std::size_t kept : {0U, 3U, 6U}) {
        Rung& with = report.rungs[kept];
        with.picture = gradient(3, 0.9F);
        with.error_map = gradient(1, static_cast<float>(with.error));
    }
    report.rungs[3].error_map.values.clear();
}

CostReport head() {
    CostReport report;
    report.scene = "scenes/basics/still life & more.scene";
    report.width = 640;
    report.height = 480;
    report.threads = 2;
    report.pixels_per_degree = 67;
    return report;
}

}  // namespace

CostReport whole_study() {
    CostReport report = head();
    report.study_seconds = 58.21;
    report.recommendation =
        "64 samples a pixel reach an error of 0.00701 in 1.14 s; four times the time would "
        "leave 0.00281, and depth-of-field makes most of the noise that is left.";
    add_curve(report);
    add_bills(report);
    add_rungs(report);
    return report;
}

CostReport cut_short_study() {
    CostReport report = head();
    report.study_seconds = 1.02;
    report.curve.replicates = 8;
    report.curve.points = {{1, 0.0213, 0.0961, {0.0925, 0.0999}}, {2, 0.0391, 0.0648, {}}};
    return report;
}

CostReport study_without_numbers() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    CostReport report = head();
    report.scene = "a\x1b[31m<b>\"c\"'\xFF.scene";
    add_curve(report);
    add_bills(report);
    add_rungs(report);
    report.curve.slope = -kInfinity;
    for (renderer::CurvePoint& point : report.curve.points) {
        point.error = 0;
        point.band = {0, 0};
    }
    report.curve.points[3].seconds = kInfinity;
    for (renderer::EffectBill& bill : report.effects) {
        bill.share = bill.seconds = bill.rmse = renderer::kNotMeasured;
    }
    for (renderer::NoiseShare& share : report.noise.shares) share.first = kInfinity;
    report.noise.together = renderer::kNotMeasured;
    report.precision.float_seconds = 0;
    for (Rung& rung : report.rungs) {
        rung.seconds = renderer::kNotMeasured;
        rung.error = -kInfinity;
        for (float& value : rung.error_map.values) {
            value = std::numeric_limits<float>::quiet_NaN();
        }
    }
    return report;
}

}  // namespace cobble::test
