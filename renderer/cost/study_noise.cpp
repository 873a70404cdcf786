// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include "renderer/cost/noise.hpp"
#include "renderer/cost/parts.hpp"
#include "renderer/sampling/sample_pass.hpp"

namespace cobble::renderer {
namespace {

struct Source {
    Draw draw;
    ir::Effect effect;  ///< that draws; kCount_: always
};
constexpr Source kSources[] = {{Draw::kPixel, ir::Effect::kCount_},
                               {Draw::kLens, ir::Effect::kDepthOfField},
                               {Draw::kTime, ir::Effect::kMotionBlur},
                               {Draw::kLight, ir::Effect::kSoftShadows}};

}  // namespace

std::optional<NoiseBill> study_noise(const Studio& studio, std::uint32_t samples,
                                     std::uint32_t pairs) {
    std::vector<Draw> draws;
    std::vector<std::string> names;
    for (const Source& source : kSources) {
        const bool pixel = source.effect == ir::Effect::kCount_;
        if (!pixel && !studio.settings().effects.on(source.effect)) continue;
        draws.push_back(source.draw);
        names.emplace_back(pixel ? "pixel" : ir::name_of(source.effect));
    }
    bool stopped = false;
    const Estimator estimator = [&](const std::vector<std::uint16_t>& seeds,
                                    std::vector<double>& values) {
        SamplePass salts;
        for (std::size_t i = 0; i < draws.size(); ++i) salts.set_salt(draws[i], seeds[i]);
        Settings settings = studio.settings(samples);
        settings.salts = salts.salts;
        const std::optional<Run> run = studio.run(settings);
        if (!run) {
            stopped = true;
            return false;
        }
        values.assign(run->picture.color.values.begin(), run->picture.color.values.end());
        return true;
    };
    NoiseBill bill = measure_noise(names, pairs, estimator);
    if (stopped) return std::nullopt;
    bill.samples = samples;
    return bill;
}

}  // namespace cobble::renderer
