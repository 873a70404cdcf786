// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "ir/json.hpp"
#include "tests/ir/support.hpp"

using namespace cobble;
using namespace cobble::ir;
using namespace cobble::test;

TEST_CASE("the scene as JSON") {
    MemoryFiles files;
    files.files["scene/t.bmp"] = bmp(2, 2, [](auto x, auto y) { return (x + 2 * y) * 0x102030U; });
    files.files["scene/m.obj"] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const auto built =
        build(scene_of("Sphere ball { center 0.1 0 0 radius 1 }\n"
                       "Transform { Translate 1 2 3 YRotate 90 Box { min 0 0 0 max 1 1 1 } }\n"
                       "Plane { normal 0 1 0 offset 0 }\nTriangleMesh { obj_file m.obj }\n"
                       "Triangle { vertex0 0 0 0 vertex1 1 0 0 vertex2 0 1 0 }",
                       "Material { texture t.bmp Noise { color 1 1 1 } }"),
              files);
    const std::string text = to_json(built.scene(), *built.sources);
    CHECK(text.substr(0, 18) == "{\n  \"cobble_ir\": 1");
    const auto json = nlohmann::ordered_json::parse(text);
    CHECK(json["source"] == "scene/test.txt");
    CHECK(json["camera"]["angle"] == doctest::Approx(0.5235987755982988));
    REQUIRE(json["objects"].size() == 5);
    CHECK(json["objects"][0]["kind"] == "sphere");
    CHECK(json["objects"][0]["label"] == "ball");
    CHECK(json["objects"][0]["placement"].is_null());
    CHECK(json["spheres"][0]["keys"][0]["center"][0] == 0.1);
    const auto& span = json["objects"][0]["span"];
    CHECK(built.sources->text(built.scene().objects[0].span).size() ==
          span["end"].get<std::size_t>() - span["begin"].get<std::size_t>());
    // Column by column: the third column of a quarter turn about y is +x.
    const auto first = json["objects"][1]["placement"]["first"].get<std::size_t>();
    CHECK(json["placements"][first]["object_to_world"] ==
          nlohmann::ordered_json(
              {0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 1.0}));
    CHECK(json["meshes"][0]["faces"] == 1);
    CHECK(json["images"][0]["path"] == "scene/t.bmp");
    CHECK(json["materials"][0]["noise"]["color1"] == nlohmann::ordered_json({1.0, 1.0, 1.0}));
    CHECK(json["triangles"][0]["keys"][0].size() == 3);
}

TEST_CASE("an empty scene is valid JSON too, and so is one with a strange path") {
    MemoryFiles files;
    const auto built = build("", files);
    CHECK(!built.lowered.renderable);
    CHECK(nlohmann::json::parse(to_json(built.scene(), *built.sources))["objects"].empty());
    files.files["scene/\xff.bmp"] =
        bmp(2, 2, [](auto x, auto y) { return (x + 2 * y) * 0x102030U; });
    const auto strange = build(
        scene_of("Sphere { center 0 0 0 radius 1 }", "Material { texture \"\xff.bmp\" }"), files);
    CHECK(nlohmann::json::accept(to_json(strange.scene(), *strange.sources)));
}
