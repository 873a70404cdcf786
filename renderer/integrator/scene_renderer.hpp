// SPDX-License-Identifier: MIT
// Pixels as Cobble means them: every sample of a pixel traced in order, then the next pixel.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "ir/scene/scene.hpp"
#include "renderer/integrator/shading_scene.hpp"
#include "renderer/integrator/trace.hpp"
#include "renderer/settings.hpp"
#include "renderer/tile/tile_renderer.hpp"

namespace cobble::renderer {

/// Puts the first ray of sample `sample` of pixel (x, y) on the trace's stack, which is empty. A
/// pixel's only sample goes through its centre; of several, each falls where the filter says.
template <typename T>
void begin_sample(const ShadingScene<T>& scene, const Settings& settings, const Sampler& sampler,
                  std::uint32_t x, std::uint32_t y, SampleTrace<T>& trace);

template <typename T>
class SceneRenderer final : public TileRenderer {
  public:
    SceneRenderer(ShadingScene<T> scene, const Settings& settings);

    void render_tile(TileWork& work, Film& film, StopCheck& stop) const override;

    [[nodiscard]] const std::vector<PreparationNote>& notes() const override {
        return scene_.geometry.notes;
    }

    [[nodiscard]] const ShadingScene<T>& scene() const { return scene_; }

  private:
    struct State;

    /// One sample to its end and into the pixel; false if stopped before that.
    bool finish_sample(State& state, TileWork& work, StopCheck& stop) const;

    ShadingScene<T> scene_;
    Settings settings_;
};

}  // namespace cobble::renderer
