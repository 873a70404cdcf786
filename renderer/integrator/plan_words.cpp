// SPDX-License-Identifier: MIT
// A plan in words, and the size of what it has allocated.
#include <fmt/core.h>

#include <algorithm>

#include "renderer/integrator/batch_columns.hpp"
#include "renderer/integrator/render_plan.hpp"
#include "renderer/integrator/stages.hpp"

namespace cobble::renderer {
namespace {

constexpr std::string_view kGeneral = "the most general form was asked for";

PlannedStage tracing_of(const RenderPlan& plan) {
    switch (plan.tracing) {
        case Tracing::kRayByRay:
            return {"tracing", "ray by ray", "the reference was asked for"};
        case Tracing::kStraight:
            return {"tracing", "batches", "no ray goes on from a surface"};
        case Tracing::kInTurns:
            break;
    }
    return {"tracing", "batches in turns", "rays go on from surfaces"};
}

PlannedStage rays_of(const RenderPlan& plan) {
    switch (plan.rays) {
        case RayStage::kPinhole:
            return {"camera rays", "pinhole", "neither depth-of-field nor motion-blur"};
        case RayStage::kLens:
            return {"camera rays", "lens", "depth-of-field"};
        case RayStage::kTime:
            return {"camera rays", "pinhole, time", "motion-blur"};
        case RayStage::kLensAndTime:
            break;
    }
    return {"camera rays", "lens, time", "depth-of-field and motion-blur"};
}

PlannedStage surface_of(const RenderPlan& plan) {
    std::string form = "of one colour";
    std::string why;
    const auto add = [&](SurfaceStage part, std::string_view what, std::string_view effect) {
        if ((plan.surface & part) == 0) return;
        form += fmt::format("{}{}", why.empty() ? ", or with " : ", ", what);
        why += fmt::format("{}{}", why.empty() ? "" : ", ", effect);
    };
    add(kSurfacePictures, "pictures", "textures");
    add(kSurfaceNoise, "noise", "noise");
    add(kSurfaceBent, "bent normals", "normal-maps");
    if (why.empty()) why = "neither textures nor noise nor normal-maps";
    return {"surfaces", form, why};
}

std::string counted(std::ptrdiff_t count, std::string_view what) {
    return fmt::format("{} {}", count, what);
}

PlannedStage lights_of(const RenderPlan& plan) {
    if (plan.lights.empty()) return {"lights", "none", "the scene has no lights"};
    const auto areas = std::count(plan.lights.begin(), plan.lights.end(), LightStage::kArea);
    const auto points = static_cast<std::ptrdiff_t>(plan.lights.size()) - areas;
    std::string form;
    if (points > 0) form += counted(points, "sharp");
    if (points > 0 && areas > 0) form += ", ";
    if (areas > 0) form += counted(areas, "soft");
    form += plan.shadows ? ", shadow rays" : ", no shadow rays";
    std::string why = areas > 0 ? "soft-shadows" : "no soft-shadows";
    why += plan.shadows ? ", shadows" : ", no shadows";
    return {"lights", form, why};
}

PlannedStage highlights_of(const RenderPlan& plan) {
    if (plan.highlights) return {"highlights", "added", "highlights"};
    return {"highlights", "none", "no highlights, or no material that has one"};
}

PlannedStage scatter_of(const RenderPlan& plan) {
    switch (plan.scatter) {
        case ScatterStage::kNone:
            return {"scatter", "none",
                    plan.bounces == 0 ? "no bounces"
                                      : "neither reflection nor refraction, or nothing to do it"};
        case ScatterStage::kReflect:
            return {"scatter", "reflected rays", "reflection, no refraction"};
        case ScatterStage::kRefract:
            return {"scatter", "refracted rays", "refraction, no reflection"};
        case ScatterStage::kReflectAndRefract:
            break;
    }
    return {"scatter", "reflected and refracted rays", "reflection and refraction"};
}

PlannedStage miss_of(const RenderPlan& plan) {
    if (plan.miss == MissStage::kColor) {
        return {"background", "colour", "no environment around the scene"};
    }
    return {"background", "cube map", "environment"};
}

template <typename T>
std::vector<PlannedBytes> columns_in(const RenderPlan& plan) {
    std::vector<PlannedBytes> result;
    const auto add = [&](ColumnGroup group, std::string_view name, std::string_view why_none) {
        result.push_back({name, plan.needs(group) ? bytes_of<T>(group) : 0, why_none});
    };
#define COBBLE_COLUMNS(id, name, why) add(ColumnGroup::id, name, why);
    COBBLE_COLUMN_GROUPS(COBBLE_COLUMNS)
#undef COBBLE_COLUMNS
    return result;
}

}  // namespace

std::vector<PlannedStage> stages_of(const RenderPlan& plan) {
    std::vector<PlannedStage> stages{tracing_of(plan), rays_of(plan),       surface_of(plan),
                                     lights_of(plan),  highlights_of(plan), scatter_of(plan),
                                     miss_of(plan)};
    if (plan.general) {
        for (PlannedStage& stage : stages) stage.why = kGeneral;
    }
    return stages;
}

template <typename T>
std::uint64_t bytes_of(ColumnGroup group) {
    constexpr std::uint64_t kRays =
        sizeof(RayBatch<T>) + kBatchSize * sizeof(typename RayBatch<T>::Stretch);
    switch (group) {
        case ColumnGroup::kRays:
            return kRays + sizeof(CameraColumns) + kBatchSize * sizeof(Hit<T>) +
                   sizeof(Columns3<T>);
        case ColumnGroup::kSurfaces:
            return sizeof(SurfaceSlots<T>) + sizeof(SurfaceForms<T>) + sizeof(HitColumns<T>);
        case ColumnGroup::kOneByOne:
            return kBatchSize * sizeof(Encounter<T>);
        case ColumnGroup::kLight:
            return sizeof(LightColumns<T>);
        case ColumnGroup::kShadowRays:
            return sizeof(ShadowRays<T>) + kBatchSize * sizeof(typename RayBatch<T>::Stretch);
        case ColumnGroup::kHighlights:
            return sizeof(Columns3<T>);
        case ColumnGroup::kScatter:
            return sizeof(ScatterColumns<T>);
        case ColumnGroup::kReflected:
        case ColumnGroup::kRefracted:
            return sizeof(ChildColumns<T>);
        case ColumnGroup::kCount_:
            break;
    }
    return 0;
}

template std::uint64_t bytes_of<float>(ColumnGroup);
template std::uint64_t bytes_of<double>(ColumnGroup);

std::vector<PlannedBytes> columns_of(const RenderPlan& plan) {
    return plan.single ? columns_in<float>(plan) : columns_in<double>(plan);
}

}  // namespace cobble::renderer
