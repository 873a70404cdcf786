// SPDX-License-Identifier: MIT
// Our own scenes as each published program shows them: hashes of every bit and mean colours,
// written down in golden.expected, so that the programs' ways are held to what they are where there
// are no published pictures to compare with. COBBLE_UPDATE=1 writes them anew.
#include <doctest/doctest.h>

#include <array>
#include <iomanip>
#include <set>
#include <sstream>
#include <string>

#include "renderer/compat/pictures.hpp"
#include "tests/compat/support.hpp"
#include "tests/support/golden.hpp"

namespace cobble::test {
namespace {

/// Paths from the root; the first holds nearly all that the programs differ in.
constexpr std::array kScenes = {"tests/compat/still_life", "scenes/basics/phong",
                                "scenes/basics/transforms", "scenes/basics/mirror_glass",
                                "scenes/basics/environment"};

struct Program {
    const char* name;
    ir::Compat compat;
    bool casting = false;
    bool all_flags = false;  ///< shadows, jitter and filter
    bool pixelated = false;
};
constexpr Program kPrograms[] = {
    {"a4", ir::Compat::kA4},
    {"a5", ir::Compat::kA5},
    {"a5-shadows-jitter-filter", ir::Compat::kA5, false, true},
    {"fa2016", ir::Compat::kFa2016},
    {"fa2016-shadows-jitter-filter", ir::Compat::kFa2016, false, true},
    {"project", ir::Compat::kProject},
    {"project-shadows-jitter-filter", ir::Compat::kProject, false, true},
    {"project-casting", ir::Compat::kProject, true},
    {"project-casting-pixelated", ir::Compat::kProject, true, false, true},
};

void add_line(std::ostream& out, const std::string& what, const renderer::Plane32& plane) {
    BitsHash hash;
    hash.add(plane.values);
    std::array<double, 3> sum{};
    for (std::size_t i = 0; i < plane.values.size(); ++i) {
        sum[i % plane.channels] += static_cast<double>(plane.values[i]);
    }
    out << what << ' ' << hash.text() << " mean";
    const double pixels = static_cast<double>(plane.width) * plane.height;
    for (std::uint32_t c = 0; c < plane.channels; ++c) out << ' ' << sum[c] / pixels;
    out << '\n';
}

std::string pictures_of(const Program& program, const std::string& path) {
    ir::LowerOptions options;
    options.compat = program.compat;
    options.casting = program.casting;
    const LoadedScene loaded =
        load_scene(std::filesystem::path(COBBLE_ROOT) / (path + ".scene"), options);
    REQUIRE(loaded.lowered.renderable);

    renderer::Settings settings;
    // Not square: some programs stretch.
    settings.width = 40;
    settings.height = 30;
    settings.compat.casting = program.casting;
    settings.compat.pixelated = program.pixelated;
    settings.compat.shadows = settings.compat.jitter = settings.compat.filter = program.all_flags;
    settings.want_depth = settings.want_normals = true;
    const renderer::Picture picture = render(loaded.lowered.scene, settings);
    REQUIRE(picture.complete);

    std::ostringstream out;
    out << std::fixed << std::setprecision(4);
    const std::string what = std::string(program.name) + ' ' + path.substr(path.rfind('/') + 1);
    add_line(out, what + " color", picture.color);
    // Depth and normals are of the scene and the camera alone: flags of the light change nothing.
    if (program.all_flags || program.pixelated) return out.str();
    constexpr double kNear = 2;
    constexpr double kFar = 20;
    add_line(out, what + " depth",
             renderer::compat_depth_picture(picture.depth, program.compat, kNear, kFar));
    add_line(out, what + " normals",
             renderer::compat_normals_picture(picture.normals, program.compat));
    return out.str();
}

TEST_CASE("our scenes have the bits that are written down under each published program") {
    std::string all;
    for (const Program& program : kPrograms) {
        for (const char* scene : kScenes) all += pictures_of(program, scene);
    }
    check_golden("tests/compat/golden.expected", all);
}

TEST_CASE("the scenes tell the published programs apart") {
    // What two programs show alike in every scene would not be held by the hashes.
    std::set<std::string> different;
    for (const Program& program : kPrograms) {
        std::string pictures;
        for (const char* scene : kScenes) {
            const std::string lines = pictures_of(program, scene);
            const std::size_t color = lines.find(" color");
            pictures += lines.substr(color, lines.find('\n') - color);
        }
        different.insert(pictures);
    }
    CHECK(different.size() == std::size(kPrograms));
}

}  // namespace
}  // namespace cobble::test
