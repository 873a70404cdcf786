// SPDX-License-Identifier: MIT
// The lint precision-loss. Case files: precision/NAME.scene and, beside it, NAME.expected with what
// is found. COBBLE_UPDATE=1 rewrites the expectations; review them before they are committed.
#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "tests/frontend/case_text.hpp"
#include "tests/ir/support.hpp"
#include "tests/support/corpus.hpp"

using namespace cobble;
using test::build;
using test::MemoryFiles;
using test::scene_of;
using Strings = std::vector<std::string>;

namespace {

/// A square of so many faces a side, each of the size given, from the origin on.
std::string grid(int faces, double size) {
    std::string text;
    for (int y = 0; y <= faces; ++y) {
        for (int x = 0; x <= faces; ++x) {
            text += "v " + std::to_string(x * size) + " " + std::to_string(y * size) + " 0\n";
        }
    }
    for (int y = 0; y < faces; ++y) {
        for (int x = 0; x < faces; ++x) {
            const int at = y * (faces + 1) + x + 1;
            text += "f " + std::to_string(at) + " " + std::to_string(at + 1) + " " +
                    std::to_string(at + faces + 2) + "\n";
        }
    }
    return text;
}

Strings codes_of(const std::string& objects, MemoryFiles& files) {
    const std::string text = scene_of(objects);
    Strings rendered = build(text, files).codes();
    // A lint, which keeps no pixels and makes no normals, finds the same.
    source::SourceMap sources;
    const auto id = sources.add("scene/test.txt", text);
    const auto checked = frontend::check(id, sources.text(id));
    Strings linted;
    for (const auto& d : ir::check_assets(checked, sources, files)) {
        linted.emplace_back(d.code->code);
    }
    CHECK(linted == rendered);
    return rendered;
}

}  // namespace

TEST_CASE("precision-loss: every case gives what its expectation says") {
    const bool update = std::getenv("COBBLE_UPDATE") != nullptr;
    const auto paths = test::files_in(COBBLE_ROOT "/tests/ir/precision", ".scene");
    REQUIRE(!paths.empty());
    for (const std::string& path : paths) {
        CAPTURE(path);
        const std::string text = test::read_file(path);
        MemoryFiles files;
        const std::string found = test::describe(text, build(text, files).lowered.diagnostics);
        const std::string expectation = path.substr(0, path.rfind('.')) + ".expected";
        if (update) {
            std::ofstream(expectation, std::ios::binary) << found;
            continue;
        }
        CHECK(found == test::read_file(expectation));
    }
}

TEST_CASE("precision-loss: a mesh is lost if half of its faces are") {
    MemoryFiles files;
    // Faces of a hundredth, a million away: floats are 0.0625 apart there.
    files.files["scene/fine.obj"] = grid(8, 0.01);
    files.files["scene/coarse.obj"] = grid(8, 1);
    // Eight good faces and a sliver.
    files.files["scene/sliver.obj"] = grid(3, 1) + "v 0 0 0.001\nf 1 2 17\n";
    const Strings lost{"precision-loss"};
    const auto far = [](const std::string& mesh) {
        return "Sphere { center 0 0 0 radius 1 }\nTransform { Translate 1000000.03 0 0\n"
               "TriangleMesh { obj_file " +
               mesh + " } }\n";
    };
    CHECK(codes_of(far("fine.obj"), files) == lost);
    CHECK(codes_of(far("coarse.obj"), files).empty());
    CHECK(codes_of(far("sliver.obj"), files).empty());
    // Twice: now both are instances, and each is judged where it stands.
    CHECK(codes_of(far("fine.obj") + "TriangleMesh { obj_file fine.obj }\n", files) == lost);
    CHECK(codes_of("TriangleMesh { obj_file fine.obj }\n", files).empty());
}

TEST_CASE("precision-loss: of many findings the first are told, and how many more there are") {
    MemoryFiles files;
    std::string objects = "Sphere { center 0 0 0 radius 1 }\n";
    for (int i = 0; i < 100; ++i) {
        objects += "Sphere { center 1000000.3 " + std::to_string(i) + " 0 radius 0.01 }\n";
    }
    const auto found = build(scene_of(objects), files).lowered.diagnostics;
    REQUIRE(found.size() == 20);
    CHECK(found.back().notes.back() == "float loses 80 more objects of the scene");
    CHECK(found.front().notes.back().find("more objects") == std::string::npos);
}

TEST_CASE("precision-loss: renders in double are not warned") {
    MemoryFiles files;
    const std::string text =
        scene_of("Sphere { center 0 0 0 radius 1 }\nSphere { center 1000000.3 0 0 radius 0.01 }\n");
    CHECK(build(text, files).codes() == Strings{"precision-loss"});
    ir::LowerOptions options;
    options.judge_float = false;
    CHECK(build(text, files, options).codes().empty());
}

TEST_CASE("rows 10, 11 and 14: beyond what float is held to a lint says so") {
    MemoryFiles files;
    const auto triangle = [](const std::string& size) {
        return "Triangle { vertex0 0 0 0 vertex1 " + size + " 0 0 vertex2 0 " + size + " 0 }\n";
    };
    const auto squeezed = [](const std::string& factor) {
        return "Transform { XRotate 30 Scale 1 " + factor +
               " 1 YRotate 20 Box { min -1 -1 -1 max 1 1 1 } }\n";
    };
    const Strings lost{"precision-loss"};
    CHECK(codes_of(triangle("1e-15"), files).empty());
    CHECK(codes_of(triangle("1e-40"), files).empty());
    CHECK(codes_of(triangle("1e-46"), files) == lost);
    CHECK(codes_of(triangle("1e30"), files).empty());
    CHECK(codes_of(triangle("1e37"), files) == lost);
    CHECK(codes_of(squeezed("1e-4"), files).empty());
    CHECK(codes_of(squeezed("1e-7"), files) == Strings{"transform-ill-conditioned"});
}

TEST_CASE("precision-loss: its page shows what it is about") {
    const source::DiagnosticCode* code = source::find_code("precision-loss");
    REQUIRE(code != nullptr);
    MemoryFiles files;
    CHECK(build(code->example, files).codes() == Strings{"precision-loss"});
}
