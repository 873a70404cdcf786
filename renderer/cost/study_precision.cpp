// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include "renderer/cost/parts.hpp"
#include "renderer/integrator/shading_scene.hpp"
#include "renderer/integrator/stages.hpp"
#include "renderer/intersect/intersect.hpp"
#include "renderer/job/fp_environment.hpp"

namespace cobble::renderer {
namespace {

/// What the ray through each pixel's middle hits first, through a pinhole when the shutter opens.
template <typename T>
std::vector<Hit<T>> first_hits(const ir::Scene& scene, Settings settings) {
    const FpEnvironment environment;
    for (const ir::Effect effect : {ir::Effect::kDepthOfField, ir::Effect::kMotionBlur}) {
        settings.effects.states[static_cast<std::size_t>(effect)].on = false;
    }
    const ShadingScene<T> shading = prepare_shading<T>(scene, settings);
    const Crop window = window_of(settings);
    Counters counters;
    std::vector<Hit<T>> hits;
    for (std::uint32_t y = window.y0; y < window.y1; ++y) {
        for (std::uint32_t x = window.x0; x < window.x1; ++x) {
            const Ray<T> ray =
                camera_ray_as<RayStage::kPinhole>(shading, Sampler(0, x, y, 0), x + 0.5, y + 0.5);
            hits.push_back(closest_hit(shading.geometry, ray, {}, counters));
        }
    }
    return hits;
}

}  // namespace

std::optional<PrecisionBill> study_precision(const Studio& studio, std::uint32_t samples) {
    Settings settings = studio.settings(samples);
    settings.precision = Precision::kFloat;
    const std::optional<Run> single = studio.run(settings);
    settings.precision = Precision::kDouble;
    const std::optional<Run> twice = single ? studio.run(settings) : std::nullopt;
    if (!twice) return std::nullopt;
    PrecisionBill bill;
    bill.float_seconds = single->seconds();
    bill.double_seconds = twice->seconds();
    const std::vector<float>& a = single->picture.color.values;
    const std::vector<float>& b = twice->picture.color.values;
    bill.pixels = a.size() / 3;
    for (std::size_t i = 0; i < bill.pixels; ++i) {
        bool differs = false;
        for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
            differs = differs || std::fabs(a[c] - b[c]) > 1.0F / 255;
        }
        if (differs) ++bill.differing_pixels;
    }
    const auto in_float = first_hits<float>(studio.scene(), settings);
    const auto in_double = first_hits<double>(studio.scene(), settings);
    for (std::size_t i = 0; i < in_float.size(); ++i) {
        const bool same = static_cast<bool>(in_float[i]) == static_cast<bool>(in_double[i]) &&
                          (!in_float[i] || (in_float[i].object == in_double[i].object &&
                                            in_float[i].face == in_double[i].face));
        if (!same) ++bill.changed_hits;
    }
    return bill;
}

}  // namespace cobble::renderer
