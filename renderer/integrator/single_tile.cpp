// SPDX-License-Identifier: MIT
#include "renderer/integrator/single_tile.hpp"

namespace cobble::renderer {

template <typename T>
SingleTile<T>::SingleTile(const ShadingScene<T>& scene, const Settings& settings,
                          const TileWork& work)
    : scene_(&scene), filter_(settings.filter), next_(work.pass, work.tile) {
    trace_.stack.reserve(deepest_stack(scene));
}

template <typename T>
bool SingleTile<T>::finish_sample(TileWork& work, StopCheck& stop) {
    const auto [x, y] = next_.place();
    const Sampler sampler(work.pass, x, y, next_.sample());
    if (trace_.done()) {
        begin_sample(*scene_, filter_, work.pass.centred, sampler, x, y, trace_, work.counters);
    }
    while (!trace_.done()) {
        if (stop(work.counters.box_tests + work.counters.primitive_tests)) return false;
        step(*scene_, sampler, trace_, work.counters);
    }
    if (!sums_.add(trace_.sample)) {
        work.report(bad_sample(*scene_->source, x, y, next_.sample(), trace_.first_object));
    }
    ++work.samples_done;
    return true;
}

template <typename T>
bool SingleTile<T>::run(TileWork& work, Film& film, StopCheck& stop) {
    while (!work.done()) {
        const PixelPlace at = next_.place();
        if (!finish_sample(work, stop)) return false;
        if (!next_.advance()) continue;
        film.set_pixel(at.x, at.y, sums_.pixel());
        sums_ = {};
        work.end_pixels();
    }
    return true;
}

template class SingleTile<float>;
template class SingleTile<double>;

}  // namespace cobble::renderer
