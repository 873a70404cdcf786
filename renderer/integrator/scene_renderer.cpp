// SPDX-License-Identifier: MIT
#include "renderer/integrator/scene_renderer.hpp"

#include <algorithm>
#include <utility>

#include "renderer/sampling/mappings.hpp"

namespace cobble::renderer {

template <typename T>
void begin_sample(const ShadingScene<T>& scene, const Settings& settings, const Sampler& sampler,
                  std::uint32_t x, std::uint32_t y, SampleTrace<T>& trace) {
    math::Vec2d at{x + 0.5, y + 0.5};
    if (settings.samples > 1) {
        const math::Vec2d offset = sample_filter(sampler.draw(Draw::kPixel), settings.filter);
        at.x += offset.x;
        at.y += offset.y;
    }
    trace.sample = {};
    trace.first_object = {};
    trace.stack.push_back(camera_ray(scene, sampler, at.x, at.y));
}

template <typename T>
struct SceneRenderer<T>::State final : PausedPixel {
    PixelAccumulator sums;
    SampleTrace<T> trace;
    std::uint32_t sample = 0;  ///< the one on the trace, or the next one
};

template <typename T>
SceneRenderer<T>::SceneRenderer(ShadingScene<T> scene, const Settings& settings)
    : scene_(std::move(scene)), settings_(settings) {}

template <typename T>
bool SceneRenderer<T>::finish_sample(State& state, TileWork& work, StopCheck& stop) const {
    const std::uint32_t x = work.tile.x(work.next_pixel);
    const std::uint32_t y = work.tile.y(work.next_pixel);
    const Sampler sampler(settings_.seed, x, y, state.sample);
    SampleTrace<T>& trace = state.trace;
    if (trace.stack.empty()) begin_sample(scene_, settings_, sampler, x, y, trace);
    while (!trace.stack.empty()) {
        if (stop(work.counters.box_tests + work.counters.primitive_tests)) return false;
        step(scene_, sampler, trace, work.counters);
    }
    if (!state.sums.add(trace.sample)) {
        BadSample bad;
        bad.x = x;
        bad.y = y;
        bad.sample = state.sample;
        if (trace.first_object.valid()) {
            bad.span = scene_.source->objects[trace.first_object.value].span;
        }
        work.report(bad);
    }
    ++state.sample;
    ++work.samples_done;
    return true;
}

template <typename T>
void SceneRenderer<T>::render_tile(TileWork& work, Film& film, StopCheck& stop) const {
    if (work.paused == nullptr) {
        auto fresh = std::make_unique<State>();
        // Each ray taken off the stack puts at most two on it, one turn deeper.
        fresh->trace.stack.reserve(scene_.bounces + std::size_t{2});
        work.paused = std::move(fresh);
    }
    State& state = static_cast<State&>(*work.paused);
    const std::uint32_t samples = std::max(settings_.samples, 1U);
    while (!work.done()) {
        while (state.sample < samples) {
            if (!finish_sample(state, work, stop)) return;
        }
        film.set_pixel(work.tile.x(work.next_pixel), work.tile.y(work.next_pixel),
                       state.sums.pixel());
        state.sums = {};
        state.sample = 0;
        ++work.next_pixel;
    }
    work.paused.reset();
}

template void begin_sample(const ShadingScene<float>&, const Settings&, const Sampler&,
                           std::uint32_t, std::uint32_t, SampleTrace<float>&);
template void begin_sample(const ShadingScene<double>&, const Settings&, const Sampler&,
                           std::uint32_t, std::uint32_t, SampleTrace<double>&);
template class SceneRenderer<float>;
template class SceneRenderer<double>;

}  // namespace cobble::renderer
