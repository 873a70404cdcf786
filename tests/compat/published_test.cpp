// SPDX-License-Identifier: MIT
// The published pictures, made again from the published scenes.
#include <doctest/doctest.h>

#include <chrono>

#include "renderer/compat/pictures.hpp"
#include "renderer/picture/picture_io.hpp"
#include "tests/compat/support.hpp"
#include "tests/support/corpus.hpp"
#include "tests/support/disk.hpp"

namespace cobble::test {
namespace {

enum class Shows { kColor, kDepth, kNormals };

struct Published {
    const char* picture;
    const char* scene;
    ir::Compat compat;
    Shows shows;
    // What must hold; figures not asked for are 255 levels and 0 of the pixels.
    double mean = 255;
    double equal = 0;
    double within_1 = 0;
    double within_2 = 0;
};

/// 200x200, no flags. Lossless ones must be equal; the others went through JPEG.
const Published kHandoutCasting[] = {
    {"a4_01_scene01_plane", "ocw2012-a4/scene01_plane", ir::Compat::kA4, Shows::kColor, 3},
    {"a4_02_scene02_cube", "ocw2012-a4/scene02_cube", ir::Compat::kA4, Shows::kColor, 0, 1},
    {"a4_03_scene03_sphere", "ocw2012-a4/scene03_sphere", ir::Compat::kA4, Shows::kColor, 0, 1},
    {"a4_04_scene04_axes", "ocw2012-a4/scene04_axes", ir::Compat::kA4, Shows::kColor, 3},
    {"a4_05_scene05_bunny_200", "ocw2012-a4/scene05_bunny_200", ir::Compat::kA4, Shows::kColor, 3},
    {"a4_06_scene06_bunny_1k", "ocw2012-a4/scene06_bunny_1k", ir::Compat::kA4, Shows::kColor, 3},
    {"a4_07_scene07_shine", "ocw2012-a4/scene07_shine", ir::Compat::kA4, Shows::kColor, 3},
    {"a4_08_scene08_c", "ocw2012-a4/scene08_c", ir::Compat::kA4, Shows::kColor, 3},
    {"a4_09_scene09_s", "ocw2012-a4/scene09_s", ir::Compat::kA4, Shows::kColor, 3},
};

/// 300x300 with shadows, 4 bounces, jitter (of another generator) and filter; JPEG.
const Published kHandoutTracing[] = {
    {"a5_06_scene06_bunny_1k", "ocw2012-a5/scene06_bunny_1k", ir::Compat::kA5, Shows::kColor, 4},
    {"a5_10_scene10_sphere", "ocw2012-a5/scene10_sphere", ir::Compat::kA5, Shows::kColor, 4},
    {"a5_11_scene11_cube", "ocw2012-a5/scene11_cube", ir::Compat::kA5, Shows::kColor, 4},
    {"a5_12_scene12_vase", "ocw2012-a5/scene12_vase", ir::Compat::kA5, Shows::kColor, 4},
};

constexpr ir::Compat kProject = ir::Compat::kProject;

/// 200x200, one ray a pixel, lossless.
const Published kProjectCasting[] = {
    {"project_casting_01_plane", "ocw2012-a4/scene01_plane", kProject, Shows::kColor, 255, 0, .995},
    {"project_casting_02_cube", "ocw2012-a4/scene02_cube", kProject, Shows::kColor, 255, 0, .995},
    {"project_casting_03_sphere", "ocw2012-a4/scene03_sphere", kProject, Shows::kColor, 255, 0,
     .995},
    {"project_casting_04_axes", "ocw2012-a4/scene04_axes", kProject, Shows::kColor, 255, 0, .995},
    {"project_casting_05_bunny_200", "ocw2012-a4/scene05_bunny_200", kProject, Shows::kColor, 255,
     0, .995},
    {"project_casting_06_bunny_1k", "ocw2012-a4/scene06_bunny_1k", kProject, Shows::kColor, 255, 0,
     .995},
    {"project_casting_08_c", "ocw2012-a4/scene08_c", kProject, Shows::kColor, 255, 0, .995},
    {"project_normals_01_plane", "ocw2012-a4/scene01_plane", kProject, Shows::kNormals, 255, 0,
     .995},
    {"project_normals_02_cube", "ocw2012-a4/scene02_cube", kProject, Shows::kNormals, 255, 0, .995},
    {"project_normals_03_sphere", "ocw2012-a4/scene03_sphere", kProject, Shows::kNormals, 255, 0,
     .995},
    {"project_normals_04_axes", "ocw2012-a4/scene04_axes", kProject, Shows::kNormals, 255, 0, .995},
    {"project_depth_8_18_01_plane", "ocw2012-a4/scene01_plane", kProject, Shows::kDepth, 255, 0,
     .995},
    {"project_depth_8_18_02_cube", "ocw2012-a4/scene02_cube", kProject, Shows::kDepth, 255, 0,
     .995},
    {"project_depth_8_18_03_sphere", "ocw2012-a4/scene03_sphere", kProject, Shows::kDepth, 255, 0,
     .995},
};

/// 150x150, shadows and 4 bounces, one ray a pixel, lossless.
const Published kProjectTracing[] = {
    {"project_tracing_10_sphere", "ocw2012-a5/scene10_sphere", kProject, Shows::kColor, 255, 0, 0,
     .98},
    {"project_tracing_11_cube", "ocw2012-a5/scene11_cube", kProject, Shows::kColor, 255, 0, 0, .98},
};

renderer::Plane32 shown(const renderer::Picture& picture, const Published& published) {
    switch (published.shows) {
        case Shows::kDepth:
            return renderer::compat_depth_picture(picture.depth, published.compat, 8, 18);
        case Shows::kNormals:
            return renderer::compat_normals_picture(picture.normals, published.compat);
        case Shows::kColor:
            break;
    }
    return picture.color;
}

void check_published(const Published& published, renderer::Settings settings) {
    const std::filesystem::path root = corpus_or_skip();
    if (root.empty()) return;
    const std::string name = published.picture;
    CAPTURE(name);
    ir::LowerOptions options;
    options.compat = published.compat;
    options.casting = settings.compat.casting;
    const LoadedScene loaded = load_scene(root / (std::string(published.scene) + ".txt"), options);
    REQUIRE(loaded.lowered.renderable);
    CHECK(loaded.lowered.diagnostics.empty());

    settings.want_depth = published.shows == Shows::kDepth;
    settings.want_normals = published.shows == Shows::kNormals;
    const auto start = std::chrono::steady_clock::now();
    const renderer::Picture picture = render(loaded.lowered.scene, settings);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    REQUIRE(picture.complete);

    const std::string file = file_text(root / "images" / (name + ".png"));
    const renderer::Decoded reference = renderer::decode(file);
    REQUIRE(reference.error == "");
    const renderer::Plane32 ours = shown(picture, published);
    const Levels levels = levels_between(ours, reference.plane);
    write_sheet(name, ours, reference.plane);
    MESSAGE(name << ": mean " << levels.mean << " levels, maximum " << levels.maximum << ", equal "
                 << 100 * levels.equal << " %, within 1 " << 100 * levels.within_1
                 << " %, within 2 " << 100 * levels.within_2 << " %, " << seconds << " s");
    CHECK(levels.mean <= published.mean);
    // Sums of many parts of 1 round.
    constexpr double kRounding = 1e-9;
    CHECK(levels.equal >= published.equal - kRounding);
    CHECK(levels.within_1 >= published.within_1 - kRounding);
    CHECK(levels.within_2 >= published.within_2 - kRounding);
}

renderer::Settings sized(std::uint32_t size) {
    renderer::Settings settings;
    settings.width = size;
    settings.height = size;
    return settings;
}

TEST_SUITE_BEGIN("corpus");

TEST_CASE("the handout's ray casting") {
    for (const Published& published : kHandoutCasting) check_published(published, sized(200));
}

TEST_CASE("the handout's ray tracing") {
    renderer::Settings settings = sized(300);
    settings.compat.shadows = settings.compat.jitter = settings.compat.filter = true;
    settings.bounces = 4;
    for (const Published& published : kHandoutTracing) check_published(published, settings);
}

TEST_CASE("the project's ray casting, normals and depth") {
    renderer::Settings settings = sized(200);
    settings.compat.casting = true;
    for (const Published& published : kProjectCasting) check_published(published, settings);
}

TEST_CASE("the project's ray tracing") {
    renderer::Settings settings = sized(150);
    settings.compat.shadows = true;
    settings.bounces = 4;
    for (const Published& published : kProjectTracing) check_published(published, settings);
}

TEST_SUITE_END();

}  // namespace
}  // namespace cobble::test
