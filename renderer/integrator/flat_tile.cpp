// SPDX-License-Identifier: MIT
#include "renderer/integrator/flat_tile.hpp"

#include <algorithm>

namespace cobble::renderer {

template <typename T>
FlatTile<T>::FlatTile(const ShadingScene<T>& scene, const Settings& settings, const Tile& tile)
    : scene_(&scene),
      settings_(&settings),
      only_color_(color_tells_all(scene, settings)),
      camera_(scene, settings, tile),
      batch_(scene) {}

template <typename T>
bool FlatTile<T>::run(TileWork& work, Film& film, StopCheck& stop) {
    const auto draw = [this](std::size_t lane, std::uint32_t light) {
        return camera_.sampler(lane).draw(Draw::kLight, PathAddress{}, light);
    };
    while (!work.done()) {
        if (stop.now()) return false;
        if (!on_its_way_) {
            begin(work);
        } else if (batch_.step(work.counters, draw)) {
            land(work, film);
        }
    }
    return true;
}

template <typename T>
void FlatTile<T>::begin(TileWork& work) {
    RayBatch<T>& rays = batch_.rays();
    camera_.begin(work.tile, kBatchSize, rays);
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
void FlatTile<T>::add_one_by_one(TileWork& work, std::size_t first, std::size_t end) {
    for (std::size_t lane = first; lane < end; ++lane) {
        if (add(lane)) continue;
        const PixelPlace at = camera_.place(lane);
        work.report(
            bad_sample(*scene_->source, at.x, at.y, camera_.sample(lane), batch_.hit(lane).object));
    }
}

template <typename T>
void FlatTile<T>::land(TileWork& work, Film& film) {
    const std::size_t count = batch_.rays().size();
    const std::uint32_t samples = std::max(settings_->samples, 1U);
    const Columns3<T>& colors = batch_.colors();
    const bool together = only_color_ && batch_.shading().finite_colors(colors, count);
    for (std::size_t lane = 0; lane < count;) {
        const std::uint32_t first = camera_.sample(lane);
        const auto of_pixel =
            static_cast<std::uint32_t>(std::min<std::size_t>(count - lane, samples - first));
        if (together) {
            sums_.add_colors(colors.x + lane, colors.y + lane, colors.z + lane, of_pixel);
        } else {
            add_one_by_one(work, lane, lane + of_pixel);
        }
        if (first + of_pixel == samples) {
            const PixelPlace at = camera_.place(lane);
            film.set_pixel(at.x, at.y, sums_.pixel());
            sums_ = {};
            ++work.pixels_done;
        }
        lane += of_pixel;
    }
    work.samples_done += count;
    on_its_way_ = false;
}

template class FlatTile<float>;
template class FlatTile<double>;

}  // namespace cobble::renderer
