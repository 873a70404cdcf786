// SPDX-License-Identifier: MIT
// Only what is asked for is simulated, and what is not does not disturb the rest.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <string>

#include "tests/render/scene_builder.hpp"

using namespace cobble;
using namespace cobble::test;

namespace {

bool same(const Rendered& a, const Rendered& b) {
    return a.picture.color.values.size() == b.picture.color.values.size() &&
           std::memcmp(a.picture.color.values.data(), b.picture.color.values.data(),
                       a.picture.color.values.size() * sizeof(float)) == 0;
}

/// Calls for no effect at all but hard shadows, in the plainest way; room for more.
SceneBuilder plain_scene() {
    SceneBuilder b;
    b.background({0.1, 0.2, 0.4}, {0.1, 0.1, 0.1});
    b.camera({0, 2, 8}, {0, -0.2, -1}, 0.7);
    b.material({0.8, 0.6, 0.4});
    b.plane({0, 1, 0}, 0);
    b.sphere({0, 1, 0}, 1);
    b.box({1.2, 0, -1}, {2.2, 1, 0});
    b.point_light({3, 6, 4}, {0.7, 0.7, 0.7});
    b.sun({0.4, -1, -0.3}, {0.3, 0.3, 0.3});
    return b;
}

ir::Image constant_image(std::uint8_t r, std::uint8_t g, std::uint8_t b) {
    ir::Image image;
    image.width = image.height = 4;
    for (int i = 0; i < 16; ++i) {
        image.bytes.push_back(r);
        image.bytes.push_back(g);
        image.bytes.push_back(b);
    }
    return image;
}

/// That switching `effect` on where nothing calls for it changes no bit.
void check_neutral(const ir::Scene& scene, Effect effect) {
    const ir::Effects base = effects({Effect::kShadows});
    ir::Effects with = base;
    with.states[static_cast<std::size_t>(effect)].on = true;
    for (const auto precision : {renderer::Precision::kFloat, renderer::Precision::kDouble}) {
        for (const std::uint32_t samples : {1U, 5U}) {
            renderer::Settings off = settings(24, 18, samples, base);
            off.precision = precision;
            renderer::Settings on = off;
            on.effects = with;
            const Rendered a = render(scene, off);
            const Rendered b = render(scene, on);
            CHECK(same(a, b));
            CHECK(a.stats.counters.rays() == b.stats.counters.rays());
        }
    }
}

}  // namespace

TEST_CASE("each effect at its neutral parameter is no effect, to the bit") {
    SceneBuilder b = plain_scene();
    b.shutter(0.25, 0.25);
    b.lens(0, 7.5, 5);
    for (std::size_t i = 0; i < ir::kEffectCount; ++i) {
        const auto effect = static_cast<Effect>(i);
        if (effect == Effect::kShadows) continue;
        CAPTURE(i);
        check_neutral(b.scene(), effect);
    }
    // Lights without size, and a shutter that stays open over things at rest.
    b.shutter(0, 1);
    check_neutral(b.scene(), Effect::kMotionBlur);
}

TEST_CASE("a flat normal map and a flat bump map leave every bit") {
    SceneBuilder b = plain_scene();
    const ir::ImageId flat = b.image(constant_image(128, 128, 255));
    b.scene().materials[0].normal_map = flat;
    check_neutral(b.scene(), Effect::kNormalMaps);
    b.scene().materials[0].normal_map = {};
    b.scene().materials[0].bump_map = flat;
    check_neutral(b.scene(), Effect::kNormalMaps);
}

TEST_CASE("a texture of one colour is that colour") {
    SceneBuilder b = plain_scene();
    b.scene().materials[0].diffuse = {77 / 255.0, 128 / 255.0, 1};
    b.scene().materials[0].texture = b.image(constant_image(77, 128, 255));
    check_neutral(b.scene(), Effect::kTextures);
}

TEST_CASE("only rays of effects that are on are traced") {
    SceneBuilder b = plain_scene();
    b.material({0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}, 30, 1.5);
    b.sphere({-1.5, 1, 1}, 0.8);
    const std::uint64_t pixels = 24 * 18;
    const auto counters = [&](ir::Effects on, std::uint32_t samples) {
        return render(b.scene(), settings(24, 18, samples, std::move(on))).stats.counters;
    };
    const auto none = counters({}, 3);
    CHECK(none.camera_rays == 3 * pixels);
    CHECK(none.rays() == 3 * pixels);
    const auto shadows = counters(effects({Effect::kShadows}), 1);
    CHECK(shadows.shadow_rays > 0);
    CHECK(shadows.reflected_rays + shadows.refracted_rays == 0);
    const auto mirror = counters(effects({Effect::kReflection}), 1);
    CHECK(mirror.reflected_rays > 0);
    CHECK(mirror.shadow_rays + mirror.refracted_rays == 0);
    const auto glass = counters(effects({Effect::kRefraction}), 1);
    CHECK(glass.refracted_rays > 0);
    CHECK(glass.shadow_rays + glass.reflected_rays == 0);
}

TEST_CASE("switching one effect off changes no number that another draws") {
    // A lens, a large light, something moving and a mirror ball: pixels that do not meet the ball
    // at all stay as they are to the bit when reflection is off; pixels with lens and light do when
    // motion is, where nothing moves.
    SceneBuilder b;
    b.background({0.3, 0.3, 0.3}, {0.1, 0.1, 0.1});
    b.camera({0, 2, 8}, {0, -0.2, -1}, 0.7).lens(0.3, 8);
    b.material({0.8, 0.6, 0.4});
    b.plane({0, 1, 0}, 0);
    b.point_light({-3, 6, 4}, {0.7, 0.7, 0.7}, 1);
    b.sun({0.4, -1, -0.3}, {0.3, 0.3, 0.3}, 0.1);
    b.material({0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}, 30, 1.5);
    b.sphere({2, 1, 0}, 0.8);
    const ir::Effects all = all_effects();
    const Rendered full = render(b.scene(), settings(32, 24, 8, all));
    // Left half: the ball is far to the right, and blur does not reach over.
    const auto left_half_equal = [&](const Rendered& other) {
        for (std::uint32_t y = 0; y < 24; ++y) {
            for (std::uint32_t x = 0; x < 12; ++x) {
                if (!(full.color(x, y) == other.color(x, y))) return false;
            }
        }
        return true;
    };
    for (const Effect effect : {Effect::kReflection, Effect::kRefraction, Effect::kHighlights,
                                Effect::kMotionBlur, Effect::kNoise}) {
        const Rendered other = render(b.scene(), settings(32, 24, 8, without(all, effect)));
        CAPTURE(static_cast<int>(effect));
        CHECK(left_half_equal(other));
        if (effect == Effect::kReflection || effect == Effect::kRefraction) {
            CHECK_FALSE(same(full, other));
        }
    }
    // An effect that does touch them is seen to.
    CHECK_FALSE(left_half_equal(
        render(b.scene(), settings(32, 24, 8, without(all, Effect::kSoftShadows)))));
    CHECK_FALSE(left_half_equal(
        render(b.scene(), settings(32, 24, 8, without(all, Effect::kDepthOfField)))));
    // The lens off moves no number of the lights: with an aperture of 0 it is the same thing.
    ir::Scene shut = b.scene();
    shut.camera.aperture = 0;
    CHECK(same(render(shut, settings(32, 24, 8, all)),
               render(b.scene(), settings(32, 24, 8, without(all, Effect::kDepthOfField)))));
    // A second light's numbers do not depend on the first's being there to draw.
    ir::Scene dark = b.scene();
    dark.lights[0].color = {};
    ir::Scene sized = dark;
    sized.lights[0].radius = 0;
    CHECK(same(render(dark, settings(32, 24, 8, all)), render(sized, settings(32, 24, 8, all))));
}

TEST_CASE("one sample a pixel is its centre; more are spread") {
    SceneBuilder b;
    b.background({1, 1, 1});
    b.material({0, 0, 0});
    // An edge that runs through the middle of the pixels of one column.
    b.triangle({0.0, -100, 0}, {100, -100, 0}, {0.0, 200, 0});
    const Rendered one = render(b.scene(), settings(9, 9, 1, {}));
    const Rendered many = render(b.scene(), settings(9, 9, 64, {}));
    CHECK(one.color(3, 4).x == 1);
    CHECK(one.color(5, 4).x == 0);
    CHECK(many.color(4, 4).x == doctest::Approx(0.5).epsilon(0.02));
    CHECK(many.color(3, 4).x == 1);
    CHECK(many.color(5, 4).x == 0);
    // Eight columns: the edge runs between two of them. A tent two pixels wide has an eighth of
    // itself beyond a pixel's border, a box nothing.
    renderer::Settings filtered = settings(8, 9, 1024, {});
    CHECK(render(b.scene(), filtered).color(3, 4).x == 1);
    filtered.filter = renderer::PixelFilter::kTent;
    CHECK(render(b.scene(), filtered).color(3, 4).x == doctest::Approx(0.875).epsilon(2e-3));
    // The cut Gaussian: (Q(1) - Q(3)) / (1 - 2 Q(3)) in one dimension is close to what is left of
    // the round one beyond a line one deviation away; 0.155 by numerical integration.
    filtered.filter = renderer::PixelFilter::kGaussian;
    CHECK(render(b.scene(), filtered).color(3, 4).x == doctest::Approx(1 - 0.155).epsilon(5e-3));
}
