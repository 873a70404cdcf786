// SPDX-License-Identifier: MIT
#include "tools/driver/report/cost_tables.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "ir/math/elementary.hpp"
#include "tools/driver/report/figures.hpp"
#include "tools/driver/text.hpp"

namespace cobble::driver {
namespace {

using renderer::CostReport;

constexpr std::string_view kStopped = "the study ended before it was measured";

std::string interval(const renderer::Interval& band) {
    return driver::interval(band.low, band.high);
}

std::string percent_interval(const renderer::Interval& band) {
    return driver::percent_interval(band.low, band.high);
}

// What is left of the error after twice the samples.
double left_after_doubling(double slope) { return math::pow(2, slope); }

std::string degrees_figure(const CostReport& report) {
    return fmt::format("{:g}", report.pixels_per_degree);
}

std::string front_words(const renderer::Rung& rung) {
    if (!rung.on_front) return "no";
    return rung.verified ? "verified" : "yes";
}

}  // namespace

std::string precision_name(renderer::Precision precision) {
    return precision == renderer::Precision::kFloat ? "float" : "double";
}

std::string rung_name(const renderer::Rung& rung) {
    std::string name = rung.name.empty() ? counted(rung.samples, "sample") : printable(rung.name);
    if (rung.precision == renderer::Precision::kDouble) name += ", double";
    return name;
}

std::string cost_subject(const CostReport& report) {
    std::string text = fmt::format("{}, {}x{}, {}, seed {}", printable(report.scene), report.width,
                                   report.height, counted(report.threads, "thread"), report.seed);
    if (report.light_samples > 1) {
        text += fmt::format(", {} light samples each", report.light_samples);
    }
    return text;
}

std::string cost_study_time(const CostReport& report) {
    if (!std::isfinite(report.study_seconds)) return "how long the study took is not known";
    return fmt::format("studied for {} s", figure(report.study_seconds));
}

std::string cost_recommendation(const CostReport& report) {
    if (report.recommendation.empty()) {
        return "none: too little was measured before the study ended";
    }
    return printable(report.recommendation);
}

CostTable curve_table(const CostReport& report) {
    const renderer::ErrorCurve& curve = report.curve;
    CostTable table;
    table.id = "curve";
    table.title = "error over time";
    table.lead = fmt::format(
        "noise alone: how far a picture of so many samples a pixel is from the one of endlessly "
        "many, by {} of each; RMSE, where 1 is from black to white",
        counted(curve.replicates, "independent picture"));
    table.columns = {{"samples"}, {"seconds"}, {"error"}, {"95 % interval"}};
    for (const renderer::CurvePoint& point : curve.points) {
        table.rows.push_back({std::to_string(point.samples), figure(point.seconds),
                              figure(point.error), interval(point.band)});
    }
    table.missing = fmt::format("no curve: {}", kStopped);
    if (table.rows.empty()) return table;
    if (std::isfinite(curve.slope)) {
        table.notes.push_back(fmt::format(
            "slope {} (95 %: {}): twice the samples leave {:.0f} % of the error; independent "
            "samples, of slope -0.5, would leave 71 %",
            figure(curve.slope), interval(curve.slope_band),
            100 * left_after_doubling(curve.slope)));
    } else {
        table.notes.emplace_back("no slope: it takes two points with an error above 0");
    }
    return table;
}

CostTable stage_table(const CostReport& report) {
    const renderer::StageBill& bill = report.stages;
    CostTable table;
    table.id = "stages";
    table.title = "where the time goes";
    table.columns = {{"stage", true}, {"seconds"}, {"of the time"}, {"what", true}};
    table.missing = fmt::format("no bill: {}", kStopped);
    if (bill.samples == 0) return table;
    table.lead = fmt::format(
        "of a picture of {} a pixel, rendered in {} s: the time of {} together",
        counted(bill.samples, "sample"), figure(bill.seconds), counted(bill.workers, "worker"));
    const double whole = bill.workers * bill.seconds;
    for (const auto& [stage, seconds] : bill.stages) {
        table.rows.push_back({std::string(renderer::name_of(stage)), figure(seconds),
                              percent(seconds / whole), std::string(renderer::words_for(stage))});
    }
    table.rows.push_back({"waiting", figure(bill.waiting), percent(bill.waiting / whole),
                          "for tiles, and between them"});
    return table;
}

CostTable effect_table(const CostReport& report) {
    CostTable table;
    table.id = "effects";
    table.title = "the bill of each effect";
    table.lead = fmt::format(
        "what a picture of {} a pixel saves without it, by {} of each (95 %), and what it loses: "
        "difference from the picture with it; FLIP at {} pixels per degree",
        counted(report.effect_samples, "sample"), counted(report.effect_runs, "run"),
        degrees_figure(report));
    table.columns = {{"effect", true}, {"rays"}, {"seconds"}, {"+-"},
                     {"of all"},       {"RMSE"}, {"FLIP"},    {"max"}};
    for (const renderer::EffectBill& bill : report.effects) {
        table.rows.push_back(
            {std::string(ir::name_of(bill.effect)), count_figure(bill.rays), figure(bill.seconds),
             figure((bill.seconds_band.high - bill.seconds_band.low) / 2), percent(bill.share),
             figure(bill.rmse), figure(bill.flip), figure(bill.maximum)});
    }
    if (report.effects.size() > 1) {
        table.notes.emplace_back(
            "what effects save overlaps, as mirrored rays meet shadows too: it does not sum to 100 "
            "%");
    }
    if (std::any_of(report.effects.begin(), report.effects.end(),
                    [](const renderer::EffectBill& bill) { return bill.seconds < 0; })) {
        table.notes.emplace_back("below 0: pictures took longer without the effect");
    }
    table.missing = report.effect_samples > 0 ? "no bill: the scene calls for no effect"
                                              : fmt::format("no bill: {}", kStopped);
    return table;
}

CostTable noise_table(const CostReport& report) {
    const renderer::NoiseBill& noise = report.noise;
    CostTable table;
    table.id = "noise";
    table.title = "where the noise comes from";
    table.lead = fmt::format(
        "of the variance of a picture of {} a pixel, by {} of each source; shares alone and "
        "'together' sum to 100 %, shares with others overlap",
        counted(noise.samples, "sample"), counted(noise.seeds, "seed"));
    table.columns = {
        {"source", true}, {"alone"}, {"95 % interval"}, {"with others"}, {"95 % interval"}};
    table.missing = noise.samples > 0 ? "no bill: the pictures have no noise"
                                      : fmt::format("no bill: {}", kStopped);
    for (const renderer::NoiseShare& share : noise.shares) {
        table.rows.push_back({printable(share.name), percent(share.first),
                              percent_interval(share.first_band), percent(share.total),
                              percent_interval(share.total_band)});
    }
    if (table.rows.size() == 1) {
        table.notes.emplace_back(
            "no effect of the scene draws random numbers: all noise is of where in a pixel rays "
            "go");
    } else if (!table.rows.empty()) {
        table.rows.push_back(
            {"together", percent(noise.together), percent_interval(noise.together_band), "", ""});
    }
    return table;
}

CostTable precision_table(const CostReport& report) {
    const renderer::PrecisionBill& bill = report.precision;
    CostTable table;
    table.id = "precision";
    table.title = "float and double";
    table.lead = "one picture in both number types";
    table.columns = {{"precision", true}, {"seconds"}};
    table.missing = fmt::format("no comparison: {}", kStopped);
    if (bill.pixels == 0) return table;
    table.rows = {{"float", figure(bill.float_seconds)}, {"double", figure(bill.double_seconds)}};
    const double ratio = bill.double_seconds / bill.float_seconds;
    if (std::isfinite(ratio)) {
        table.notes.push_back(fmt::format("double takes {} times as long", figure(ratio)));
    }
    table.notes.push_back(
        fmt::format("{} of {} differ by more than 1/255 in a channel; {} met another primitive",
                    bill.differing_pixels, counted(bill.pixels, "pixel"),
                    counted(bill.changed_hits, "camera ray")));
    return table;
}

CostTable bias_table(const CostReport& report) {
    CostTable table;
    table.id = "bias";
    table.title = "what more samples will not mend";
    table.lead = "errors that stay however many samples are taken";
    table.columns = {{"bias", true}, {"RMSE"}, {"FLIP"}, {"maximum"}, {"compared", true}};
    for (const renderer::Bias& bias : report.biases) {
        table.rows.push_back({printable(bias.name), figure(bias.rmse), figure(bias.flip),
                              figure(bias.maximum), printable(bias.meaning)});
    }
    table.missing =
        "no bias was measured: the scene has none of those known, or the study ended before";
    return table;
}

CostTable rung_table(const CostReport& report) {
    CostTable table;
    table.id = "choices";
    table.title = "choices";
    table.lead = fmt::format(
        "the error is from the best picture of the study, noise and bias together: RMSE, and FLIP "
        "at {} pixels per degree; on the front are those that no other beats in both time and "
        "error, verified if they were run again with another seed",
        degrees_figure(report));
    table.columns = {{"samples"}, {"for lights"}, {"bounces"}, {"precision", true},
                     {"seconds"}, {"error"},      {"FLIP"},    {"on the front", true}};
    for (const renderer::Rung& rung : report.rungs) {
        table.rows.push_back({std::to_string(rung.samples),
                              rung.light_samples == 0 ? "-" : std::to_string(rung.light_samples),
                              std::to_string(rung.bounces), precision_name(rung.precision),
                              figure(rung.seconds), figure(rung.error), figure(rung.flip),
                              front_words(rung)});
    }
    table.missing = "no choices: the study ended before any was tried";
    return table;
}

}  // namespace cobble::driver
