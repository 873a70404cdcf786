// SPDX-License-Identifier: MIT
#include "renderer/integrator/camera_batch.hpp"

#include <algorithm>
#include <span>

#include "renderer/sampling/mappings.hpp"

namespace cobble::renderer {

template <typename T>
CameraBatch<T>::CameraBatch(const ShadingScene<T>& scene, const Settings& settings,
                            const SamplePass& pass, const Tile& tile)
    : scene_(&scene),
      settings_(&settings),
      loops_(&column_loops<T>()),
      pass_(pass),
      send_(choose(scene.plan.rays)),
      next_(pass, tile),
      columns_(std::make_unique<CameraColumns>()) {}

template <typename T>
auto CameraBatch<T>::choose(RayStage stage) -> SendRays {
    using ir::Effect;
    constexpr bool kLens = compiled_in(Effect::kDepthOfField);
    constexpr bool kTime = compiled_in(Effect::kMotionBlur);
    if (kLens && kTime && stage == RayStage::kLensAndTime) {
        return &CameraBatch::send<RayStage::kLensAndTime>;
    }
    if (kLens && stage == RayStage::kLens) return &CameraBatch::send<RayStage::kLens>;
    if (kTime && stage == RayStage::kTime) return &CameraBatch::send<RayStage::kTime>;
    return &CameraBatch::send<RayStage::kPinhole>;
}

/// Where begin_sample() lets the ray through.
template <typename T>
void CameraBatch<T>::place_in_pixels() {
    CameraColumns& c = *columns_;
    if (pass_.centred) {
        for (std::size_t i = 0; i < c.run_count; ++i) {
            c.x[i] = c.runs[i].x + 0.5;
            c.y[i] = c.runs[i].y + 0.5;
        }
        return;
    }
    if (settings_->filter == PixelFilter::kBox && pass_.scatter == Scatter::kSobol) {
        loops_->place_in_pixels(c);
        return;
    }
    for (const PixelRun& run : std::span(c.runs).first(c.run_count)) {
        for (std::uint32_t i = 0; i < run.count; ++i) {
            const Sampler sampler(pass_, run.x, run.y, run.first + i);
            const math::Vec2d offset = sample_filter(sampler.draw(Draw::kPixel), settings_->filter);
            c.x[run.begin + i] = (run.x + 0.5) + offset.x;
            c.y[run.begin + i] = (run.y + 0.5) + offset.y;
        }
    }
}

template <typename T>
std::size_t CameraBatch<T>::choose_samples(std::size_t most) {
    CameraColumns& c = *columns_;
    most = std::min(most, kBatchSize);
    std::size_t count = 0;
    c.run_count = 0;
    while (count < most && !next_.at_end()) {
        static_assert(kBatchSize <= 256);
        const PixelPlace at = next_.place();
        PixelRun& run = c.runs[c.run_count];
        run.x = at.x;
        run.y = at.y;
        run.begin = static_cast<std::uint32_t>(count);
        run.first = next_.sample();
        run.count = static_cast<std::uint32_t>(std::min<std::size_t>(most - count, next_.left()));
        if (!pass_.centred) {
            run.seeds = sobol_seeds(Sampler(pass_, at.x, at.y, 0).set(Draw::kPixel, {}, 0));
        }
        std::fill_n(&run_[count], run.count, static_cast<std::uint8_t>(c.run_count++));
        count += run.count;
        next_.advance(run.count);
    }
    return count;
}

template <typename T>
void CameraBatch<T>::begin(std::size_t most, RayBatch<T>& batch, Counters& counters) {
    begin_in_columns(most, batch, counters);
    if (!batch.in_columns) return;
    for (std::size_t i = 0; i < batch.size(); ++i) batch.rays[i] = batch.ray(i);
}

/// Of rays through a pinhole origin and time are those of any.
template <typename T>
void CameraBatch<T>::fill_common(RayBatch<T>& batch) {
    if (!first_) return;
    first_ = false;
    const Ray<T> any = camera_ray_as<RayStage::kPinhole>(*scene_, Sampler(0, 0, 0, 0), 0, 0);
    for (std::size_t i = 0; i < kBatchSize; ++i) {
        batch.origin.set(i, any.origin);
        batch.time[i] = any.time;
    }
}

template <typename T>
template <RayStage kStage>
void CameraBatch<T>::send(RayBatch<T>& batch) {
    const CameraColumns& c = *columns_;
    const std::size_t count = batch.size();
    if constexpr (kStage == RayStage::kPinhole || kStage == RayStage::kTime) {
        fill_common(batch);
        loops_->through_pinhole(scene_->camera, c, batch.direction, count);
        batch.in_columns = true;
        if constexpr (kStage == RayStage::kTime) {
            for (std::size_t i = 0; i < count; ++i) {
                batch.time[i] = static_cast<T>(scene_->camera.time(sampler(i).draw(Draw::kTime).x));
            }
        }
    } else {
        for (std::size_t i = 0; i < count; ++i) {
            batch.rays[i] = camera_ray_as<kStage>(*scene_, sampler(i), c.x[i], c.y[i]);
        }
    }
}

template <typename T>
void CameraBatch<T>::begin_in_columns(std::size_t most, RayBatch<T>& batch, Counters& counters) {
    const std::size_t count = choose_samples(most);
    place_in_pixels();
    batch.begin(count);
    batch.end_stretch(Coherence::kCoherent);
    (this->*send_)(batch);
    count_draws(counters, scene_->plan.rays, count);
}

template class CameraBatch<float>;
template class CameraBatch<double>;

}  // namespace cobble::renderer
