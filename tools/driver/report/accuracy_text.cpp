// SPDX-License-Identifier: MIT
#include "tools/driver/report/accuracy_text.hpp"

#include <fmt/core.h>

#include "renderer/passes/guarantee.hpp"

namespace cobble::driver {

std::string guarantee_text(const renderer::ErrorGoal& goal) {
    const std::uint32_t fewest = renderer::guarantee_fewest_samples(goal.error);
    if (fewest > goal.most_samples) {
        return fmt::format(
            "error {:g} guaranteed: would take {} samples a pixel at least, and --max-samples "
            "allows {}\n",
            goal.error, fewest, goal.most_samples);
    }
    return fmt::format(
        "error {:g} guaranteed: takes {} samples a pixel at least, each clamped to [0, 1]\n",
        goal.error, fewest);
}

std::string forecast_text(const renderer::Forecast& forecast, double error) {
    return fmt::format("error {:g}: expects {:.0f} samples a pixel and {:.2f} s\n", error,
                       forecast.samples, forecast.seconds);
}

std::string budget_text(const renderer::BudgetChoice& choice, std::uint32_t scrambles,
                        double budget) {
    const std::string settings =
        fmt::format("--samples {} --scrambles {}", choice.samples, scrambles);
    if (!choice.fits) {
        return fmt::format("budget {:g} s: is too short; {} are the fewest, and take {:.2f} s\n",
                           budget, settings, choice.seconds);
    }
    return fmt::format("budget {:g} s: {}, expects {:.2f} s and an error of {:.2g}\n", budget,
                       settings, choice.seconds, choice.rms);
}

std::string achieved_text(const renderer::Achieved& achieved, const renderer::ErrorGoal* goal) {
    using Method = renderer::ErrorGoal::Method;
    std::string text = "error: ";
    if (achieved.rms > 0 || goal == nullptr) {
        text += fmt::format("{:.2g} (root mean square); ", achieved.rms);
    }
    const bool guaranteed = goal != nullptr && goal->method == Method::kGuarantee;
    text +=
        fmt::format("99 % of pixels within {:.2g}, all within {:.2g}{}", achieved.percentile_99,
                    achieved.largest, guaranteed ? ", guaranteed to 95 %" : " (95 % intervals)");
    if (goal == nullptr) return text + "\n";
    text += fmt::format("; {} to {} samples a pixel", achieved.fewest, achieved.most);
    if (achieved.forecast) {
        text += fmt::format(" (expected {:.0f} samples a pixel and {:.2f} s)",
                            achieved.forecast->samples, achieved.forecast->seconds);
    }
    text += '\n';
    if (achieved.beyond_goal > 0) {
        text += fmt::format(
            "not reached: {} of {} pixels are not within {:g} after {} samples (--max-samples "
            "allows "
            "more)\n",
            achieved.beyond_goal, achieved.pixels, goal->error, achieved.most);
    }
    return text;
}

}  // namespace cobble::driver
