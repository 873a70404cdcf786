// SPDX-License-Identifier: MIT
// A study of cost for programs.
#include <cmath>
#include <utility>

#include "tools/driver/report/cost_report.hpp"
#include "tools/driver/report/cost_tables.hpp"

namespace cobble::driver {
namespace {

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json to_json(const renderer::Interval& band) {
    if (!std::isfinite(band.low) || !std::isfinite(band.high)) return nullptr;
    return Json::array({band.low, band.high});
}

Json to_json(const renderer::ErrorCurve& curve) {
    if (curve.points.empty()) return nullptr;
    Json points = Json::array();
    for (const renderer::CurvePoint& point : curve.points) {
        points.push_back({{"samples", point.samples},
                          {"seconds", number(point.seconds)},
                          {"error", number(point.error)},
                          {"band", to_json(point.band)}});
    }
    return {{"replicates", curve.replicates},
            {"slope", number(curve.slope)},
            {"slope_band", to_json(curve.slope_band)},
            {"points", std::move(points)}};
}

Json to_json(const renderer::StageBill& bill) {
    if (bill.samples == 0) return nullptr;
    Json stages = Json::array();
    for (const auto& [stage, seconds] : bill.stages) {
        stages.push_back({{"name", renderer::name_of(stage)}, {"seconds", number(seconds)}});
    }
    return {{"samples", bill.samples},
            {"workers", bill.workers},
            {"seconds", number(bill.seconds)},
            {"stages", std::move(stages)},
            {"waiting", number(bill.waiting)}};
}

Json to_json(const renderer::EffectBill& bill) {
    return {{"effect", ir::name_of(bill.effect)}, {"rays", bill.rays},
            {"seconds", number(bill.seconds)},    {"seconds_band", to_json(bill.seconds_band)},
            {"share", number(bill.share)},        {"rmse", number(bill.rmse)},
            {"flip", number(bill.flip)},          {"maximum", number(bill.maximum)}};
}

Json to_json(const renderer::NoiseBill& noise) {
    if (noise.shares.empty()) return nullptr;
    Json shares = Json::array();
    for (const renderer::NoiseShare& share : noise.shares) {
        shares.push_back({{"name", share.name},
                          {"first", number(share.first)},
                          {"first_band", to_json(share.first_band)},
                          {"total", number(share.total)},
                          {"total_band", to_json(share.total_band)}});
    }
    return {{"samples", noise.samples},
            {"seeds", noise.seeds},
            {"shares", std::move(shares)},
            {"together", number(noise.together)},
            {"together_band", to_json(noise.together_band)}};
}

Json to_json(const renderer::PrecisionBill& bill) {
    if (bill.pixels == 0) return nullptr;
    return {{"float_seconds", number(bill.float_seconds)},
            {"double_seconds", number(bill.double_seconds)},
            {"differing_pixels", bill.differing_pixels},
            {"pixels", bill.pixels},
            {"changed_hits", bill.changed_hits}};
}

Json to_json(const renderer::Bias& bias) {
    return {{"name", bias.name},
            {"meaning", bias.meaning},
            {"rmse", number(bias.rmse)},
            {"flip", number(bias.flip)},
            {"maximum", number(bias.maximum)}};
}

Json to_json(const renderer::Rung& rung) {
    return {{"name", rung.name},
            {"samples", rung.samples},
            {"light_samples", rung.light_samples},
            {"bounces", rung.bounces},
            {"precision", precision_name(rung.precision)},
            {"seconds", number(rung.seconds)},
            {"error", number(rung.error)},
            {"flip", number(rung.flip)},
            {"on_front", rung.on_front},
            {"verified", rung.verified}};
}

template <typename Record>
Json list_of(const std::vector<Record>& records) {
    Json list = Json::array();
    for (const Record& record : records) list.push_back(to_json(record));
    return list;
}

}  // namespace

Json cost_to_json(const renderer::CostReport& report) {
    Json json = {{"cobble_cost", 1},
                 {"path", report.scene},
                 {"size", Json::array({report.width, report.height})},
                 {"threads", report.threads},
                 {"seed", report.seed},
                 {"light_samples", report.light_samples},
                 {"bounces", report.bounces},
                 {"asked_precision", precision_name(report.asked_precision)},
                 {"study_seconds", number(report.study_seconds)},
                 {"pixels_per_degree", number(report.pixels_per_degree)},
                 {"curve", to_json(report.curve)},
                 {"stages", to_json(report.stages)},
                 {"effects", list_of(report.effects)},
                 {"effect_samples", report.effect_samples},
                 {"effect_runs", report.effect_runs},
                 {"noise", to_json(report.noise)},
                 {"precision", to_json(report.precision)},
                 {"biases", list_of(report.biases)},
                 {"rungs", list_of(report.rungs)},
                 {"recommendation", nullptr}};
    if (!report.recommendation.empty()) json["recommendation"] = report.recommendation;
    return json;
}

}  // namespace cobble::driver
