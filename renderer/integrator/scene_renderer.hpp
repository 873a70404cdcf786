// SPDX-License-Identifier: MIT
// Pixels as Cobble means them, in batches on the fast core or one ray at a time on the reference:
// the same bits.
#pragma once

#include <vector>

#include "renderer/integrator/shading_scene.hpp"
#include "renderer/settings.hpp"
#include "renderer/tile/tile_renderer.hpp"

namespace cobble::renderer {

/// In batches with Acceleration::kFast.
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
    template <typename Way>
    void go_on(TileWork& work, Film& film, StopCheck& stop) const;

    ShadingScene<T> scene_;
    Settings settings_;
};

}  // namespace cobble::renderer
