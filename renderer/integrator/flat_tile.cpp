// SPDX-License-Identifier: MIT
#include "renderer/integrator/flat_tile.hpp"

#include <algorithm>

namespace cobble::renderer {

template <typename T>
FlatTile<T>::FlatTile(const ShadingScene<T>& scene, const Settings& settings, const TileWork& work)
    : scene_(&scene),
      samples_(work.pass.count),
      most_(samples_ > kBatchSize ? kBatchSize : kBatchSize - kBatchSize % samples_),
      only_color_(color_tells_all(scene, settings)),
      camera_(scene, settings, work.pass, work.tile),
      batch_(scene),
      loops_(&column_loops<T>()),
      pixel_sums_{} {}

template <typename T>
bool FlatTile<T>::run(TileWork& work, Film& film, StopCheck& stop) {
    const auto draw = [this](std::size_t lane, std::uint32_t light, std::uint32_t number) {
        return camera_.sampler(lane).draw(Draw::kLight, PathAddress{}, light, number,
                                          scene_->lights[light].samples);
    };
    while (!work.done()) {
        if (stop.between_stages(work.counters.tests())) return false;
        if (!on_its_way_) {
            begin(work);
        } else if (batch_.step(work, draw)) {
            land(work, film);
        }
    }
    return true;
}

template <typename T>
void FlatTile<T>::begin(TileWork& work) {
    work.clock.enter(TimedStage::kCamera);
    RayBatch<T>& rays = batch_.rays();
    camera_.begin_in_columns(most_, rays, work.counters);
    work.counters.camera_rays += rays.size();
    batch_.begin();
    on_its_way_ = true;
}

template <typename T>
bool FlatTile<T>::add(std::size_t lane) {
    // As bring_back() adds it: a sum begins with 0.
    Sample sample;
    sample.color += batch_.colors().at(lane).template to<double>();
    if (only_color_) return sums_.add_color(sample.color);
    see_first(sample, batch_.shading().encounter(lane));
    return sums_.add(sample);
}

template <typename T>
void FlatTile<T>::land_together(TileWork& work, Film& film) {
    const std::size_t pixels = batch_.rays().size() / samples_;
    loops_->sum_pixels(batch_.colors(), samples_, pixels, pixel_sums_);
    const auto& [sum, rest] = pixel_sums_;
    for (std::size_t i = 0; i < pixels; ++i) {
        const CompensatedSum3 color({sum.x[i], rest.x[i]}, {sum.y[i], rest.y[i]},
                                    {sum.z[i], rest.z[i]});
        const PixelPlace at = camera_.place(i * samples_);
        film.set_color(at.x, at.y, color.value() / static_cast<double>(samples_), samples_);
    }
    work.end_pixels(pixels);
}

template <typename T>
void FlatTile<T>::land_one_by_one(TileWork& work, Film& film) {
    for (std::size_t lane = 0; lane < batch_.rays().size(); ++lane) {
        const PixelPlace at = camera_.place(lane);
        if (!add(lane)) {
            work.report(bad_sample(*scene_->source, at.x, at.y, camera_.sample(lane),
                                   batch_.hit(lane).object));
        }
        if (camera_.sample(lane) + 1 < work.pass.first + samples_) continue;
        film.set_pixel(at.x, at.y, sums_.pixel());
        sums_ = {};
        work.end_pixels();
    }
}

template <typename T>
void FlatTile<T>::land(TileWork& work, Film& film) {
    work.clock.enter(TimedStage::kPixels);
    const std::size_t count = batch_.rays().size();
    if (only_color_ && samples_ <= kBatchSize && loops_->all_finite(batch_.colors(), count)) {
        land_together(work, film);
    } else {
        land_one_by_one(work, film);
    }
    work.samples_done += count;
    on_its_way_ = false;
}

template class FlatTile<float>;
template class FlatTile<double>;

}  // namespace cobble::renderer
