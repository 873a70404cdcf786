// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>

#include "tests/ir/support.hpp"

using namespace cobble;
using namespace cobble::ir;
using math::Vec3d;
using test::build;
using test::MemoryFiles;
using test::scene_of;

namespace {

constexpr const char* kCube =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 1 5 8 4\nf 2 3 7 6\n";

void check_near(Vec3d a, Vec3d b, double tolerance = 1e-12) {
    CAPTURE(a.x);
    CAPTURE(a.y);
    CAPTURE(a.z);
    CHECK(length(a - b) <= tolerance);
}

}  // namespace

TEST_CASE("a whole scene becomes records with spans and labels") {
    MemoryFiles files;
    const auto built = build(
        "PerspectiveCamera eye { center 1 2 3 direction 0 0 -2 up 0 3 1 angle 90\n"
        "  aperture 0.5 focusDistance 4 blades 6 shutterOpen 0.25 shutterClose 0.5 }\n"
        "Lights { PointLight lamp { position 1 2 3 color 1 0.5 0 falloff 2 radius 0.1 }\n"
        "  DirectionalLight { direction 0 -2 0 color 1 1 1 angle 180 } }\n"
        "Background { color 0.1 0.2 0.3 ambientLight 0.4 0.5 0.6 }\n"
        "Materials { Material stone { diffuseColor 0.5 0.25 0 shininess 3 textureScale 2 3\n"
        "  textureFilter nearest Noise { color 1 0 0 color 0 1 0 octaves 2 frequency 3 } } }\n"
        "Group { MaterialIndex stone Sphere ball { center 0 1 0 radius 2 } }\n",
        files);
    const Scene& scene = built.scene();
    CHECK(built.lowered.renderable);
    CHECK(scene.camera.label == "eye");
    CHECK(scene.camera.forward == Vec3d{0, 0, -1});
    CHECK(scene.camera.up == Vec3d{0, 1, 0});
    CHECK(scene.camera.right == Vec3d{1, 0, 0});
    CHECK(scene.camera.up_as_written == Vec3d{0, 3, 1});
    CHECK(scene.camera.angle == doctest::Approx(math::Vec3d{1.5707963267948966, 0, 0}.x));
    CHECK(scene.camera.aperture == 0.5);
    CHECK(scene.camera.blades == 6);
    CHECK(scene.camera.shutter_open == 0.25);
    REQUIRE(scene.lights.size() >= 1);
    CHECK(scene.lights[0].label == "lamp");
    CHECK(scene.lights[0].radius == 0.1);
    CHECK(scene.background.ambient == Vec3d{0.4, 0.5, 0.6});
    REQUIRE(scene.materials.size() == 1);
    CHECK(scene.materials[0].label == "stone");
    CHECK(scene.materials[0].texture_filter == TextureFilter::kNearest);
    CHECK(scene.materials[0].texture_scale == math::Vec2d{2, 3});
    CHECK(scene.materials[0].noise.color1 == Vec3d{1, 0, 0});
    CHECK(scene.materials[0].noise.color2 == Vec3d{0, 1, 0});
    CHECK(scene.materials[0].noise.frequency == 3);
    CHECK(scene.materials[0].noise.amplitude == 1);
    REQUIRE(scene.objects.size() == 1);
    CHECK(scene.objects[0].label == "ball");
    CHECK(built.sources->text(scene.objects[0].span) == "Sphere ball { center 0 1 0 radius 2 }");
    CHECK(scene.spheres[0].keys[0].center == Vec3d{0, 1, 0});
}

TEST_CASE("without lights the ambient light is 1 1 1") {
    MemoryFiles files;
    const auto built = build(
        "PerspectiveCamera { center 0 0 9 direction 0 0 -1 up 0 1 0 angle 30 }\n"
        "Background { ambientLight 0.2 0.2 0.2 }\nMaterials { Material { } }\n"
        "Group { MaterialIndex 0 Sphere { center 0 0 0 radius 1 } }",
        files);
    CHECK(built.scene().background.ambient == Vec3d{1, 1, 1});
    CHECK(built.scene().background.color == Vec3d{0.5, 0.5, 0.5});
}

TEST_CASE("objects keep the order of the file, across groups and transforms") {
    MemoryFiles files;
    const auto built = build(
        scene_of(
            "Sphere a { center 0 0 0 radius 1 }\n"
            "Transform { Translate 1 0 0 Group { MaterialIndex 1 Box b { min 0 0 0 max 1 1 1 }\n"
            "  Plane c { normal 0 2 0 offset 4 } } }\n"
            "Triangle d { vertex0 0 0 0 vertex1 1 0 0 vertex2 0 1 0 }",
            "Material { } Material { diffuseColor 1 0 0 }"),
        files);
    const Scene& scene = built.scene();
    REQUIRE(scene.objects.size() == 4);
    std::string order;
    for (const Object& object : scene.objects) order += object.label;
    CHECK(order == "abcd");
    CHECK(scene.objects[0].material.value == 0);
    CHECK(scene.objects[3].material.value == 1);
    for (const Object& object : scene.objects) CHECK(object.placement.count == 0);
    CHECK(scene.boxes[0].min == Vec3d{1, 0, 0});
    CHECK(scene.planes[0].normal == Vec3d{0, 1, 0});
    CHECK(scene.planes[0].offset == 2);
}

TEST_CASE("transforms compose as published") {
    MemoryFiles files;
    const auto center = [&](const char* moves) {
        const auto built = build(
            scene_of(std::string("Transform { ") + moves + " Sphere { center 1 2 3 radius 1 } }"),
            files);
        REQUIRE(built.scene().objects.size() == 1);
        REQUIRE(built.scene().objects[0].placement.count == 0);
        return built.scene().spheres[0].keys[0].center;
    };
    SUBCASE("the one written first is applied last") {
        CHECK(center("Translate 1 0 0 UniformScale 2") == Vec3d{3, 4, 6});
        CHECK(center("UniformScale 2 Translate 1 0 0") == Vec3d{4, 4, 6});
    }
    SUBCASE("rotations are right-handed and exact at quarter turns") {
        CHECK(center("XRotate 90") == Vec3d{1, -3, 2});
        CHECK(center("YRotate 90") == Vec3d{3, 2, -1});
        CHECK(center("ZRotate 90") == Vec3d{-2, 1, 3});
        CHECK(center("Rotate { 0 0 5 90 }") == Vec3d{-2, 1, 3});
        check_near(center("Rotate { 1 1 1 120 }"), {3, 1, 2});
        check_near(center("YRotate 30"),
                   {1 * std::cos(M_PI / 6) + 3 * 0.5, 2, 3 * std::cos(M_PI / 6) - 0.5});
    }
    SUBCASE("a matrix stands column by column and multiplies from the left") {
        // x' = x + 5: the translation is the fourth column. Before it a rotation, after it a scale.
        const char* matrix = "Matrix4f { 1 0 0 0  0 1 0 0  0 0 1 0  5 0 0 1 }";
        CHECK(center((std::string("ZRotate 90 ") + matrix).c_str()) == Vec3d{3, 1, 3});
        CHECK(center((std::string(matrix) + " ZRotate 90").c_str()) == Vec3d{3, 1, 3});
        CHECK(center((std::string(matrix) + " UniformScale 2").c_str()) == Vec3d{7, 4, 6});
    }
    SUBCASE("nesting multiplies outside in") {
        const auto built = build(scene_of("Transform { ZRotate 90 Transform { Translate 5 0 0\n"
                                          "Sphere { center 1 2 3 radius 1 } } }"),
                                 files);
        CHECK(built.scene().spheres[0].keys[0].center == Vec3d{-2, 6, 3});
    }
}

TEST_CASE("a sphere is baked unless its texture would turn or its shape change") {
    MemoryFiles files;
    files.files["scene/t.bmp"] =
        test::bmp(2, 2, [](auto x, auto y) { return (x + 2 * y) * 0x101010U; });
    const auto placements = [&](const char* moves, const char* material) {
        const auto built = build(
            scene_of(std::string("Transform { ") + moves + " Sphere { center 1 2 3 radius 2 } }",
                     material),
            files);
        REQUIRE(built.lowered.diagnostics.empty());
        return built.scene().objects.at(0).placement.count;
    };
    const char* plain = "Material { }";
    const char* textured = "Material { texture t.bmp }";
    CHECK(placements("UniformScale 3", textured) == 0);
    CHECK(placements("YRotate 30", textured) == 1);
    CHECK(placements("YRotate 30", plain) == 0);
    CHECK(placements("UniformScale -1", textured) == 1);
    CHECK(placements("Scale 1 2 1", plain) == 1);
}

TEST_CASE("an instance's unit sphere maps to the sphere as written") {
    MemoryFiles files;
    const auto built =
        build(scene_of("Transform { Scale 1 2 1 Sphere { center 1 2 3 radius 2 } }"), files);
    const Scene& scene = built.scene();
    const Object& object = scene.objects.at(0);
    REQUIRE(object.placement.count == 1);
    CHECK(scene.spheres[object.shape].keys[0].radius == 1);
    const Placement& place = scene.placements[object.placement.first];
    CHECK(place.object_to_world.point({0, 1, 0}) == Vec3d{1, 8, 3});
    check_near(place.world_to_object.point({1, 8, 3}), {0, 1, 0});
}

TEST_CASE("planes carry their texture coordinates along") {
    MemoryFiles files;
    const auto built = build(scene_of("Plane { normal 0 1 0 offset 0 }\n"
                                      "Transform { Translate 0 1 0 YRotate 90 UniformScale 2\n"
                                      "Plane { normal 0 2 0 offset 6 } }"),
                             files);
    const auto& planes = built.scene().planes;
    REQUIRE(planes.size() == 2);
    CHECK(planes[0].u_axis == Vec3d{1, 0, 0});
    CHECK(planes[0].v_axis == Vec3d{0, 0, -1});
    // The point (1, 3, 0) of the plane moves to (0, 7, -2) and keeps u = 1, v = 0.
    const Plane& p = planes[1];
    const Vec3d moved{0, 7, -2};
    CHECK(dot(p.normal, moved) == doctest::Approx(p.offset));
    CHECK(dot(p.u_axis, moved) + p.u_offset == doctest::Approx(1));
    CHECK(dot(p.v_axis, moved) + p.v_offset == doctest::Approx(0));
}

TEST_CASE("a mirrored triangle keeps its front") {
    MemoryFiles files;
    const auto built = build(scene_of("Transform { Scale 1 1 -1\n"
                                      "Triangle { vertex0 0 0 1 vertex1 1 0 1 vertex2 0 1 1 } }"),
                             files);
    const auto& v = built.scene().triangles.at(0).keys.at(0);
    // Its normal +z, carried by the inverse transpose, becomes -z.
    CHECK(cross(v[1] - v[0], v[2] - v[0]) == Vec3d{0, 0, -1});
    CHECK(v[0] == Vec3d{0, 0, -1});
}

TEST_CASE("boxes are baked while their axes stay") {
    MemoryFiles files;
    const auto built =
        build(scene_of("Transform { Translate 1 1 1 Scale 1 2 3 Box { min 0 0 0 max 1 1 1 } }\n"
                       "Transform { YRotate 90 Box { min 0 0 0 max 1 1 1 } }\n"
                       "Transform { Scale -1 1 1 Box { min 0 0 0 max 1 1 1 } }"),
              files);
    const Scene& scene = built.scene();
    REQUIRE(scene.objects.size() == 3);
    CHECK(scene.objects[0].placement.count == 0);
    CHECK(scene.boxes[0].max == Vec3d{2, 3, 4});
    CHECK(scene.objects[1].placement.count == 1);
    CHECK(scene.objects[2].placement.count == 1);
}

TEST_CASE("a mesh is baked when placed once, shared when placed more often") {
    MemoryFiles files;
    files.files["scene/cube.obj"] = kCube;
    SUBCASE("once") {
        const auto built = build(
            scene_of(
                "Transform { Translate 0 5 0 Scale 1 -1 1 TriangleMesh { obj_file cube.obj } }"),
            files);
        const Scene& scene = built.scene();
        REQUIRE(scene.meshes.size() == 1);
        CHECK(scene.objects[0].placement.count == 0);
        CHECK(scene.meshes[0].faces.size() == 12);
        CHECK(scene.meshes[0].positions[2] == Vec3d{1, 4, 0});
        // All faces still look outwards.
        const Vec3d middle{0.5, 4.5, 0.5};
        for (const auto& face : scene.meshes[0].faces) {
            const auto& p = scene.meshes[0].positions;
            const Vec3d a = p[face.corners[0].position];
            const Vec3d b = p[face.corners[1].position];
            const Vec3d c = p[face.corners[2].position];
            CHECK(dot(cross(b - a, c - a), a - middle) > 0);
        }
    }
    SUBCASE("twice") {
        const auto built = build(scene_of("TriangleMesh { obj_file cube.obj }\n"
                                          "Transform { Translate 3 0 0\n"
                                          "TriangleMesh { obj_file ./cube.obj creaseAngle 60 } }"),
                                 files);
        const Scene& scene = built.scene();
        REQUIRE(scene.meshes.size() == 1);
        REQUIRE(scene.objects.size() == 2);
        CHECK(scene.objects[0].placement.count == 1);
        CHECK(scene.objects[1].placement.count == 1);
        CHECK(files.reads["scene/cube.obj"] == 1);
        CHECK(built.sources->text(scene.meshes[0].source).substr(0, 7) == "v 0 0 0");
    }
    SUBCASE("twice with different crease angles") {
        const auto built = build(scene_of("TriangleMesh { obj_file cube.obj creaseAngle 0 }\n"
                                          "TriangleMesh { obj_file cube.obj creaseAngle 100 }"),
                                 files);
        const Scene& scene = built.scene();
        REQUIRE(scene.meshes.size() == 2);
        CHECK(scene.meshes[0].normals.empty());
        CHECK(scene.meshes[1].normals.size() == 8);
        CHECK(files.reads["scene/cube.obj"] == 1);
    }
}

TEST_CASE("motion is sampled at interpolated arguments") {
    MemoryFiles files;
    files.files["scene/t.bmp"] =
        test::bmp(2, 2, [](auto x, auto y) { return (x + 2 * y) * 0x101010U; });
    SUBCASE("a straight way has two keys and no chord error") {
        const auto built = build(scene_of("Transform { Translate 0 0 0 Motion { Translate 3 4 0 }\n"
                                          "Sphere { center 0 0 0 radius 1 } }"),
                                 files);
        const auto& keys = built.scene().spheres.at(0).keys;
        REQUIRE(keys.size() == 2);
        CHECK(keys[0].center == Vec3d{0, 0, 0});
        CHECK(keys[1].center == Vec3d{3, 4, 0});
        CHECK(built.scene().motion_chord_error == 0);
    }
    SUBCASE("a full turn turns once, in segments of at most 15 degrees") {
        const auto built = build(scene_of("Transform { YRotate 0 Motion { YRotate 360 }\n"
                                          "Sphere { center 4 0 0 radius 1 } }"),
                                 files);
        const auto& keys = built.scene().spheres.at(0).keys;
        REQUIRE(keys.size() == 33);
        CHECK(keys[0].center == Vec3d{4, 0, 0});
        CHECK(keys[8].center == Vec3d{0, 0, -4});
        CHECK(keys[16].center == Vec3d{-4, 0, 0});
        CHECK(keys[32].center == Vec3d{4, 0, 0});
        // The sagitta of an arc of 360/32 degrees and radius 4.
        const double sagitta = 4 * (1 - std::cos(M_PI / 32));
        CHECK(built.scene().motion_chord_error == doctest::Approx(sagitta).epsilon(1e-9));
    }
    SUBCASE("nested motions share times, each with the keys it needs") {
        const auto built = build(scene_of("Transform { YRotate 0 Motion { YRotate 60 } Group {\n"
                                          "Sphere { center 2 0 0 radius 1 }\n"
                                          "Transform { YRotate 0 Motion { YRotate 60 } Triangle {\n"
                                          "  vertex0 2 0 0 vertex1 3 0 0 vertex2 2 1 0 } } } }"),
                                 files);
        CHECK(built.scene().spheres.at(0).keys.size() == 5);
        const auto& keys = built.scene().triangles.at(0).keys;
        REQUIRE(keys.size() == 9);
        const double half = 60 * M_PI / 180;
        check_near(keys[4][0], {2 * std::cos(half), 0, -2 * std::sin(half)});
    }
    SUBCASE("what cannot be baked is an instance with a placement per key") {
        const auto built = build(
            scene_of(
                "Transform { XRotate 0 UniformScale 1 Motion { XRotate 30 UniformScale 2 }\n"
                "Box { min 0 0 0 max 1 1 1 } }\n"
                "Transform { ZRotate 0 Motion { ZRotate 90 } Sphere { center 0 0 0 radius 2 } }",
                "Material { texture t.bmp }"),
            files);
        const Scene& scene = built.scene();
        REQUIRE(scene.objects.size() == 2);
        // 30 degrees and ln 2 = 39.7 degrees together need 5 segments, so 8.
        CHECK(scene.objects[0].placement.count == 9);
        CHECK(scene.objects[1].placement.count == 9);
        const Placement& last = scene.placements[scene.objects[0].placement.first + 8];
        check_near(last.object_to_world.point({0, 1, 0}),
                   {0, 2 * std::cos(M_PI / 6), 2 * std::sin(M_PI / 6)});
        CHECK(scene.motion_chord_error > 0);
        CHECK(scene.motion_chord_error < 0.02);
    }
    SUBCASE("a motion of no use is at rest") {
        const auto built = build(scene_of("Transform { Translate 1 0 0 Motion { Translate 1 0 0 }\n"
                                          "Sphere { center 0 0 0 radius 1 } }"),
                                 files);
        CHECK(built.scene().spheres.at(0).keys.size() == 1);
    }
    SUBCASE("very many moving objects share the keys of their frame") {
        std::string objects = "Transform { YRotate 0 Motion { YRotate 15000 } Group {\n";
        for (int i = 0; i < 5000; ++i) objects += "Sphere { center 3 0 0 radius 1 }\n";
        const auto built = build(scene_of(objects + "} }"), files);
        const Scene& scene = built.scene();
        REQUIRE(scene.objects.size() == 5000);
        CHECK(scene.spheres.front().keys.size() == 1025);
        CHECK(scene.objects.front().placement.count == 0);
        CHECK(scene.spheres.back().keys.size() == 1);
        CHECK(scene.objects.back().placement.count == 1025);
        CHECK(scene.placements.size() < 2000);
    }
    SUBCASE("a hundred turns are said to be too many") {
        const auto built = build(scene_of("Transform { YRotate 0 Motion { YRotate 36000 }\n"
                                          "Sphere { center 1 0 0 radius 1 } }"),
                                 files);
        CHECK(built.codes() == std::vector<std::string>{"motion-too-fast"});
        CHECK(built.scene().spheres.at(0).keys.size() == 1025);
    }
}

TEST_CASE("transforms that leave the range of numbers are reported, and their objects left out") {
    MemoryFiles files;
    std::string nested;
    for (int i = 0; i < 11; ++i) nested += "Transform { UniformScale 1e30 ";
    nested += "Sphere { center 0 0 0 radius 1 }" + std::string(11, '}');
    const auto far = build(scene_of(nested + "\nSphere { center 0 0 0 radius 1 }"), files);
    REQUIRE(!far.checked.has_errors());
    CHECK(far.codes() == std::vector<std::string>{"transform-out-of-range"});
    CHECK(far.scene().objects.size() == 1);
    const auto flat = build(scene_of("Transform { Scale 1 0.0000001 1\n"
                                     "Sphere { center 0 0 0 radius 1 } }"),
                            files);
    CHECK(flat.codes() == std::vector<std::string>{"transform-ill-conditioned"});
    CHECK(flat.scene().objects.size() == 1);
}

TEST_CASE("broken parts are left out or substituted, and the rest is kept") {
    MemoryFiles files;
    const auto built = build(
        scene_of(
            "Sphere { center 0 0 }\nTransform { Scale 0 1 1 Sphere { center 0 0 0 radius 1 } }\n"
            "Sphere { center 0 0 0 radius -1 }\nSphere { center 1 1 1 radius 1 }"),
        files);
    CHECK(built.checked.has_errors());
    CHECK(built.lowered.diagnostics.empty());
    REQUIRE(built.scene().objects.size() == 1);
    CHECK(built.scene().spheres[built.scene().objects[0].shape].keys[0].center == Vec3d{1, 1, 1});
    CHECK(built.lowered.renderable);

    const auto bare = build("Group { Sphere { center 0 0 0 radius 1 } }", files);
    CHECK(!bare.lowered.renderable);
    REQUIRE(bare.scene().objects.size() == 1);
    CHECK(bare.scene().materials.at(bare.scene().objects[0].material.value).substituted);
}

TEST_CASE("a million nested transforms are a loop, not a recursion") {
    MemoryFiles files;
    std::string text;
    constexpr int kDepth = 200000;
    for (int i = 0; i < kDepth; ++i) {
        text += i % 2 == 0 ? "Transform { Translate 1 0 0 Group {\n"
                           : "Transform { YRotate 90 Group {\n";
    }
    text += "Sphere { center 0 0 0 radius 1 }\n";
    for (int i = 0; i < kDepth; ++i) text += "} }\n";
    const auto built = build(scene_of(text), files);
    REQUIRE(built.scene().objects.size() == 1);
    // Steps of 1 with quarter turns go round a square and come back.
    CHECK(built.scene().spheres[0].keys[0].center == Vec3d{0, 0, 0});
}

TEST_CASE("what is left out for passing through zero is what the checker reports") {
    const auto is_left_out = [](const std::string& end) {
        MemoryFiles files;
        const auto built = build(scene_of("Transform { Rotate { 0 1 0 0 } Motion { Rotate { " +
                                          end + " 90 } } Sphere { center 1 0 0 radius 1 } }"),
                                 files);
        CHECK(built.checked.has_errors() == built.scene().objects.empty());
        return built.scene().objects.empty();
    };
    CHECK(is_left_out("0 -1 0"));
    CHECK(is_left_out("0 -2.5 0"));
    CHECK(!is_left_out("0.000001 -1 0"));
    CHECK(!is_left_out("0 0 -1"));
}
