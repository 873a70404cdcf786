// SPDX-License-Identifier: MIT
// The fast core, in batches, draws every scene at hand as the reference does, to the bit: the
// project's own and, where the corpus is there, the published ones, read as Cobble means them.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "ir/effects.hpp"
#include "tests/compat/support.hpp"
#include "tests/support/corpus.hpp"

namespace cobble::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> scenes_in(const fs::path& folder, const std::string& ending) {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() == ending) found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    return found;
}

bool same(const renderer::Plane32& a, const renderer::Plane32& b) {
    return a.values.size() == b.values.size() &&
           std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(float)) == 0;
}

void check_cores(const fs::path& path) {
    CAPTURE(path.string());
    const LoadedScene loaded = load_scene(path, {});
    if (!loaded.lowered.renderable) return;
    renderer::Settings s;
    s.width = 32;
    s.height = 24;
    s.samples = 2;
    s.effects = ir::derive_effects(loaded.lowered.scene);
    s.want_depth = s.want_normals = s.want_albedo = s.want_sample_count = true;
    for (const auto precision : {renderer::Precision::kFloat, renderer::Precision::kDouble}) {
        s.precision = precision;
        s.acceleration = renderer::Acceleration::kBvh;
        const renderer::Picture reference = render(loaded.lowered.scene, s);
        s.acceleration = renderer::Acceleration::kFast;
        const renderer::Picture fast = render(loaded.lowered.scene, s);
        CHECK(fast.complete);
        CHECK(same(reference.color, fast.color));
        CHECK(same(reference.depth, fast.depth));
        CHECK(same(reference.normals, fast.normals));
        CHECK(same(reference.albedo, fast.albedo));
        CHECK(same(reference.sample_count, fast.sample_count));
    }
}

}  // namespace

TEST_CASE("the fast core draws the project's scenes as the reference does") {
    const std::vector<fs::path> scenes = scenes_in(fs::path(COBBLE_ROOT) / "scenes", ".scene");
    CHECK(scenes.size() >= 14);
    for (const fs::path& path : scenes) check_cores(path);
}

TEST_CASE("the fast core draws the published scenes as the reference does" *
          doctest::test_suite("corpus")) {
    const fs::path folder = corpus_or_skip();
    if (folder.empty()) return;
    for (const fs::path& path : scenes_in(folder, ".txt")) check_cores(path);
}

}  // namespace cobble::test
