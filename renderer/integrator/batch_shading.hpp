// SPDX-License-Identifier: MIT
// From the hits of a batch of rays to their colours: the stages of stages.hpp for many rays at
// once. Surfaces at rest, of plain materials, go through loops over columns; whatever else there is
// goes through stages.hpp one by one, and joins them before the lights. Which form of a stage a
// batch takes was chosen once, by the plan of the render.
//
//   look, then for each light ask, the shadow rays, and add_unhidden, then color
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "renderer/integrator/batch_columns.hpp"
#include "renderer/integrator/column_loops.hpp"
#include "renderer/integrator/columns.hpp"
#include "renderer/integrator/met_surfaces.hpp"
#include "renderer/integrator/pending_rays.hpp"
#include "renderer/integrator/ray_batch.hpp"
#include "renderer/integrator/shading_scene.hpp"
#include "renderer/integrator/stages.hpp"

namespace cobble::renderer {

/// Whether nothing of a sample but its colour is wanted, nor can be unsound by itself. In single
/// precision no normal is unsound but one that a map bends, and a colour of the surface that is no
/// number makes all that it reflects none.
template <typename T>
bool color_tells_all(const ShadingScene<T>& scene, const Settings& settings);

/// Memory: columns_of() the scene's plan.
template <typename T>
class BatchShading {
  public:
    /// The scene must outlive this.
    explicit BatchShading(const ShadingScene<T>& scene);

    /// `hits` are closest_hit()'s answers to the rays of `batch`; both must stay as they are until
    /// the colours are known.
    void look(const RayBatch<T>& batch, std::span<const Hit<T>> hits, Counters& counters);
    [[nodiscard]] bool any_lit() const { return lit_ > 0; }

    /// What light `light` sends to each surface, and the rays that ask whether it arrives, in the
    /// order of the batch; where nothing can be in its way it is added at once. Draws for a light
    /// with a size come from `draw(ray's place in the batch)`.
    template <typename Draws>
    void ask(std::uint32_t light, const Draws& draw, Counters& counters) {
        const PreparedLight& source = scene_->lights[light];
        if (has_area(light)) {
            counters.light_draws += lit_;
            for (std::size_t i = 0; i < lit_; ++i) {
                set_sample(i, light_sample(source, hits_->position.at(i), draw(lane_[i])));
            }
        } else {
            sent_by_middle(source);
        }
        (this->*forms_of_.send)(source, counters);
    }
    /// The rays of the last ask(), and the place for any_hits()' answers to them; null if the plan
    /// has none: then all light has been added.
    ShadowRays<T>* shadow() { return shadow_.get(); }
    /// Of the answers.
    void add_unhidden();

    /// What each ray brings back by itself, by its place in the batch.
    void color(Columns3<T>& colors, Counters& counters) {
        (this->*forms_of_.color)(colors, counters);
    }
    /// What ray `lane` met, in full but for texture coordinates that nobody read.
    [[nodiscard]] Encounter<T> encounter(std::size_t lane) const;

    /// What scatter() sends on from each surface; `carried` by the ray's place in the batch. False
    /// if nothing is.
    bool scatter(const Carried<T>* carried);
    /// Appends those of the batch's children of a kind that matter, none if its effect is off;
    /// there must be room for all and one more. After a scatter() that said true.
    void append_children(RayKind kind, const Carried<T>* carried, PendingRays<T>& to) const;

  private:
    [[nodiscard]] std::size_t slot_of_entry(std::int32_t entry) const {
        return static_cast<std::size_t>(hits_->slot[entry]);
    }
    /// In the columns, in the order of the forms.
    using FormBegins = std::array<std::size_t, kSurfaceForms + 1>;
    /// The forms of stages that the plan has chosen.
    struct Forms {
        void (BatchShading::*look_at_others)(std::size_t first, std::size_t end,
                                             Counters& counters) = nullptr;
        void (BatchShading::*send)(const PreparedLight& light, Counters& counters) = nullptr;
        void (BatchShading::*color)(Columns3<T>& colors, Counters& counters) = nullptr;
        typename ColumnLoops<T>::Scatter scatter = nullptr;
        typename ColumnLoops<T>::Scatter scatter_with_glass = nullptr;
    };
    static Forms choose(const RenderPlan& plan, const ColumnLoops<T>& loops);

    [[nodiscard]] bool has_area(std::uint32_t light) const;
    void place(std::size_t lane, std::size_t slot, std::size_t entry);
    std::uint32_t place_in_order();
    FormBegins place_by_form();
    void find_rays();
    void compute(SurfaceForm form, std::size_t first, std::size_t end, Counters& counters);
    template <SurfaceStage kStage>
    void look_at_others(std::size_t first, std::size_t end, Counters& counters);
    void set_sample(std::size_t entry, const LightSample<T>& sample);
    void sent_by_middle(const PreparedLight& light);
    template <bool kShadows, bool kHighlights, bool kBent>
    void send(const PreparedLight& light, Counters& counters);
    void add_highlights(Counters& counters);
    void leave_out_below_bent();
    template <bool kReflected>
    void append(const Carried<T>* carried, PendingRays<T>& to) const;
    template <MissStage kStage>
    void color_as(Columns3<T>& colors, Counters& counters);
    void begin_shadow_rays();

    const ShadingScene<T>* scene_;
    const RenderPlan* plan_;
    const ColumnLoops<T>* loops_;
    Forms forms_of_;
    const RayBatch<T>* batch_ = nullptr;
    std::span<const Hit<T>> given_;

    // By place in the batch.
    std::array<std::int32_t, kBatchSize> entry_{};  ///< in the columns; -1: met nothing

    MetSurfaces<T> met_;

    // By entry in the columns: those that are lit first.
    std::unique_ptr<SurfaceForms<T>> forms_;
    std::unique_ptr<HitColumns<T>> hits_;
    std::unique_ptr<LightColumns<T>> light_;
    std::unique_ptr<ShadowRays<T>> shadow_;
    std::unique_ptr<Columns3<T>> mirrored_;  ///< rays at surfaces with a highlight
    std::unique_ptr<ScatterColumns<T>> on_;
    std::unique_ptr<ChildColumns<T>> reflected_, refracted_;
    std::array<std::uint32_t, kBatchSize> lane_{};
    std::size_t lit_ = 0;
    std::size_t first_other_ = 0;
    std::size_t count_ = 0;
    bool sorted_as_given_ = false;  ///< entries are in the order of their rays
    bool in_order_ = false;         ///< each entry at its ray's place in the batch
    /// The rays of the hits.
    const Columns3<T>* from_ = nullptr;
    const Columns3<T>* direction_ = nullptr;
    Columns3<T> own_from_, own_direction_;
    std::vector<Encounter<T>> others_;  ///< from first_other_ on
};

}  // namespace cobble::renderer
