// SPDX-License-Identifier: MIT
// What people read of a scene that float fails, and of one that it does not.
#include "tools/driver/report/stability_report.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <string>

#include "tests/hard/wrong_kernels.hpp"
#include "tests/render/scene_builder.hpp"

namespace cobble::driver {
namespace {

constexpr std::string_view kText =
    "Group {\n"
    "    Triangle lower { }\n"
    "    Triangle upper { }\n"
    "}\n";

/// Two triangles that share an edge, in front of the camera, written on lines 2 and 3.
struct Written {
    source::SourceMap sources;
    ir::Scene scene;

    Written() {
        test::SceneBuilder builder;
        builder.triangle({-1.1, -0.9, 0.1}, {0.9, -1.2, -0.3}, {1.3, 0.8, 0.2});
        builder.triangle({-1.1, -0.9, 0.1}, {1.3, 0.8, 0.2}, {-0.7, 1.1, -0.2});
        scene = builder.scene();
        const auto id = sources.add("a.scene", std::string(kText));
        for (std::size_t i = 0; i < 2; ++i) {
            const auto at = static_cast<std::uint32_t>(
                kText.find(i == 0 ? "Triangle lower" : "Triangle upper"));
            scene.objects[i].span = {id, at, at + 14};
            scene.objects[i].label = i == 0 ? "lower" : "upper";
        }
    }

    template <typename Kernel>
    renderer::Stability measure(Kernel kernel) const {
        renderer::StabilityOptions options;
        options.rays = 1000000;
        test::cast_with(options, [kernel](const auto& in, const auto& ray, const auto& exclude) {
            return test::cast_by(in, ray, exclude, kernel);
        });
        return renderer::measure_stability(scene, options);
    }
    [[nodiscard]] std::string text(const renderer::Stability& stability) const {
        return stability_to_text({stability, scene, sources, "a.scene", 640, 480}, {});
    }
};

}  // namespace

TEST_CASE("stability: a planted fault is reported with the line of its object") {
    const Written written;
    const renderer::Stability leaky = written.measure(test::moller_trumbore);
    REQUIRE(!leaky.clean());
    const std::string text = written.text(leaky);
    CAPTURE(text);
    const auto& worst = leaky.objects.front();
    REQUIRE(worst.cracks > 0);
    const std::string line = worst.object.value == 0 ? "a.scene:2:5" : "a.scene:3:5";
    // In the table, and where an example of the fault is told.
    CHECK(text.find(line) != std::string::npos);
    CHECK(text.find(" cracks: on the Triangle, the first at ") != std::string::npos);
    // The line itself, with carets.
    CHECK(text.find(worst.object.value == 0 ? "Triangle lower { }\n" : "Triangle upper { }\n") !=
          std::string::npos);
    CHECK(text.find("^^^^^^^^") != std::string::npos);
    CHECK(text.find(", 0 cracks") == std::string::npos);
    const StabilityReport report{leaky, written.scene, written.sources, "a.scene", 640, 480};
    const std::uint64_t cracks = worst.cracks + leaky.objects.back().cracks;
    CHECK(stability_line(report).starts_with("a.scene: " + std::to_string(cracks) + " cracks, "));
    const std::string json = pretty(stability_to_json(report));
    CHECK(json.find("\"clean\": false") != std::string::npos);
}

TEST_CASE("stability: a sound scene is reported clean") {
    const Written written;
    const renderer::Stability good = written.measure(test::sound);
    CHECK(good.clean());
    CHECK(written.text(good).find(" 0 cracks, 0 changed hits, 0 self-hits") != std::string::npos);
    const StabilityReport report{good, written.scene, written.sources, "a.scene", 640, 480};
    CHECK(stability_line(report).starts_with("a.scene: sound, "));
    const std::string json = pretty(stability_to_json(report));
    CHECK(json.find("\"clean\": true") != std::string::npos);
}

TEST_CASE("stability: the first fault is named where there are several kinds") {
    const Written written;
    renderer::Stability stability = written.measure(test::sound);
    auto& entry = stability.objects.front();
    entry.cracks = 2;
    entry.self_hits = 1;
    entry.example = {renderer::StabilityFault::kCrack, {1, 2, 3}, 0};
    CHECK(written.text(stability).find(
              "2 cracks, 1 self-hit: on the Triangle, the first, a crack, at 1 2 3\n") !=
          std::string::npos);
    stability.changes = {43, 28, 0, 8, 7};
    CHECK(written.text(stability).find(
              "along 43 rays float and double met different things first; by 106 binary digits "
              "double is right along 28, float along 0, both along 8, and 7 are too close to "
              "call\n") != std::string::npos);
}

TEST_CASE("stability: the verdict is of what was measured") {
    const Written written;
    renderer::Stability stability = written.measure(test::sound);
    const auto says = [&](std::string_view words) {
        const std::string text = written.text(stability);
        CAPTURE(text);
        return text.find(words) != std::string::npos;
    };
    const auto line = [&] {
        return stability_line({stability, written.scene, written.sources, "a.scene", 640, 480});
    };
    CHECK(says("float is good enough: a pixel is "));
    CHECK(!says("nothing is said"));
    stability.objects.back().hits = 0;
    stability.objects.back().worst.reset();
    CHECK(says("1 object that no ray met, in double either: nothing is said of "));
    CHECK(says("float is good enough for what was measured: a pixel is "));
    CHECK(line().find(", 1 object not met") != std::string::npos);
    stability.complete = false;
    CHECK(says("1 object that no ray has met so far: nothing is said of "));
    CHECK(line().starts_with("a.scene: sound so far, "));
    stability.objects.back().hits = 1;
    CHECK(says("float is good enough for what was measured: a pixel is "));
}

TEST_CASE("stability: where float is too coarse the report says by how much, and what to do") {
    const Written written;
    renderer::Stability stability = written.measure(test::sound);
    auto& worst = stability.objects.front();
    worst.object = ir::ObjectId{1};
    worst.worst = renderer::PixelPrecision{10, 0.125, 0.5, {1, 2, 3}, worst.object};
    const std::string text = written.text(stability);
    CAPTURE(text);
    CHECK(text.starts_with(
        "a.scene:3:5: float is too coarse: a pixel of the Triangle is 0.25 of its steps at 1 2 3: "
        "0.125 wide, where floats are 0.5 apart\n"));
    CHECK(text.find("^^^^^^^^") != std::string::npos);
    CHECK(text.find("--precision double renders") != std::string::npos);
    CHECK(text.find("float is good enough") == std::string::npos);
    CHECK(
        text.ends_with(" 0 cracks, 0 changed hits, 0 self-hits, float too coarse for 1 object\n"));
    const StabilityReport report{stability, written.scene, written.sources, "a.scene", 640, 480};
    CHECK(stability_line(report).starts_with("a.scene: float too coarse for 1 object, "));
    CHECK(pretty(stability_to_json(report)).find("\"clean\": false") != std::string::npos);
}

TEST_CASE("stability: what float lost of a mesh is told in faces, and needles are not") {
    const Written written;
    renderer::Stability stability = written.measure(test::sound);
    using Kind = renderer::PreparationNote::Kind;
    const auto line = [&] {
        return stability_line({stability, written.scene, written.sources, "a.scene", 640, 480});
    };
    const auto ends = [&](std::string_view end) { return line().ends_with(end); };
    auto& entry = stability.objects.front();
    stability.notes = {{Kind::kDegenerate, entry.object, 0, 1}};
    CHECK(ends("at least, 1 object without extent\n"));
    CHECK(written.text(stability).find("float is good enough") != std::string::npos);
    CHECK(written.text(stability).find("has no extent") != std::string::npos);
    // Some faces of a mesh: nothing that anybody would see.
    entry.faces = 9;
    CHECK(ends("steps of float at least\n"));
    CHECK(written.text(stability).find("has no extent") == std::string::npos);
    stability.notes = {{Kind::kFlattened, entry.object, 0, 3}};
    CHECK(ends("steps of float at least\n"));
    CHECK(written.text(stability).find("flat in float") == std::string::npos);
    // Those that can be seen.
    entry.faces_lost = 3;
    CHECK(line().starts_with("a.scene: sound, "));
    CHECK(ends("at least, lost in part: 3 of 9 faces\n"));
    CHECK(written.text(stability).find("flat in float") != std::string::npos);
    CHECK(written.text(stability).find("float is good enough") == std::string::npos);
    // All of them, where double does not see the object either.
    entry.faces_lost = 9;
    CHECK(ends("at least, 1 object out of sight not there in float\n"));
    // Where it does, that is the fault.
    entry.lost = 50;
    entry.example = {renderer::StabilityFault::kLost, {1, 2, 3}, 0};
    CHECK(ends("steps of float at least\n"));
    CHECK(line().starts_with("a.scene: 1 lost object, "));
}

}  // namespace cobble::driver
