// SPDX-License-Identifier: MIT
#include "tools/driver/report/effects_report.hpp"

#include <fmt/core.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "tools/driver/report/positions.hpp"
#include "tools/driver/text.hpp"

namespace cobble::driver {
namespace {

std::string_view trimmed(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t");
    return first == std::string_view::npos ? std::string_view() : line.substr(first);
}

std::string cause_text(source::Span cause, Positions& positions) {
    constexpr std::size_t kEnough = 60;
    const source::LineColumn at = positions.start(cause);
    const std::string_view line =
        trimmed(positions.lines(cause.source).line_text(at.line)).substr(0, kEnough);
    return fmt::format("    {}:{}:{}: {}\n", printable(positions.path(cause)), at.line, at.column,
                       printable(line));
}

std::string effect_text(ir::Effect effect, const ir::EffectState& state, Positions& positions) {
    std::string text =
        fmt::format("{:<16} {:<4} {}\n", ir::name_of(effect), state.on ? "on" : "off",
                    state.on ? ir::description_of(effect) : std::string_view(state.reason));
    if (state.on && !state.reason.empty()) text += fmt::format("    {}\n", state.reason);
    for (const source::Span cause : state.causes) {
        if (cause.valid()) text += cause_text(cause, positions);
    }
    return text;
}

std::string bytes_text(const renderer::PlannedBytes& planned) {
    if (planned.bytes == 0) {
        return fmt::format("  {:<20} {:>10}  {}\n", planned.name, 0, planned.why_none);
    }
    return fmt::format("  {:<20} {:>10}\n", planned.name, planned.bytes);
}

std::string plan_text(const renderer::RenderPlan& plan) {
    std::string text = "\nstages, each in the form that was chosen for the whole picture\n";
    for (const renderer::PlannedStage& stage : renderer::stages_of(plan)) {
        text += fmt::format("  {:<12} {:<31} {}\n", stage.stage, stage.form, stage.why);
    }
    text += "columns of a batch, in bytes for each thread\n";
    for (const auto& columns : renderer::columns_of(plan)) text += bytes_text(columns);
    text += "pictures that surfaces and background read, in bytes\n";
    for (const auto& pictures : plan.pictures) text += bytes_text(pictures);
    return text;
}

Json bytes_json(const std::vector<renderer::PlannedBytes>& all) {
    Json result = Json::array();
    for (const auto& planned : all) {
        result.push_back({{"name", planned.name}, {"bytes", planned.bytes}});
    }
    return result;
}

Json plan_json(const renderer::RenderPlan& plan) {
    Json stages = Json::array();
    for (const renderer::PlannedStage& stage : renderer::stages_of(plan)) {
        stages.push_back({{"stage", stage.stage}, {"form", stage.form}, {"why", stage.why}});
    }
    return {{"stages", std::move(stages)},
            {"columns", bytes_json(renderer::columns_of(plan))},
            {"pictures", bytes_json(plan.pictures)}};
}

}  // namespace

std::string effects_to_text(const EffectsReport& report) {
    Positions positions(report.sources);
    std::string text;
    for (std::size_t i = 0; i < ir::kEffectCount; ++i) {
        text += effect_text(static_cast<ir::Effect>(i), report.effects.states[i], positions);
    }
    if (report.plan != nullptr) text += plan_text(*report.plan);
    return text;
}

Json effects_to_json(const EffectsReport& report) {
    Positions positions(report.sources);
    Json effects = Json::array();
    for (std::size_t i = 0; i < ir::kEffectCount; ++i) {
        const auto effect = static_cast<ir::Effect>(i);
        const ir::EffectState& state = report.effects.states[i];
        Json causes = Json::array();
        for (const source::Span cause : state.causes) {
            if (!cause.valid()) continue;
            causes.push_back(
                {{"path", positions.path(cause)}, {"range", range_to_json(cause, positions)}});
        }
        effects.push_back({{"name", ir::name_of(effect)},
                           {"on", state.on},
                           {"description", ir::description_of(effect)},
                           {"reason", state.reason.empty() ? Json() : Json(state.reason)},
                           {"causes", std::move(causes)}});
    }
    Json json = {{"version", 1}, {"path", report.path}, {"effects", std::move(effects)}};
    if (report.plan != nullptr) json["plan"] = plan_json(*report.plan);
    return json;
}

}  // namespace cobble::driver
