// SPDX-License-Identifier: MIT
#include "renderer/integrator/single_tile.hpp"

#include <algorithm>

namespace cobble::renderer {

template <typename T>
SingleTile<T>::SingleTile(const ShadingScene<T>& scene, const Settings& settings, const Tile&)
    : scene_(&scene), settings_(&settings) {
    trace_.stack.reserve(deepest_stack(scene));
}

template <typename T>
bool SingleTile<T>::finish_sample(TileWork& work, StopCheck& stop) {
    const std::uint32_t x = work.tile.x(work.pixels_done);
    const std::uint32_t y = work.tile.y(work.pixels_done);
    const Sampler sampler(settings_->seed, x, y, sample_);
    if (trace_.done()) begin_sample(*scene_, *settings_, sampler, x, y, trace_);
    while (!trace_.done()) {
        if (stop(work.counters.box_tests + work.counters.primitive_tests)) return false;
        step(*scene_, sampler, trace_, work.counters);
    }
    if (!sums_.add(trace_.sample)) {
        work.report(bad_sample(*scene_->source, x, y, sample_, trace_.first_object));
    }
    ++sample_;
    ++work.samples_done;
    return true;
}

template <typename T>
bool SingleTile<T>::run(TileWork& work, Film& film, StopCheck& stop) {
    const std::uint32_t samples = std::max(settings_->samples, 1U);
    while (!work.done()) {
        while (sample_ < samples) {
            if (!finish_sample(work, stop)) return false;
        }
        film.set_pixel(work.tile.x(work.pixels_done), work.tile.y(work.pixels_done), sums_.pixel());
        sums_ = {};
        sample_ = 0;
        ++work.pixels_done;
    }
    return true;
}

template class SingleTile<float>;
template class SingleTile<double>;

}  // namespace cobble::renderer
