// SPDX-License-Identifier: MIT
#include "renderer/integrator/batch_shading.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>

#include "renderer/shading/fresnel.hpp"
#include "renderer/shading/phong.hpp"

namespace cobble::renderer {

template <typename T>
bool color_tells_all(const ShadingScene<T>& scene, const Settings& settings) {
    return sizeof(T) == sizeof(float) && !scene.effects.normal_maps() && !settings.want_depth &&
           !settings.want_normals && !settings.want_albedo;
}

template <typename T>
BatchShading<T>::BatchShading(const ShadingScene<T>& scene)
    : scene_(&scene),
      plan_(&scene.plan),
      loops_(&column_loops<T>()),
      forms_of_(choose(scene.plan, *loops_)),
      met_(scene),
      forms_(std::make_unique<SurfaceForms<T>>()),
      hits_(std::make_unique<HitColumns<T>>()),
      light_(columns_if_needed<LightColumns<T>>(scene.plan, ColumnGroup::kLight)),
      shadow_(columns_if_needed<ShadowRays<T>>(scene.plan, ColumnGroup::kShadowRays)),
      mirrored_(columns_if_needed<Columns3<T>>(scene.plan, ColumnGroup::kHighlights)),
      on_(columns_if_needed<ScatterColumns<T>>(scene.plan, ColumnGroup::kScatter)),
      reflected_(columns_if_needed<ChildColumns<T>>(scene.plan, ColumnGroup::kReflected)),
      refracted_(columns_if_needed<ChildColumns<T>>(scene.plan, ColumnGroup::kRefracted)) {
    if (scene.plan.needs(ColumnGroup::kOneByOne)) others_.reserve(kBatchSize);
}

template <typename T>
auto BatchShading<T>::choose(const RenderPlan& plan, const ColumnLoops<T>& loops) -> Forms {
    using ir::Effect;
    Forms forms;
    forms.look_at_others = [&]<std::size_t... kStages>(std::index_sequence<kStages...>) {
        constexpr decltype(forms.look_at_others) kLooks[] = {
            &BatchShading::look_at_others<SurfaceStage{kStages}>...};
        return kLooks[plan.surface];
    }
    (std::make_index_sequence<kAnySurface + 1>{});
    forms.color = &BatchShading::color_as<MissStage::kColor>;
    if (compiled_in(Effect::kEnvironment) && plan.miss == MissStage::kCubeMap) {
        forms.color = &BatchShading::color_as<MissStage::kCubeMap>;
    }
    const bool shadows = compiled_in(Effect::kShadows) && plan.shadows;
    const bool highlights = compiled_in(Effect::kHighlights) && plan.highlights;
    const bool bent = compiled_in(Effect::kNormalMaps) && (plan.surface & kSurfaceBent) != 0;
    if (shadows && highlights) {
        forms.send =
            bent ? &BatchShading::send<true, true, true> : &BatchShading::send<true, true, false>;
    } else if (shadows) {
        forms.send =
            bent ? &BatchShading::send<true, false, true> : &BatchShading::send<true, false, false>;
    } else if (highlights) {
        forms.send =
            bent ? &BatchShading::send<false, true, true> : &BatchShading::send<false, true, false>;
    } else {
        forms.send = bent ? &BatchShading::send<false, false, true>
                          : &BatchShading::send<false, false, false>;
    }
    switch (plan.scatter) {
        case ScatterStage::kNone:
            break;
        case ScatterStage::kReflect:
            forms.scatter = loops.scatter_mirror;
            forms.scatter_with_glass = loops.scatter_off_glass;
            break;
        case ScatterStage::kRefract:
            forms.scatter = forms.scatter_with_glass = loops.scatter_through_glass;
            break;
        case ScatterStage::kReflectAndRefract:
            forms.scatter = plan.general ? loops.scatter_glass : loops.scatter_mirror;
            forms.scatter_with_glass = loops.scatter_glass;
            break;
    }
    return forms;
}

template <typename T>
bool BatchShading<T>::has_area(std::uint32_t light) const {
    return compiled_in(ir::Effect::kSoftShadows) && plan_->lights[light] == LightStage::kArea;
}

template <typename T>
void BatchShading<T>::place(std::size_t lane, std::size_t slot, std::size_t entry) {
    const Hit<T>& hit = given_[lane];
    entry_[lane] = static_cast<std::int32_t>(entry);
    lane_[entry] = static_cast<std::uint32_t>(lane);
    hits_->slot[entry] = static_cast<std::int32_t>(slot);
    hits_->t[entry] = hit.t;
    hits_->u[entry] = hit.u;
    hits_->v[entry] = hit.v;
}

/// Hits in the order of the batch; the answer has a bit for each form among them.
template <typename T>
std::uint32_t BatchShading<T>::place_in_order() {
    std::size_t entry = 0;
    for (std::size_t lane = 0; lane < given_.size(); ++lane) {
        const Hit<T>& hit = given_[lane];
        entry_[lane] = -1;
        if (hit) place(lane, met_.slot_of(hit), entry++);
    }
    count_ = entry;
    return met_.forms();
}

/// Where each form begins, those of one side by side.
template <typename T>
auto BatchShading<T>::place_by_form() -> FormBegins {
    std::array<std::int32_t, kBatchSize> slots;
    std::copy_n(hits_->slot, count_, slots.begin());
    const auto form_of_slot = [this](std::int32_t slot) {
        return static_cast<std::size_t>(met_.form(static_cast<std::size_t>(slot)));
    };
    FormBegins begins{};
    for (std::size_t i = 0; i < count_; ++i) ++begins[form_of_slot(slots[i]) + 1];
    for (std::size_t i = 0; i < kSurfaceForms; ++i) begins[i + 1] += begins[i];
    auto next = begins;
    std::size_t before = 0;
    for (std::size_t lane = 0; lane < given_.size(); ++lane) {
        if (entry_[lane] < 0) continue;
        const std::int32_t slot = slots[before++];
        place(lane, static_cast<std::size_t>(slot), next[form_of_slot(slot)]++);
    }
    return begins;
}

/// Points at the rays' columns if those are the hits', or makes columns that are.
template <typename T>
void BatchShading<T>::find_rays() {
    if (in_order_ && batch_->in_columns) {
        from_ = &batch_->origin;
        direction_ = &batch_->direction;
        return;
    }
    for (std::size_t i = 0; i < count_; ++i) {
        const Ray<T> ray = batch_->ray(lane_[i]);
        own_from_.set(i, ray.origin);
        own_direction_.set(i, ray.direction);
    }
    from_ = &own_from_;
    direction_ = &own_direction_;
}

template <typename T>
void BatchShading<T>::compute(SurfaceForm form, std::size_t first, std::size_t end,
                              Counters& counters) {
    if (first == end) return;
    if (form >= SurfaceForm::kOther) return (this->*forms_of_.look_at_others)(first, end, counters);
    const auto spread = [&](const Columns3<T>& from, Columns3<T>& to) {
        loops_->spread(from, met_.size(), *hits_, to, first, end);
    };
    const auto spread_double = [&](const Columns3<double>& from, Columns3<double>& to) {
        loops_->spread_double(from, met_.size(), *hits_, to, first, end);
    };
    const SurfaceForms<T>& of_slots = met_.columns().forms;
    SurfaceForms<T>& forms = *forms_;
    spread(met_.columns().kd, hits_->kd);
    spread(of_slots.a, forms.a);
    spread(of_slots.b, forms.b);
    if (form == SurfaceForm::kSphere) {
        return loops_->spheres(forms, *from_, *direction_, *hits_, first, end);
    }
    spread_double(of_slots.normal, forms.normal);
    if (form == SurfaceForm::kBox) {
        return loops_->boxes(forms, *from_, *direction_, *hits_, first, end);
    }
    spread(of_slots.c, forms.c);
    if (form == SurfaceForm::kFlat) {
        return loops_->flat_triangles(forms, *from_, *direction_, *hits_, first, end);
    }
    spread_double(of_slots.na, forms.na);
    spread_double(of_slots.nb, forms.nb);
    spread_double(of_slots.nc, forms.nc);
    loops_->smooth_triangles(forms, *from_, *direction_, *hits_, first, end);
}

template <typename T>
void BatchShading<T>::look(const RayBatch<T>& batch, std::span<const Hit<T>> hits,
                           Counters& counters) {
    batch_ = &batch;
    given_ = hits;
    met_.begin();
    others_.clear();
    const std::uint32_t forms = place_in_order();
    const bool one_form = std::has_single_bit(forms);
    FormBegins begins{};
    if (one_form) {
        const auto form = static_cast<std::size_t>(std::countr_zero(forms));
        std::fill(begins.begin() + static_cast<std::ptrdiff_t>(form) + 1, begins.end(), count_);
    } else if (forms != 0) {
        begins = place_by_form();
    }
    first_other_ = begins[static_cast<std::size_t>(SurfaceForm::kOther)];
    lit_ = begins[static_cast<std::size_t>(SurfaceForm::kUnlit)];
    sorted_as_given_ = one_form;
    in_order_ = one_form && count_ == hits.size();
    find_rays();
    for (std::size_t i = 0; i < kSurfaceForms; ++i) {
        compute(static_cast<SurfaceForm>(i), begins[i], begins[i + 1], counters);
    }
    if (!met_.any_highlight() || mirrored_ == nullptr) return;
    for (std::size_t i = 0; i < lit_; ++i) {
        mirrored_->set(i, reflect(direction_->at(i), hits_->normal.at(i)));
    }
}

template <typename T>
template <SurfaceStage kStage>
void BatchShading<T>::look_at_others(std::size_t first, std::size_t end, Counters& counters) {
    for (std::size_t entry = first; entry < end; ++entry) {
        const std::size_t lane = lane_[entry];
        Encounter<T>& met = others_.emplace_back();
        met.hit = given_[lane];
        meet_as<kStage>(*scene_, batch_->ray(lane), met, counters);
        const SurfacePoint<T>& point = met.point;
        hits_->position.set(entry, point.position);
        hits_->geometric.set(entry, point.geometric_normal);
        hits_->normal.set(entry, met.look.normal);
        hits_->kd.set(entry, met.look.kd);
        hits_->error[entry] = point.error;
        hits_->turned[entry] = met.look.geometric == point.geometric_normal ? 0 : 1;
        hits_->light.set(entry, {});
    }
}

template <typename T>
void BatchShading<T>::set_sample(std::size_t entry, const LightSample<T>& sample) {
    light_->direction.set(entry, sample.direction);
    light_->target.set(entry, sample.target);
    light_->intensity.set(entry, sample.intensity);
}

template <typename T>
void BatchShading<T>::sent_by_middle(const PreparedLight& light) {
    if (light.kind == ir::Light::Kind::kPoint) {
        loops_->to_point_light(light, *hits_, *light_, lit_);
    } else {
        const LightSample<T> sample = light_middle(light, math::Vec3<T>{});
        for (std::size_t i = 0; i < lit_; ++i) set_sample(i, sample);
    }
}

/// The highlights that phong() adds.
template <typename T>
void BatchShading<T>::add_highlights(Counters& counters) {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < lit_; ++i) {
        const PreparedMaterial<T>& material = met_.material(slot_of_entry(static_cast<int>(i)));
        if (!has_highlight(material.specular, material.shininess)) continue;
        ++count;
        const T bright = highlight(hits_->normal.at(i), light_->direction.at(i), mirrored_->at(i),
                                   material.shininess);
        light_->share.set(i, light_->share.at(i) + material.specular * bright);
    }
    counters.highlights += count;
}

/// Nothing comes from below the surface that a map bends.
template <typename T>
void BatchShading<T>::leave_out_below_bent() {
    for (std::size_t i = first_other_; i < lit_; ++i) {
        const SurfaceLook<T>& look = others_[i - first_other_].look;
        if (look.bent && !(math::dot(look.smooth, light_->direction.at(i)) > T(0))) {
            light_->matters[i] = 0;
        }
    }
}

template <typename T>
template <bool kShadows, bool kHighlights, bool kBent>
void BatchShading<T>::send(const PreparedLight& light, Counters& counters) {
    loops_->lambert_share(*hits_, *light_, lit_);
    if constexpr (kHighlights) {
        if (met_.any_highlight()) add_highlights(counters);
    }
    if constexpr (!kShadows) {
        loops_->ask_without_shadows(*hits_, *light_, lit_);
    } else if (light.kind == ir::Light::Kind::kPoint) {
        loops_->ask_with_shadows_to_target(*hits_, *light_, shadow_->of_entries, lit_);
    } else {
        loops_->ask_with_shadows_in_direction(*hits_, *light_, shadow_->of_entries, lit_);
    }
    if constexpr (kBent) leave_out_below_bent();
    if constexpr (kShadows) {
        begin_shadow_rays();
    } else {
        loops_->add_light(*hits_, *light_, lit_);
    }
}

/// Those of the entries that matter, in the order of the batch.
template <typename T>
void BatchShading<T>::begin_shadow_rays() {
    RayBatch<T>& rays = shadow_->rays;
    auto& asker = shadow_->asker;
    rays.clear();
    rays.in_columns = rays.bounded = true;
    const auto& stretches = batch_->stretches;
    if (sorted_as_given_ && stretches.size() == 1) {
        const std::size_t count = loops_->begin_shadow_rays(
            met_.columns(), met_.size(), *hits_, *light_, shadow_->of_entries, lit_, rays, asker);
        rays.end_stretch_at(count, stretches[0].coherence);
        rays.count = count;
    } else {
        // Looked up once: what is written may be anything, for all that the compiler knows.
        const LightColumns<T>& answers = *light_;
        const ShadowColumns<T>& of_entries = shadow_->of_entries;
        const std::int32_t* const slot_of_entry = hits_->slot;
        const SurfaceSlots<T>& slots = met_.columns();
        const std::size_t lit = lit_;
        std::size_t count = 0, lane = 0;
        for (const auto& stretch : stretches) {
            for (; lane < stretch.end; ++lane) {
                const auto i = static_cast<std::size_t>(entry_[lane]);
                // Entries of rays that met nothing are beyond all.
                if (i >= lit || answers.matters[i] == 0) continue;
                rays.origin.set(count, of_entries.from.at(i));
                rays.direction.set(count, of_entries.way.at(i));
                rays.t_max[count] = of_entries.t_max[i];
                const auto slot = static_cast<std::size_t>(slot_of_entry[i]);
                rays.object[count] = slots.object[slot];
                rays.face[count] = slots.face[slot];
                rays.outward[count] = of_entries.outward[i];
                asker[count++] = static_cast<std::uint32_t>(i);
            }
            rays.end_stretch_at(count, stretch.coherence);
        }
        rays.count = count;
    }
    if (scene_->effects.motion_blur()) {
        for (std::size_t i = 0; i < rays.count; ++i) {
            rays.time[i] = batch_->ray(lane_[asker[i]]).time;
        }
    } else {
        std::fill_n(rays.time, rays.count, batch_->ray(0).time);
    }
}

template <typename T>
void BatchShading<T>::add_unhidden() {
    const std::size_t count = shadow_->rays.size();
    if (count == 0) return;
    for (std::size_t i = 0; i < count; ++i) {
        light_->matters[shadow_->asker[i]] = shadow_->hidden_by[i] ? 0 : 1;
    }
    loops_->add_light(*hits_, *light_, lit_);
}

template <typename T>
template <MissStage kStage>
void BatchShading<T>::color_as(Columns3<T>& colors, Counters& counters) {
    const std::size_t count = given_.size();
    if (lit_ == count && in_order_) {
        loops_->add_ambient(scene_->ambient, *hits_, colors, count);
        return;
    }
    // The light's place is not needed any more.
    loops_->add_ambient(scene_->ambient, *hits_, hits_->light, lit_);
    for (std::size_t lane = 0; lane < count; ++lane) {
        const std::int32_t entry = entry_[lane];
        const auto i = static_cast<std::size_t>(entry);
        if (entry < 0) {
            if constexpr (kStage == MissStage::kCubeMap) {
                colors.set(lane, background(*scene_, batch_->ray(lane).direction, counters));
            } else {
                colors.set(lane, scene_->background);
            }
        } else if (i < lit_) {
            colors.set(lane, hits_->light.at(i));
        } else {
            colors.set(lane,
                       color_of(*scene_, batch_->ray(lane), others_[i - first_other_], counters));
        }
    }
}

template <typename T>
bool BatchShading<T>::scatter(const Carried<T>* carried) {
    if (!met_.any_scatters()) return false;
    for (std::size_t i = 0; i < count_; ++i) {
        const Carried<T>& of = carried[lane_[i]];
        on_->weight.set(i, of.weight);
        on_->index[i] = of.index;
    }
    (met_.any_glass() ? forms_of_.scatter_with_glass : forms_of_.scatter)(
        met_.columns(), *hits_, *direction_, *on_, reflected_.get(), refracted_.get(), count_);
    return true;
}

template <typename T>
void BatchShading<T>::append_children(RayKind kind, const Carried<T>* carried,
                                      PendingRays<T>& to) const {
    const ActiveEffects& effects = scene_->effects;
    if (kind == RayKind::kReflected) {
        if (effects.reflection()) append<true>(carried, to);
    } else {
        if (effects.refraction() && met_.any_glass()) append<false>(carried, to);
    }
}

template <typename T>
template <bool kReflected>
void BatchShading<T>::append(const Carried<T>* carried, PendingRays<T>& to) const {
    // Looked up once: what is written may be anything, for all that the compiler knows.
    const ChildColumns<T>& children = kReflected ? *reflected_ : *refracted_;
    const SurfaceSlots<T>& slots = met_.columns();
    const std::int32_t* const slot_of_entry = hits_->slot;
    const T* const beyond = on_->index_beyond;
    const Ray<T>* const parents = batch_->rays.data();
    Ray<T>* rays = to.rays(to.size());
    Exclude* excludes = to.excludes(to.size());
    Carried<T>* carries = to.carried(to.size());
    Likeness* likenesses = to.likenesses(to.size());
    const std::uint8_t* const scatters = met_.scatters();
    std::size_t count = 0;
    for (std::size_t i = 0; i < count_; ++i) {
        const std::size_t lane = lane_[i];
        const auto slot = static_cast<std::size_t>(slot_of_entry[i]);
        const std::uint32_t object = slots.object[slot];
        // Its t_min and t_max are those of any ray, for good.
        Ray<T>& ray = rays[count];
        ray.origin = children.from.at(i);
        ray.direction = children.direction.at(i);
        ray.time = parents[lane].time;
        excludes[count] = {ir::ObjectId{object}, slots.face[slot], children.outward[i] == 0};
        carries[count] = {children.weight.at(i), kReflected ? carried[lane].index : beyond[i],
                          carried[lane].sample, carried[lane].number};
        likenesses[count] = likeness(children.heading[i], object);
        // What does not matter is written over by the next one: nobody knows which it will be.
        count += scatters[slot] & static_cast<std::uint32_t>(children.matters[i]);
    }
    to.take_in(count);
}

template <typename T>
Encounter<T> BatchShading<T>::encounter(std::size_t lane) const {
    const std::int32_t entry = entry_[lane];
    if (entry < 0) return {};
    const auto i = static_cast<std::size_t>(entry);
    if (i >= first_other_) return others_[i - first_other_];
    const std::size_t slot = slot_of_entry(entry);
    const ir::Object& object = scene_->source->objects[met_.columns().object[slot]];
    Encounter<T> met;
    met.hit = given_[lane];
    met.material = &met_.material(slot);
    SurfacePoint<T>& point = met.point;
    point.position = hits_->position.at(i);
    point.geometric_normal = hits_->geometric.at(i);
    const math::Vec3<T> normal = hits_->normal.at(i);
    point.shading_normal = hits_->turned[i] != 0 ? -normal : normal;
    point.error = hits_->error[i];
    point.kind = object.kind;
    point.object = met.hit.object;
    point.face = met.hit.face;
    point.material = object.material;
    Counters nothing_to_count;
    met.look = look_at_surface<SurfaceStage{0}>(*scene_, *met.material, point, direction_->at(i),
                                                nothing_to_count);
    met.light = hits_->light.at(i);
    return met;
}

template bool color_tells_all(const ShadingScene<float>&, const Settings&);
template bool color_tells_all(const ShadingScene<double>&, const Settings&);
template class BatchShading<float>;
template class BatchShading<double>;

}  // namespace cobble::renderer
