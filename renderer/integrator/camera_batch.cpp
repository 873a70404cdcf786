// SPDX-License-Identifier: MIT
#include "renderer/integrator/camera_batch.hpp"

#include <algorithm>

#include "renderer/sampling/mappings.hpp"

namespace cobble::renderer {

template <typename T>
CameraBatch<T>::CameraBatch(const ShadingScene<T>& scene, const Settings& settings,
                            const Tile& tile)
    : scene_(&scene),
      settings_(&settings),
      loops_(&column_loops<T>()),
      samples_(std::max(settings.samples, 1U)),
      simple_(!scene.effects.depth_of_field && !scene.effects.motion_blur),
      next_(tile),
      columns_(std::make_unique<CameraColumns<T>>()) {
    if (!simple_) return;
    // Origin and time are those of any ray.
    const Ray<T> any = camera_ray(scene, Sampler(0, 0, 0, 0), 0, 0).ray;
    rays_.fill(any);
}

/// Where begin_sample() lets the ray through.
template <typename T>
void CameraBatch<T>::place_in_pixels(std::size_t count) {
    CameraColumns<T>& c = *columns_;
    if (samples_ == 1) {
        for (std::size_t i = 0; i < count; ++i) {
            c.x[i] += 0.5;
            c.y[i] += 0.5;
        }
        return;
    }
    if (settings_->filter == PixelFilter::kBox) {
        loops_->place_in_pixel(c, count);
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const math::Vec2d offset =
            sample_filter(sobol_point(c.sample[i], c.set[i]), settings_->filter);
        c.x[i] = (c.x[i] + 0.5) + offset.x;
        c.y[i] = (c.y[i] + 0.5) + offset.y;
    }
}

template <typename T>
std::size_t CameraBatch<T>::begin(const Tile& tile, std::size_t most) {
    CameraColumns<T>& c = *columns_;
    most = std::min(most, kBatchSize);
    std::size_t count = 0;
    std::uint64_t set = 0;
    for (; count < most && !next_.at_end(tile); ++count) {
        const PixelPlace at = next_.place;
        if (samples_ > 1 && (count == 0 || next_.sample == 0)) {
            set = Sampler(settings_->seed, at.x, at.y, 0).set(Draw::kPixel, {}, 0);
        }
        places_[count] = at;
        c.sample[count] = next_.sample;
        c.set[count] = set;
        c.x[count] = at.x;
        c.y[count] = at.y;
        next_.advance(tile, samples_);
    }
    place_in_pixels(count);
    if (simple_) {
        loops_->through_pinhole(scene_->camera, c, count);
        for (std::size_t i = 0; i < count; ++i) rays_[i].direction = c.direction.at(i);
    } else {
        for (std::size_t i = 0; i < count; ++i) {
            rays_[i] = camera_ray(*scene_, sampler(i), c.x[i], c.y[i]).ray;
        }
    }
    return count;
}

template class CameraBatch<float>;
template class CameraBatch<double>;

}  // namespace cobble::renderer
