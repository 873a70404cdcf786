// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <set>

#include "ir/hash.hpp"
#include "ir/output/sha256.hpp"
#include "tests/ir/support.hpp"

using namespace cobble;
using namespace cobble::ir;
using namespace cobble::test;

namespace {

std::string sha(const std::string& text, std::size_t step = 1000) {
    Sha256 sum;
    for (std::size_t i = 0; i < text.size(); i += step) {
        sum.add(text.data() + i, std::min(step, text.size() - i));
    }
    return to_hex(sum.finish());
}

void add_files(MemoryFiles& files) {
    files.files["scene/t.bmp"] = bmp(2, 2, [](auto x, auto y) { return (x + 2 * y) * 0x102030U; });
    files.files["scene/copy.bmp"] = files.files["scene/t.bmp"];
    files.files["scene/other.bmp"] =
        bmp(2, 2, [](auto x, auto y) { return (x + 2 * y) * 0x102031U; });
    files.files["scene/m.obj"] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    files.files["scene/same.obj"] = "# the same\r\nv 0 0 0\nv 9 9 9\nv 1 0 0\nv 0 1 0\nf 1 3 4";
    files.files["scene/other.obj"] = "v 0 0 0\nv 1 0 0\nv 0 1 0.5\nf 1 2 3\n";
}

}  // namespace

TEST_CASE("SHA-256 agrees with the standard's examples") {
    CHECK(sha("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    CHECK(sha("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    CHECK(sha("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
          "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    const std::string million(1000000, 'a');
    const char* const expected = "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0";
    CHECK(sha(million) == expected);
    CHECK(sha(million, 7) == expected);
    CHECK(sha(million, 64) == expected);
}

TEST_CASE("what means the same has one hash") {
    MemoryFiles files;
    add_files(files);
    const auto h = [&](const std::string& text) {
        const auto built = build(text, files);
        REQUIRE(!built.checked.has_errors());
        return hash(built.scene());
    };
    const std::string camera =
        "PerspectiveCamera { center 0 0 10 direction 0 0 -1 up 0 1 0 angle 30 }\n";
    const std::string materials =
        "Materials { Material { diffuseColor 1 0 0 texture t.bmp } Material { shininess 3 } }\n";
    const std::string group =
        "Group { MaterialIndex 0 Sphere { center 0 1 0 radius 2 } TriangleMesh { obj_file m.obj } "
        "}";
    const std::string base = h(camera + materials + group);
    CHECK(base.size() == 64);
    SUBCASE("layout, comments, order of fields and sections, labels") {
        CHECK(h(group + "// the end\n" + materials + camera) == base);
        CHECK(h("PerspectiveCamera eye { angle 30.0\n up 0 1 0 direction 0 0 -1e0 center 0 0 10 }" +
                materials + group) == base);
    }
    SUBCASE("defaults written out") {
        CHECK(h("PerspectiveCamera { center 0 0 10 direction 0 0 -2 up 0 1 0 angle 30 aperture 0 "
                "blades 5 shutterOpen 0.5 }" +
                materials + group) == base);
    }
    SUBCASE("minus zero") {
        CHECK(h(camera + materials +
                "Group { MaterialIndex 0 Sphere { center -0 1 -0.0 radius 2 } "
                "TriangleMesh { obj_file m.obj } }") == base);
    }
    SUBCASE("unused materials and the numbers of used ones") {
        CHECK(h(camera +
                "Materials { Material { } Material here { texture t.bmp diffuseColor #ff0000 } }\n"
                "Group { MaterialIndex here Sphere { center 0 1 0 radius 2 } "
                "TriangleMesh { obj_file m.obj } }") == base);
    }
    SUBCASE("files of other names and layout with the same content") {
        CHECK(h(camera + "Materials { Material { diffuseColor 1 0 0 texture copy.bmp } }\n" +
                "Group { MaterialIndex 0 Sphere { center 0 1 0 radius 2 } "
                "TriangleMesh { obj_file same.obj } }") == base);
    }
    SUBCASE("groups and transforms that change nothing") {
        CHECK(h(camera + materials +
                "Group { MaterialIndex 0 Group { Transform { Translate 0 1 0 Sphere { center 0 0 0 "
                "radius 2 } } } TriangleMesh { obj_file m.obj } }") == base);
    }
}

TEST_CASE("what means something else has another hash") {
    MemoryFiles files;
    add_files(files);
    for (const char* face : {"left", "right", "up", "down", "front", "back"}) {
        files.files["scene/cube/" + std::string(face) + ".bmp"] = files.files["scene/t.bmp"];
    }
    std::set<std::string> hashes;
    std::size_t count = 0;
    const auto add = [&](const std::string& material, const std::string& object,
                         const std::string& extra = "", const LowerOptions& options = {}) {
        const auto built =
            build(scene_of(object, "Material { " + material + " }") + extra, files, options);
        REQUIRE(!built.checked.has_errors());
        hashes.insert(hash(built.scene()));
        ++count;
        CAPTURE(material);
        CAPTURE(object);
        CAPTURE(extra);
        CHECK(hashes.size() == count);
    };
    const std::string sphere = "Sphere { center 0 0 0 radius 1 }";
    add("", sphere);
    add("", "Sphere { center 0 0 0 radius 2 }");
    add("", "Sphere { center 0 0 1 radius 1 }");
    add("", "Plane { normal 0 1 0 offset 0 }");
    add("", "Plane { normal 0 1 0 offset 1 }");
    add("", "Box { min 0 0 0 max 1 1 1 }");
    add("", "Triangle { vertex0 0 0 0 vertex1 1 0 0 vertex2 0 1 0 }");
    add("", "TriangleMesh { obj_file m.obj }");
    add("", "TriangleMesh { obj_file other.obj }");
    add("", "Transform { Scale 1 2 1 " + sphere + " }");
    add("", "Transform { Translate 0 0 0 Motion { Translate 1 0 0 } " + sphere + " }");
    add("", sphere + sphere);
    add("diffuseColor 1 0 0", sphere);
    add("specularColor 1 0 0", sphere);
    add("shininess 1", sphere);
    add("refractionIndex 1", sphere);
    add("texture t.bmp", sphere);
    add("texture other.bmp", sphere);
    add("normal t.bmp", sphere);
    add("bump t.bmp", sphere);
    add("texture t.bmp textureFilter nearest", sphere);
    add("texture t.bmp textureScale 2 1", sphere);
    add("cubeMap cube", sphere);
    add("cubeMap cube textureFilter nearest", sphere);
    add("Noise { color 1 1 1 octaves 1 }", sphere);
    add("Noise { color 1 1 1 octaves 2 }", sphere);
    add("Noise { color 1 1 1 octaves 1 amplitude 2 }", sphere);
    add("", sphere, "Background { color 0 0 0 }");
    add("", sphere, "Background { ambientLight 0 0 0.5 }");
    LowerOptions a4;
    a4.compat = Compat::kA4;
    add("", sphere, "", a4);
}
