// SPDX-License-Identifier: MIT
// A study of cost as one HTML page.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "ir/math/elementary.hpp"
#include "renderer/metrics/compare.hpp"
#include "tools/driver/chart/svg.hpp"
#include "tools/driver/report/cost_report.hpp"
#include "tools/driver/report/cost_style.hpp"
#include "tools/driver/report/cost_tables.hpp"
#include "tools/driver/report/figures.hpp"
#include "tools/driver/report/html.hpp"

namespace cobble::driver {
namespace {

using renderer::CostReport;
using renderer::Plane32;
using renderer::Rung;

std::string escape(std::string_view text) { return chart::escape_xml(text); }

std::string section(std::string_view id, std::string_view title, const std::string& body) {
    return fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", escape(id),
                       escape(title), body);
}

std::string section(const CostTable& table, const std::string& above = {}) {
    return section(table.id, sentence(table.title), above + html_table(table));
}

std::string figure_of(const std::string& svg) {
    return "<figure class=\"chart\" tabindex=\"0\">\n" + svg + "</figure>\n";
}

// What is less than this cannot be seen on a display of 8 bits.
constexpr double kOneStep = 1.0 / 255;

// One scale for all maps, so that they can be compared: most of an error is below three times its
// root mean square, also where few pixels hold most of it.
double map_scale(const CostReport& report) {
    double largest = 0;
    for (const Rung& rung : report.rungs) {
        if (!rung.error_map.values.empty() && std::isfinite(rung.error)) {
            largest = std::max(largest, rung.error);
        }
    }
    return std::max(3 * largest, 4 * kOneStep);
}

// By the logarithm: errors of choices are as far apart as their times. NaN is black too: it is no
// error that was measured.
Plane32 colored(const Plane32& map, double scale) {
    Plane32 result = map;
    const double range = math::log(scale / kOneStep);
    for (float& value : result.values) {
        const double unit = value > kOneStep ? math::log(value / kOneStep) / range : 0;
        value = static_cast<float>(std::min(unit, 1.0));
    }
    return renderer::heat_map(result);
}

std::string map_key(double scale) {
    constexpr std::uint32_t kSteps = 256;
    Plane32 ramp{kSteps, 1, 1, {}};
    for (std::uint32_t i = 0; i < kSteps; ++i) {
        ramp.values.push_back(static_cast<float>(i) / (kSteps - 1));
    }
    return fmt::format(
        "<p class=\"key\"><span>less than 1/255, which no display of 8 bits shows</span>{}"
        "<span>{} and above</span></p>\n",
        html_picture(renderer::heat_map(ramp), "from black over purple and orange to pale yellow"),
        figure(scale));
}

std::string facts(const Rung& rung) {
    const auto fact = [](std::string_view name, const std::string& value) {
        return fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", name, escape(value));
    };
    const bool lights = rung.light_samples > 1;
    return "<dl>" + fact("samples", std::to_string(rung.samples)) +
           (lights ? fact("for lights", std::to_string(rung.light_samples)) : "") +
           fact("bounces", std::to_string(rung.bounces)) + fact("seconds", figure(rung.seconds)) +
           fact("error", figure(rung.error)) + fact("FLIP", figure(rung.flip)) + "</dl>\n";
}

std::string card(const Rung& rung, double scale) {
    const std::string name = rung_name(rung);
    const std::string picture = html_picture(
        rung.picture, fmt::format("the scene with {} a pixel, {} s to render, error {}", name,
                                  figure(rung.seconds), figure(rung.error)));
    std::string map;
    if (!rung.error_map.values.empty()) {
        map = html_picture(
            colored(rung.error_map, scale),
            fmt::format("error map of {}: where it differs from the best picture", name));
    }
    const auto or_words = [](const std::string& html, std::string_view words) {
        return html.empty() ? fmt::format("<p class=\"missing\">{}</p>\n", words) : html + "\n";
    };
    return fmt::format("<figure>\n<figcaption><h3>{}</h3>\n{}</figcaption>\n", escape(name),
                       facts(rung)) +
           or_words(picture, "This picture was not kept.") +
           or_words(map, "There is no error map of it.") + "</figure>\n";
}

std::string pictures(const CostReport& report) {
    std::string cards;
    bool any_map = false;
    const double scale = map_scale(report);
    for (const Rung& rung : report.rungs) {
        if (rung.picture.values.empty() && rung.error_map.values.empty()) continue;
        any_map = any_map || !rung.error_map.values.empty();
        cards += card(rung, scale);
    }
    if (cards.empty()) {
        return "<p class=\"missing\">No pictures: the study kept none, or ended before.</p>\n";
    }
    return "<p>Each with a map of its error: how far the channel that differs most is from the "
           "best picture of the study, in the same colours for all, by the logarithm.</p>\n" +
           (any_map ? map_key(scale) : "") + "<div class=\"cards\">\n" + cards + "</div>\n";
}

std::string head(const CostReport& report) {
    const std::string title = "What accuracy costs in time: " + report.scene;
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
        "style-src 'unsafe-inline'\">\n"
        "<meta name=\"color-scheme\" content=\"light dark\">\n"
        "<title>{}</title>\n<style>\n{}</style>\n</head>\n",
        escape(title), cost_style());
}

std::string contents(const std::vector<std::pair<std::string, std::string>>& entries) {
    std::string html = "<nav aria-label=\"Contents\"><ul>\n";
    for (const auto& [id, title] : entries) {
        html +=
            fmt::format("<li><a href=\"#{}\">{}</a></li>\n", escape(id), escape(sentence(title)));
    }
    return html + "</ul></nav>\n";
}

// Terms that the page uses, for who meets them first here.
constexpr std::string_view kTerms =
    "<dl class=\"terms\">\n"
    "<dt>samples</dt><dd>Rays from the camera for each pixel.</dd>\n"
    "<dt>error</dt><dd>The root of the mean square (RMSE) over all pixels and channels, as the "
    "display shows them: 0 is black, 1 is white.</dd>\n"
    "<dt>95 % interval</dt><dd>Found by this method, it holds the true value 95 times of 100."
    "</dd>\n"
    "<dt>FLIP</dt><dd>What an eye sees of the difference that flips between two pictures, from 0 "
    "to 1.</dd>\n"
    "<dt>the front</dt><dd>The choices that no other beats in both time and error.</dd>\n"
    "<dt>-</dt><dd>Not measured, or not there.</dd>\n"
    "</dl>\n";

}  // namespace

std::string cost_to_html(const CostReport& report) {
    const CostTable curve = curve_table(report);
    const CostTable rungs = rung_table(report);
    const CostTable stages = stage_table(report);
    const CostTable effects = effect_table(report);
    const CostTable noise = noise_table(report);
    const CostTable precision = precision_table(report);
    const CostTable bias = bias_table(report);
    std::string html = head(report);
    html += fmt::format(
        "<body>\n<header>\n<h1>What accuracy costs in time</h1>\n<p>{}; {}; FLIP at {:g} pixels "
        "per "
        "degree.</p>\n</header>\n<main>\n"
        "<section id=\"recommendation\">\n<h2>Recommendation</h2>\n<p>{}</p>\n</section>\n",
        escape(cost_subject(report)), escape(cost_study_time(report)), report.pixels_per_degree,
        escape(sentence(cost_recommendation(report))));
    html += contents({{curve.id, curve.title},
                      {"pictures", "pictures"},
                      {rungs.id, rungs.title},
                      {stages.id, stages.title},
                      {effects.id, effects.title},
                      {noise.id, noise.title},
                      {precision.id, precision.title},
                      {bias.id, bias.title},
                      {"terms", "terms"}});
    const bool any_point = !report.curve.points.empty() || !report.rungs.empty();
    html += section(curve, any_point ? figure_of(cost_to_svg(report)) : "");
    html += section("pictures", "Pictures", pictures(report));
    html += section(rungs);
    const bool any_share = !report.effects.empty() || !report.noise.shares.empty();
    html += section(stages);
    html += section(effects, any_share ? figure_of(cost_shares_to_svg(report)) : "");
    html += section(noise);
    html += section(precision);
    html += section(bias);
    html += section("terms", "Terms", std::string(kTerms));
    return html + "</main>\n</body>\n</html>\n";
}

}  // namespace cobble::driver
