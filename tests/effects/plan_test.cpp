// SPDX-License-Identifier: MIT
// The plan of a render: the form of each stage, and memory for what is needed and nothing else.
#include <doctest/doctest.h>

#include <cstdint>
#include <string>

#include "ir/effects.hpp"
#include "renderer/integrator/batch_shading.hpp"
#include "renderer/integrator/render_plan.hpp"
#include "tests/effects/allocations.hpp"
#include "tests/effects/work_of.hpp"
#include "tests/render/everything.hpp"

using namespace cobble;
using namespace cobble::test;
using renderer::ColumnGroup;
using renderer::LightStage;
using renderer::MissStage;
using renderer::RayStage;
using renderer::RenderPlan;
using renderer::ScatterStage;
using renderer::Tracing;

namespace {

RenderPlan plan_of(const ir::Scene& scene, std::uint32_t mask, std::uint32_t bounces = 4) {
    renderer::Settings s = settings(8, 6, 1, effects_of_mask(mask));
    s.bounces = bounces;
    return renderer::plan_render(scene, s);
}

std::uint32_t mask_without(std::initializer_list<Effect> effects) {
    std::uint32_t mask = kAllEffects;
    for (const Effect effect : effects) mask &= ~renderer::bit_of(effect);
    return mask;
}

std::uint64_t bytes_of_columns(const RenderPlan& plan) {
    std::uint64_t bytes = 0;
    for (const auto& columns : renderer::columns_of(plan)) bytes += columns.bytes;
    return bytes;
}

std::uint64_t bytes_of_pictures(const RenderPlan& plan, std::string_view name) {
    for (const auto& pictures : plan.pictures) {
        if (pictures.name == name) return pictures.bytes;
    }
    FAIL("there are no pictures called ", std::string(name));
    return 0;
}

/// What shading allocates for its batches.
template <typename T>
std::uint64_t allocated(const ir::Scene& scene, const renderer::Settings& settings) {
    const auto prepared = renderer::prepare_shading<T>(scene, settings);
    const std::uint64_t before = bytes_asked_for();
    const renderer::BatchShading<T> shading(prepared);
    return bytes_asked_for() - before;
}

/// Spheres, a box and a triangle, at rest, of one colour each, one of them a mirror; one light.
SceneBuilder plain() {
    SceneBuilder b;
    b.background({0.1, 0.2, 0.4}, {0.1, 0.1, 0.1}).camera({0, 2, 8}, {0, -0.2, -1}, 0.7);
    b.material({0.8, 0.6, 0.4});
    b.sphere({0, 1, 0}, 1).box({1.2, 0, -1}, {2.2, 1, 0});
    b.triangle({-9, 0, -9}, {9, 0, -9}, {0, 0, 9});
    b.point_light({3, 6, 4}, {0.7, 0.7, 0.7});
    return b;
}

}  // namespace

TEST_CASE("each stage of a plan is as general as the effects that are on, and no more") {
    SceneBuilder b = everything();
    const ir::Scene& scene = b.scene();
    const RenderPlan all = plan_of(scene, kAllEffects);
    CHECK(all.tracing == Tracing::kInTurns);
    CHECK(all.rays == RayStage::kLensAndTime);
    CHECK(all.surface == renderer::kAnySurface);
    CHECK(all.lights == std::vector<LightStage>(2, LightStage::kArea));
    CHECK(all.shadows);
    CHECK(all.highlights);
    CHECK(all.scatter == ScatterStage::kReflectAndRefract);
    CHECK(all.miss == MissStage::kCubeMap);

    CHECK(plan_of(scene, mask_without({Effect::kMotionBlur})).rays == RayStage::kLens);
    CHECK(plan_of(scene, mask_without({Effect::kDepthOfField})).rays == RayStage::kTime);
    CHECK(plan_of(scene, mask_without({Effect::kNormalMaps})).surface ==
          (renderer::kSurfacePictures | renderer::kSurfaceNoise));
    CHECK(plan_of(scene, mask_without({Effect::kNoise})).surface ==
          (renderer::kSurfacePictures | renderer::kSurfaceBent));
    CHECK(plan_of(scene, mask_without({Effect::kTextures})).surface ==
          (renderer::kSurfaceNoise | renderer::kSurfaceBent));
    CHECK(plan_of(scene, mask_without({Effect::kRefraction})).scatter == ScatterStage::kReflect);
    CHECK(plan_of(scene, mask_without({Effect::kReflection})).scatter == ScatterStage::kRefract);
    CHECK_FALSE(plan_of(scene, mask_without({Effect::kShadows})).shadows);
    CHECK_FALSE(plan_of(scene, mask_without({Effect::kHighlights})).highlights);
    CHECK(plan_of(scene, kAllEffects, 0).scatter == ScatterStage::kNone);
    CHECK(plan_of(scene, kAllEffects, 0).tracing == Tracing::kStraight);

    const RenderPlan none = plan_of(scene, 0);
    CHECK(none.tracing == Tracing::kStraight);
    CHECK(none.rays == RayStage::kPinhole);
    CHECK(none.surface == 0);
    CHECK(none.lights == std::vector<LightStage>(2, LightStage::kMiddle));
    CHECK(none.scatter == ScatterStage::kNone);
    CHECK(none.miss == MissStage::kColor);
    CHECK_FALSE(none.reads_uv);
}

TEST_CASE("what is planned for one thing is not planned for what no object is made of") {
    SceneBuilder b = plain();
    renderer::Settings s = settings(8, 6);
    // Materials, but of no object.
    b.material({1, 1, 1}, {1, 1, 1}, 20, 1.5).texture = b.image(scrambled_image(4, 1));
    RenderPlan plan = renderer::plan_render(b.scene(), s);
    CHECK(plan.scatter == ScatterStage::kNone);
    CHECK(plan.surface == 0);
    CHECK_FALSE(plan.reads_uv);
    CHECK_FALSE(plan.highlights);
    CHECK_FALSE(plan.needs(ColumnGroup::kOneByOne));
    CHECK(bytes_of_pictures(plan, "textures") == 0);
    CHECK_FALSE(
        renderer::prepare_shading<float>(b.scene(), s).geometry.options.texture_coordinates);
    b.sphere({-2, 1, 0}, 1);
    plan = renderer::plan_render(b.scene(), s);
    CHECK(plan.scatter == ScatterStage::kReflectAndRefract);
    CHECK(plan.surface == renderer::kSurfacePictures);
    CHECK(plan.highlights);
    CHECK(plan.needs(ColumnGroup::kOneByOne));
    CHECK(bytes_of_pictures(plan, "textures") == 48);
    CHECK(renderer::prepare_shading<float>(b.scene(), s).geometry.options.texture_coordinates);
}

TEST_CASE("columns of an effect that is off have no bytes") {
    SceneBuilder b = everything();
    const ir::Scene& scene = b.scene();
    const RenderPlan all = plan_of(scene, kAllEffects);
    struct Case {
        Effect off;
        ColumnGroup group;
    };
    for (const Case& of : {Case{Effect::kShadows, ColumnGroup::kShadowRays},
                           Case{Effect::kHighlights, ColumnGroup::kHighlights},
                           Case{Effect::kReflection, ColumnGroup::kReflected},
                           Case{Effect::kRefraction, ColumnGroup::kRefracted}}) {
        CAPTURE(ir::name_of(of.off));
        const RenderPlan without = plan_of(scene, mask_without({of.off}));
        const auto at = static_cast<std::size_t>(of.group);
        CHECK(renderer::columns_of(all)[at].bytes == renderer::bytes_of<float>(of.group));
        CHECK(renderer::columns_of(without)[at].bytes == 0);
        CHECK(bytes_of_columns(all) - bytes_of_columns(without) ==
              renderer::bytes_of<float>(of.group));
    }
    CHECK(bytes_of_pictures(all, "textures") == 48);
    CHECK(bytes_of_pictures(all, "normal maps") == 48 + 3 * 16 * 16);
    CHECK(bytes_of_pictures(all, "cube maps") == 6 * 3 * 8 * 8);
    CHECK(bytes_of_pictures(plan_of(scene, mask_without({Effect::kTextures})), "textures") == 0);
    CHECK(bytes_of_pictures(plan_of(scene, mask_without({Effect::kNormalMaps})), "normal maps") ==
          0);
    CHECK(bytes_of_pictures(plan_of(scene, mask_without({Effect::kEnvironment})), "cube maps") ==
          0);
}

TEST_CASE("a batch allocates what the plan says, to the byte") {
    SceneBuilder lavish = everything();
    SceneBuilder frugal = plain();
    SceneBuilder dark = plain();
    dark.scene().lights.clear();
    std::uint32_t sizes = 0;
    for (const ir::Scene* scene : {&lavish.scene(), &frugal.scene(), &dark.scene()}) {
        for (std::uint32_t i = 0; i <= ir::kEffectCount; ++i) {
            CAPTURE(i);
            renderer::Settings s = settings(8, 6, 1, effects_of_mask(kAllEffects & ~(1U << i)));
            for (const bool general : {false, true}) {
                s.general_stages = general;
                s.precision = renderer::Precision::kFloat;
                RenderPlan plan = renderer::plan_render(*scene, s);
                // The rays themselves are not the shading's.
                CHECK(allocated<float>(*scene, s) ==
                      bytes_of_columns(plan) - renderer::bytes_of<float>(ColumnGroup::kRays));
                s.precision = renderer::Precision::kDouble;
                plan = renderer::plan_render(*scene, s);
                CHECK(allocated<double>(*scene, s) ==
                      bytes_of_columns(plan) - renderer::bytes_of<double>(ColumnGroup::kRays));
                ++sizes;
            }
        }
    }
    CHECK(sizes == 3 * 2 * 12);
}

TEST_CASE("the reference has no columns") {
    SceneBuilder b = everything();
    renderer::Settings s = settings(8, 6);
    s.acceleration = renderer::Acceleration::kBvh;
    const RenderPlan plan = renderer::plan_render(b.scene(), s);
    CHECK(plan.tracing == Tracing::kRayByRay);
    CHECK(bytes_of_columns(plan) == 0);
    CHECK(bytes_of_pictures(plan, "textures") == 48);
}
