// SPDX-License-Identifier: MIT
// The fingerprint of settings: whatever changes pixels changes it, and nothing else does.
#include "renderer/settings.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace cobble::renderer {
namespace {

using Change = std::function<void(Settings&)>;

// One of each field, and of each value that an absent one could be taken for.
std::vector<Change> changes_of_pixels() {
    std::vector<Change> changes = {
        [](Settings& s) { s.width = 641; },
        [](Settings& s) { s.height = 481; },
        [](Settings& s) {
            s.crop = Crop{1, 0, 640, 480};
        },
        [](Settings& s) {
            s.crop = Crop{0, 1, 640, 480};
        },
        [](Settings& s) {
            s.crop = Crop{0, 0, 639, 480};
        },
        [](Settings& s) {
            s.crop = Crop{0, 0, 640, 479};
        },
        [](Settings& s) { s.samples = 17; },
        [](Settings& s) { s.bounces = 5; },
        [](Settings& s) { s.salts = 2; },
        [](Settings& s) { s.light_samples = 2; },
        [](Settings& s) { s.scrambles = 8; },
        [](Settings& s) { s.goal = ErrorGoal{}; },
        [](Settings& s) {
            s.goal = ErrorGoal{};
            s.goal->error = 0.02;
        },
        [](Settings& s) {
            s.goal = ErrorGoal{};
            s.goal->method = ErrorGoal::Method::kUnbiased;
        },
        [](Settings& s) {
            s.goal = ErrorGoal{};
            s.goal->most_samples = 128;
        },
        [](Settings& s) {
            s.goal = ErrorGoal{};
            s.shown_as_srgb = true;
        },
        [](Settings& s) { s.seed = 1; },
        [](Settings& s) { s.seed = ~std::uint64_t{0}; },
        [](Settings& s) { s.filter = PixelFilter::kTent; },
        [](Settings& s) { s.filter = PixelFilter::kGaussian; },
        [](Settings& s) { s.precision = Precision::kDouble; },
        [](Settings& s) { s.texture_filter = ir::TextureFilter::kNearest; },
        [](Settings& s) { s.texture_filter = ir::TextureFilter::kBilinear; },
        [](Settings& s) { s.compat.shadows = true; },
        [](Settings& s) { s.compat.jitter = true; },
        [](Settings& s) { s.compat.filter = true; },
        [](Settings& s) { s.compat.casting = true; },
        [](Settings& s) { s.compat.pixelated = true; },
        [](Settings& s) { s.compat.blurry = 0; },
        [](Settings& s) { s.compat.blurry = -1; },
        [](Settings& s) { s.compat.blurry = 0x1.0000000000001p0; },
        [](Settings& s) { s.compat.blurry = 1; },
        [](Settings& s) { s.compat.depth_min = 0.5; },
        [](Settings& s) { s.compat.depth_max = 2; },
    };
    for (std::size_t i = 0; i < ir::kEffectCount; ++i) {
        changes.push_back([i](Settings& s) { s.effects.states[i].on = true; });
    }
    return changes;
}

TEST_CASE("every setting that changes pixels changes the fingerprint, each in its own way") {
    std::set<std::string> seen{fingerprint({})};
    const std::vector<Change> changes = changes_of_pixels();
    for (std::size_t i = 0; i < changes.size(); ++i) {
        CAPTURE(i);
        Settings settings;
        changes[i](settings);
        CHECK(seen.insert(fingerprint(settings)).second);
    }
}

TEST_CASE("how a picture is made, and why an effect is on, leave the fingerprint alone") {
    const std::vector<Change> changes = {
        [](Settings& s) { s.acceleration = Acceleration::kBruteForce; },
        [](Settings& s) { s.general_stages = true; },
        [](Settings& s) { s.tile_size = 8; },
        [](Settings& s) { s.time_stages = true; },
        [](Settings& s) { s.shown_as_srgb = true; },
        [](Settings& s) {
            s.crop = Crop{0, 0, 640, 480};
        },
        [](Settings& s) {
            s.crop = Crop{0, 0, 1000, 1000};
        },
        [](Settings& s) { s.shard_index = 1, s.shard_count = 2; },
        [](Settings& s) { s.want_depth = s.want_normals = true; },
        [](Settings& s) { s.want_albedo = s.want_sample_count = true; },
        [](Settings& s) { s.effects.states[0].reason = "switched off"; },
    };
    for (std::size_t i = 0; i < changes.size(); ++i) {
        CAPTURE(i);
        Settings settings;
        changes[i](settings);
        CHECK(fingerprint(settings) == fingerprint({}));
    }
}

// A field that is added makes this fail: decide whether it belongs in the fingerprint.
TEST_CASE("no field of the settings is forgotten") {
    const auto& [width, height, crop, samples, light_samples, scrambles, goal, shown_as_srgb,
                 bounces, seed, salts, filter, precision, acceleration, general_stages, tile_size,
                 time_stages, effects, texture_filter, compat, shard_index, shard_count, want_depth,
                 want_normals, want_albedo, want_sample_count] = Settings{};
    const auto& [error, method, most_samples] = ErrorGoal{};
    const auto& [shadows, jitter, tent, casting, pixelated, blurry, depth_min, depth_max] = compat;
    const bool as_they_are = width == 640 && !shadows && error == 0.01;
    CHECK(as_they_are);
}

}  // namespace
}  // namespace cobble::renderer
