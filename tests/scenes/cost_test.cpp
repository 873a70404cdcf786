// SPDX-License-Identifier: MIT
// What a picture of each scene of scenes/ costs, in counts that are the same on every machine:
// cost.expected says it, so that a change that costs more shows in its review, without a clock.
// COBBLE_UPDATE=1 writes it anew.
//
// Rays of a kind depend on nothing but the scene. Box and primitive tests are counted on the fast
// core's trees in double precision, in which rays are searched one by one: packets, and with them
// the width of a processor's registers, have no part in them.
#include <doctest/doctest.h>
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "ir/effects.hpp"
#include "tests/render/same.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/with_instruction_set.hpp"
#include "tools/driver/load.hpp"

using namespace cobble;
using namespace cobble::test;
using renderer::Acceleration;
using renderer::Precision;

namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kWidth = 64;
constexpr std::uint32_t kHeight = 48;
constexpr std::uint32_t kSamples = 4;

struct NamedScene {
    std::string name;
    ir::Scene scene;
};

std::vector<NamedScene> load_all() {
    const fs::path folder = fs::path(COBBLE_ROOT) / "scenes";
    std::vector<fs::path> paths;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() == ".scene") paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    std::vector<NamedScene> scenes;
    for (const fs::path& path : paths) {
        CAPTURE(path);
        driver::LoadedScene loaded = driver::load_scene(path.string(), {}, {});
        REQUIRE(loaded.problem.empty());
        REQUIRE_FALSE(driver::has_errors(loaded.diagnostics));
        REQUIRE(loaded.lowered.renderable);
        scenes.push_back({path.lexically_relative(folder).replace_extension().string(),
                          std::move(loaded.lowered.scene)});
    }
    return scenes;
}

/// Reading meshes and textures takes longer than the small pictures do.
const std::vector<NamedScene>& all_scenes() {
    static const std::vector<NamedScene> scenes = load_all();
    return scenes;
}

renderer::Counters count(const ir::Scene& scene, Acceleration core, const ir::Effects& effects,
                         Precision precision) {
    renderer::Settings s = settings(kWidth, kHeight, kSamples, effects);
    s.acceleration = core;
    s.precision = precision;
    return render(scene, s).stats.counters;
}

std::string table() {
    std::string text = fmt::format("{:<22}{:>8}{:>8}{:>10}{:>10}{:>10}{:>12}\n", "scene", "camera",
                                   "shadow", "reflected", "refracted", "boxes", "primitives");
    for (const auto& [name, scene] : all_scenes()) {
        const renderer::Counters c =
            count(scene, Acceleration::kFast, ir::derive_effects(scene), Precision::kDouble);
        // Hundredths: less is no cost.
        const auto a_pixel = [](std::uint64_t tests) {
            return static_cast<double>(tests) / (kWidth * kHeight);
        };
        text += fmt::format("{:<22}{:>8}{:>8}{:>10}{:>10}{:>10.2f}{:>12.2f}\n", name, c.camera_rays,
                            c.shadow_rays, c.reflected_rays, c.refracted_rays, a_pixel(c.box_tests),
                            a_pixel(c.primitive_tests));
    }
    return text;
}

std::string text_of(const renderer::Counters& c) {
    return fmt::format("{} camera, {} shadow, {} reflected, {} refracted", c.camera_rays,
                       c.shadow_rays, c.reflected_rays, c.refracted_rays);
}

}  // namespace

TEST_CASE("each scene costs the rays and tests that are written down") {
    for (const std::string& set : renderer::instruction_sets()) {
        CAPTURE(set);
        const WithInstructionSet with(set);
        check_golden("tests/scenes/cost.expected", table());
    }
}

TEST_CASE("rays by kind are the same one by one, and in batches on every instruction set") {
    for (const NamedScene& named : all_scenes()) {
        const ir::Scene& scene = named.scene;
        CAPTURE(named.name);
        const ir::Effects all = ir::derive_effects(scene);
        // Where no ray goes on from a surface, tiles go another way.
        const ir::Effects flat =
            without(without(all, ir::Effect::kReflection), ir::Effect::kRefraction);
        for (const ir::Effects& effects : {all, flat}) {
            const std::string one_by_one =
                text_of(count(scene, Acceleration::kBvh, effects, Precision::kFloat));
            for (const std::string& set : renderer::instruction_sets()) {
                CAPTURE(set);
                const WithInstructionSet with(set);
                CHECK(text_of(count(scene, Acceleration::kFast, effects, Precision::kFloat)) ==
                      one_by_one);
            }
        }
    }
}
