// SPDX-License-Identifier: MIT
// A batch from its rays to its colours, stage by stage: between any two it can be put down.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "renderer/integrator/batch_shading.hpp"
#include "renderer/integrator/ray_batch.hpp"
#include "renderer/integrator/seams.hpp"
#include "renderer/tile/tile_renderer.hpp"

namespace cobble::renderer {

template <typename T>
class BatchStages {
  public:
    explicit BatchStages(const ShadingScene<T>& scene) : scene_(&scene), shading_(scene) {}

    /// The rays of a new batch; then begin().
    [[nodiscard]] RayBatch<T>& rays() { return rays_; }
    void begin() { stage_ = Stage::kMeet; }

    /// Goes one stage on; true once the colours are known. Draws for question `number` to light
    /// `light` at what the ray at a place of the batch met come from `draw(place, light, number)`.
    template <typename Draws>
    bool step(TileWork& work, const Draws& draw) {
        Counters& counters = work.counters;
        switch (stage_) {
            case Stage::kMeet:
                work.clock.enter(TimedStage::kHits);
                if (pace_.closest<T>(scene_->geometry, rays_, hits_, counters)) {
                    stage_ = Stage::kLook;
                }
                break;
            case Stage::kLook:
                work.clock.enter(TimedStage::kSurfaces);
                if (!scene_->touching.empty()) {
                    for (std::size_t i = 0; i < rays_.size(); ++i) {
                        cross_seams(*scene_, rays_.ray(i), hits_[i]);
                    }
                }
                shading_.look(rays_, std::span<const Hit<T>>(hits_).first(rays_.size()), counters);
                light_ = number_ = 0;
                stage_ =
                    shading_.any_lit() && !scene_->lights.empty() ? Stage::kAsk : Stage::kColor;
                break;
            case Stage::kAsk:
                work.clock.enter(TimedStage::kLights);
                shading_.ask(
                    light_, [&](std::size_t place) { return draw(place, light_, number_); },
                    counters);
                if (shading_.shadow() == nullptr) {
                    next_sample();
                    break;
                }
                counters.shadow_rays += shading_.shadow()->rays.size();
                stage_ = Stage::kShadow;
                break;
            case Stage::kShadow:
                work.clock.enter(TimedStage::kShadows);
                if (!pace_.any<T>(scene_->geometry, shading_.shadow()->rays,
                                  shading_.shadow()->hidden_by, counters)) {
                    break;
                }
                work.clock.enter(TimedStage::kLights);
                shading_.add_unhidden();
                next_sample();
                break;
            case Stage::kColor:
                work.clock.enter(TimedStage::kColors);
                shading_.color(colors_, counters);
                return true;
        }
        return false;
    }

    // Of the batch, by place in it; once step() said so.
    [[nodiscard]] const Hit<T>& hit(std::size_t place) const { return hits_[place]; }
    [[nodiscard]] const Columns3<T>& colors() const { return colors_; }
    [[nodiscard]] BatchShading<T>& shading() { return shading_; }

  private:
    enum class Stage : std::uint8_t { kMeet, kLook, kAsk, kShadow, kColor };

    /// Of the light, or the first one of the next light.
    void next_sample() {
        if (++number_ == scene_->lights[light_].samples) {
            number_ = 0;
            ++light_;
        }
        stage_ = light_ < scene_->lights.size() ? Stage::kAsk : Stage::kColor;
    }

    const ShadingScene<T>* scene_;
    Stage stage_ = Stage::kMeet;
    std::uint32_t light_ = 0;
    std::uint32_t number_ = 0;  ///< of the questions to it
    RayBatch<T> rays_;
    Pace pace_;
    std::array<Hit<T>, kBatchSize> hits_;
    BatchShading<T> shading_;
    Columns3<T> colors_;
};

}  // namespace cobble::renderer
