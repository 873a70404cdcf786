// SPDX-License-Identifier: MIT
// Every subset of the effects: stages in the forms that the plan chooses draw what the reference
// draws and what the most general forms draw, to the bit, and what is off does nothing at all.
#include <doctest/doctest.h>

#include <cstdint>

#include "ir/effects.hpp"
#include "tests/effects/work_of.hpp"
#include "tests/render/everything.hpp"
#include "tests/render/same.hpp"

using namespace cobble;
using namespace cobble::test;
using renderer::Acceleration;

namespace {

renderer::Settings tiny(std::uint32_t mask) {
    renderer::Settings s = settings(8, 6, 1, effects_of_mask(mask));
    s.bounces = 2;
    s.light_samples = 1 + mask % 2;  // of a light with a size
    return s;
}

bool same_work(const renderer::Counters& a, const renderer::Counters& b) {
    for (std::size_t i = 0; i < ir::kEffectCount; ++i) {
        const auto effect = static_cast<Effect>(i);
        if (work_of(effect, a) != work_of(effect, b)) return false;
    }
    return a.camera_rays == b.camera_rays;
}

}  // namespace

TEST_CASE("the scene that all this is tried on calls for every effect") {
    SceneBuilder b = everything();
    const ir::Effects called_for = ir::derive_effects(b.scene());
    for (std::size_t i = 0; i < ir::kEffectCount; ++i) {
        CAPTURE(ir::name_of(static_cast<Effect>(i)));
        CHECK(called_for.states[i].on);
    }
}

TEST_CASE("all subsets of the effects: chosen forms, general forms and the reference are one") {
    SceneBuilder b = everything();
    for (std::uint32_t mask = 0; mask <= kAllEffects; ++mask) {
        CAPTURE(mask);
        renderer::Settings s = tiny(mask);
        const Rendered chosen = render(b.scene(), s);
        s.general_stages = true;
        const Rendered general = render(b.scene(), s);
        CHECK(same(chosen.picture, general.picture));
        CHECK(same_rays(chosen.stats.counters, general.stats.counters));
        for (std::size_t i = 0; i < ir::kEffectCount; ++i) {
            const auto effect = static_cast<Effect>(i);
            if (s.effects.on(effect)) continue;
            CAPTURE(ir::name_of(effect));
            CHECK(work_of(effect, chosen.stats.counters) == 0);
        }
        s.general_stages = false;
        s.acceleration = Acceleration::kBvh;
        const Rendered reference = render(b.scene(), s);
        CHECK(same(chosen.picture, reference.picture));
        CHECK(same_work(chosen.stats.counters, reference.stats.counters));
    }
}

TEST_CASE("an effect that the scene calls for is seen to be missing") {
    SceneBuilder b = everything();
    renderer::Settings s = tiny(kAllEffects);
    s.width = 24;
    s.height = 18;
    const Rendered full = render(b.scene(), s);
    for (std::uint32_t i = 0; i < ir::kEffectCount; ++i) {
        const auto effect = static_cast<Effect>(i);
        CAPTURE(ir::name_of(effect));
        s.effects = effects_of_mask(kAllEffects & ~(1U << i));
        const Rendered lacking = render(b.scene(), s);
        CHECK_FALSE(same(full.picture, lacking.picture));
        CHECK(work_of(effect, full.stats.counters) > 0);
        CHECK(work_of(effect, lacking.stats.counters) == 0);
    }
}
