// SPDX-License-Identifier: MIT
#include "renderer/integrator/scene_renderer.hpp"

#include <memory>
#include <utility>

#include "renderer/integrator/batched_tile.hpp"
#include "renderer/integrator/flat_tile.hpp"
#include "renderer/integrator/single_tile.hpp"

namespace cobble::renderer {

template <typename T>
SceneRenderer<T>::SceneRenderer(ShadingScene<T> scene, const Settings& settings)
    : scene_(std::move(scene)), settings_(settings) {}

template <typename T>
template <typename Way>
void SceneRenderer<T>::go_on(TileWork& work, Film& film, StopCheck& stop) const {
    if (work.done()) return;
    if (work.paused == nullptr) work.paused = std::make_unique<Way>(scene_, settings_, work);
    if (static_cast<Way&>(*work.paused).run(work, film, stop)) work.paused.reset();
}

template <typename T>
void SceneRenderer<T>::render_tile(TileWork& work, Film& film, StopCheck& stop) const {
    switch (scene_.plan.tracing) {
        case Tracing::kRayByRay:
            work.clock.enter(TimedStage::kRayByRay);
            return go_on<SingleTile<T>>(work, film, stop);
        case Tracing::kStraight:
            return go_on<FlatTile<T>>(work, film, stop);
        case Tracing::kInTurns:
            return go_on<BatchedTile<T>>(work, film, stop);
    }
}

template class SceneRenderer<float>;
template class SceneRenderer<double>;

}  // namespace cobble::renderer
