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
      columns_(std::make_unique<CameraColumns<T>>()) {}

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
std::size_t CameraBatch<T>::choose(const Tile& tile, std::size_t most) {
    CameraColumns<T>& c = *columns_;
    most = std::min(most, kBatchSize);
    std::size_t count = 0;
    while (count < most && !next_.at_end(tile)) {
        const PixelPlace at = next_.place;
        const std::uint64_t set =
            samples_ > 1 ? Sampler(settings_->seed, at.x, at.y, 0).set(Draw::kPixel, {}, 0) : 0;
        const std::uint32_t first = next_.sample;
        const auto of_pixel =
            static_cast<std::uint32_t>(std::min<std::size_t>(most - count, samples_ - first));
        for (std::uint32_t i = 0; i < of_pixel; ++i) {
            places_[count + i] = at;
            c.sample[count + i] = first + i;
            c.set[count + i] = set;
            c.x[count + i] = at.x;
            c.y[count + i] = at.y;
        }
        count += of_pixel;
        next_.advance(tile, samples_, of_pixel);
    }
    return count;
}

template <typename T>
void CameraBatch<T>::begin(const Tile& tile, std::size_t most, RayBatch<T>& batch) {
    const std::size_t count = choose(tile, most);
    CameraColumns<T>& c = *columns_;
    place_in_pixels(count);
    batch.begin(count);
    batch.end_stretch(Coherence::kCoherent);
    if (simple_) {
        // Origin and time are those of any ray.
        if (first_) batch.rays.fill(camera_ray(*scene_, Sampler(0, 0, 0, 0), 0, 0).ray);
        first_ = false;
        loops_->through_pinhole(scene_->camera, c, count);
        for (std::size_t i = 0; i < count; ++i) batch.rays[i].direction = c.direction.at(i);
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        batch.rays[i] = camera_ray(*scene_, sampler(i), c.x[i], c.y[i]).ray;
    }
}

template class CameraBatch<float>;
template class CameraBatch<double>;

}  // namespace cobble::renderer
