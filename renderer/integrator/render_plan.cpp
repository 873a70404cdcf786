// SPDX-License-Identifier: MIT
#include "renderer/integrator/render_plan.hpp"

#include <algorithm>
#include <set>

#include "renderer/integrator/prepared_material.hpp"
#include "renderer/shading/phong.hpp"

namespace cobble::renderer {
namespace {

template <typename T>
class Planner {
  public:
    Planner(const ir::Scene& scene, const Settings& settings,
            std::span<const PreparedMaterial<T>> materials)
        : scene_(scene), materials_(materials), general_(settings.general_stages) {
        plan_.effects = ActiveEffects(settings.effects);
        plan_.bounces = std::min(settings.bounces, kMostBounces);
        plan_.general = general_;
        plan_.single = sizeof(T) == sizeof(float);
        batches_ = settings.acceleration == Acceleration::kFast;
        find_used();
    }

    RenderPlan run() {
        rays();
        surfaces();
        lights();
        scatter();
        const bool sky = plan_.effects.environment() && scene_.background.cube_map.valid();
        plan_.miss = sky || general_ ? MissStage::kCubeMap : MissStage::kColor;
        plan_.tracing = !batches_                              ? Tracing::kRayByRay
                        : plan_.scatter == ScatterStage::kNone ? Tracing::kStraight
                                                               : Tracing::kInTurns;
        columns();
        pictures(sky);
        return std::move(plan_);
    }

  private:
    /// Objects may be millions, and materials are few.
    void find_used() {
        used_.assign(materials_.size(), false);
        for (const ir::Object& object : scene_.objects) {
            const std::size_t of = object.material.valid() ? object.material.value : used_.size();
            const std::size_t material = std::min(of, used_.size() - 1);
            used_[material] = true;
            one_by_one_ =
                one_by_one_ || !materials_[material].plain() || !is_plain_shape(scene_, object);
        }
    }

    template <typename Test>
    [[nodiscard]] bool any_used(Test&& test) const {
        for (std::size_t i = 0; i < materials_.size(); ++i) {
            if (used_[i] && test(materials_[i])) return true;
        }
        return false;
    }

    void rays() {
        const bool lens = plan_.effects.depth_of_field() || general_;
        const bool time = plan_.effects.motion_blur() || general_;
        plan_.rays = lens ? (time ? RayStage::kLensAndTime : RayStage::kLens)
                          : (time ? RayStage::kTime : RayStage::kPinhole);
    }

    void surfaces() {
        for (std::size_t i = 0; i + 1 < materials_.size(); ++i) {
            plan_.reads_uv = plan_.reads_uv || (used_[i] && materials_[i].reads_uv());
        }
        const auto pictures = [](const auto& m) { return m.texture != nullptr || m.error_checker; };
        const auto noise = [](const auto& m) { return m.noise != nullptr; };
        const auto bends = [](const auto& m) { return m.bends(); };
        if (any_used(pictures)) plan_.surface |= kSurfacePictures;
        if (any_used(noise)) plan_.surface |= kSurfaceNoise;
        if (any_used(bends)) plan_.surface |= kSurfaceBent;
        if (general_) plan_.surface = kAnySurface;
    }

    void lights() {
        for (const ir::Light& light : scene_.lights) {
            const bool sized = light.radius > 0 || light.angle > 0;
            plan_.lights.push_back((plan_.effects.soft_shadows() && sized) || general_
                                       ? LightStage::kArea
                                       : LightStage::kMiddle);
        }
        const bool lit = !scene_.lights.empty();
        plan_.shadows = plan_.effects.shadows() && lit;
        plan_.highlights = plan_.effects.highlights() && lit && any_used([](const auto& m) {
                               return has_highlight(m.specular, m.shininess);
                           });
    }

    void scatter() {
        const bool goes_on = any_used([](const auto& m) { return m.sends_on; });
        const bool through =
            any_used([](const auto& m) { return m.sends_on && m.refraction_index > T(0); });
        const bool reflects = goes_on && plan_.effects.reflection();
        const bool refracts = through && plan_.effects.refraction();
        plan_.scatter = (reflects && refracts) || general_ ? ScatterStage::kReflectAndRefract
                        : reflects                         ? ScatterStage::kReflect
                        : refracts                         ? ScatterStage::kRefract
                                                           : ScatterStage::kNone;
    }

    void columns() {
        if (!batches_) return;
        const auto need = [this](ColumnGroup group, bool needed) {
            plan_.needed[static_cast<std::size_t>(group)] = needed || general_;
        };
        need(ColumnGroup::kRays, true);
        need(ColumnGroup::kSurfaces, true);
        need(ColumnGroup::kOneByOne, one_by_one_);
        need(ColumnGroup::kLight, !plan_.lights.empty());
        need(ColumnGroup::kShadowRays, plan_.shadows);
        need(ColumnGroup::kHighlights, plan_.highlights);
        need(ColumnGroup::kScatter, plan_.scatter != ScatterStage::kNone);
        need(ColumnGroup::kReflected, plan_.reflects());
        need(ColumnGroup::kRefracted, plan_.refracts());
    }

    [[nodiscard]] std::uint64_t bytes_of_images(const std::set<const ir::Image*>& images) const {
        std::uint64_t bytes = 0;
        for (const ir::Image* image : images) {
            bytes += image->bytes.size() + image->floats.size() * sizeof(float);
        }
        return bytes;
    }

    void pictures(bool sky) {
        std::set<const ir::Image*> textures, maps, surroundings;
        const auto around = [&](const ir::CubeMap& map) {
            for (const ir::ImageId face : map.faces) {
                if (face.valid()) surroundings.insert(&scene_.images[face.value]);
            }
        };
        for (std::size_t i = 0; i < materials_.size(); ++i) {
            if (!used_[i]) continue;
            const PreparedMaterial<T>& m = materials_[i];
            if (m.texture != nullptr) textures.insert(m.texture);
            if (m.normal_map != nullptr) maps.insert(m.normal_map);
            if (m.bump_map != nullptr) maps.insert(m.bump_map);
            if (m.cube_map != nullptr) around(*m.cube_map);
        }
        if (sky) around(scene_.cube_maps[scene_.background.cube_map.value]);
        plan_.pictures = {
            {"textures", bytes_of_images(textures), "textures are off, or nothing has one"},
            {"normal maps", bytes_of_images(maps), "normal-maps are off, or nothing has one"},
            {"cube maps", bytes_of_images(surroundings), "environment is off, or there is none"}};
    }

    const ir::Scene& scene_;
    std::span<const PreparedMaterial<T>> materials_;
    bool general_;
    bool batches_ = true;
    std::vector<bool> used_;  ///< by material: some object is made of it
    bool one_by_one_ = false;
    RenderPlan plan_;
};

template <typename T>
RenderPlan plan_in(const ir::Scene& scene, const Settings& settings) {
    const auto materials = prepare_materials<T>(scene, ActiveEffects(settings.effects),
                                                settings.texture_filter, settings.bounces);
    return make_plan<T>(scene, settings, materials);
}

}  // namespace

template <typename T>
RenderPlan make_plan(const ir::Scene& scene, const Settings& settings,
                     std::span<const PreparedMaterial<T>> materials) {
    return Planner<T>(scene, settings, materials).run();
}

template RenderPlan make_plan(const ir::Scene&, const Settings&,
                              std::span<const PreparedMaterial<float>>);
template RenderPlan make_plan(const ir::Scene&, const Settings&,
                              std::span<const PreparedMaterial<double>>);

RenderPlan plan_render(const ir::Scene& scene, const Settings& settings) {
    return settings.precision == Precision::kDouble ? plan_in<double>(scene, settings)
                                                    : plan_in<float>(scene, settings);
}

}  // namespace cobble::renderer
