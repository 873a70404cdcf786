// SPDX-License-Identifier: MIT
// What a scene is told about the files that it names.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "tests/ir/image_files.hpp"
#include "tests/ir/support.hpp"

using namespace cobble;
using namespace cobble::ir;
using namespace cobble::test;

namespace {

using Strings = std::vector<std::string>;

const char* const kSphere = "Sphere { center 0 0 0 radius 1 }";
const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::string red(std::uint32_t width, std::uint32_t height) {
    return bmp(width, height, [](auto, auto) { return 0xff0000U; });
}

Built with_texture(MemoryFiles& files, const std::string& field, const LowerOptions& options = {}) {
    return build(scene_of(kSphere, "Material { " + field + " }"), files, options);
}
Built with_mesh(MemoryFiles& files, const std::string& text, const std::string& material = {}) {
    files.files["scene/m.obj"] = text;
    return build(scene_of("TriangleMesh { obj_file m.obj }", material), files);
}
std::string named(const Built& built, std::size_t i) {
    return std::string(built.sources->text(built.lowered.diagnostics.at(i).span));
}

void add_cube(MemoryFiles& files, const std::string& folder, const std::string& ending,
              const std::string& file) {
    for (const char* face : {"left", "right", "up", "down", "front", "back"}) {
        files.files["scene/" + folder + "/" + face + ending] = file;
    }
}

}  // namespace

TEST_CASE("a missing texture is reported at its path and shown as a magenta checker") {
    MemoryFiles files;
    const auto built = build(scene_of(kSphere,
                                      "Material { texture tex/no.bmp }\n"
                                      "Material { texture tex/no.bmp normal tex/no.bmp }"),
                             files);
    REQUIRE(built.codes() == Strings{"asset-missing"});
    const auto& diagnostic = built.lowered.diagnostics[0];
    CHECK(named(built, 0) == "tex/no.bmp");
    CHECK(diagnostic.message == "texture 'tex/no.bmp' does not exist");
    CHECK(diagnostic.notes == Strings{"tried 'scene/tex/no.bmp'"});
    CHECK(diagnostic.related.size() == 2);
    CHECK(files.reads["scene/tex/no.bmp"] == 1);
    const Scene& scene = built.scene();
    REQUIRE(scene.materials[0].texture.valid());
    const Image& checker = scene.images[scene.materials[0].texture.value];
    CHECK(checker.missing);
    CHECK(checker.bytes.size() == 8 * 8 * 3);
    CHECK(scene.materials[1].texture == scene.materials[0].texture);
    CHECK(!scene.materials[1].normal_map.valid());
}

TEST_CASE("corrupt and oversized pictures") {
    MemoryFiles files;
    files.files["scene/cut.bmp"] = red(4, 4).substr(0, 60);
    files.files["scene/text.png"] = "hello, I am no picture";
    files.files["scene/huge.bmp"] = bmp_header(100000, 100000, 24, 0);
    auto built = with_texture(files, "texture cut.bmp");
    REQUIRE(built.codes() == Strings{"asset-corrupt"});
    CHECK(built.lowered.diagnostics[0].message ==
          "texture 'cut.bmp' cannot be decoded: the file ends too early");
    built = with_texture(files, "normal text.png");
    REQUIRE(built.codes() == Strings{"asset-corrupt"});
    CHECK(built.lowered.diagnostics[0].message ==
          "normal map 'text.png' cannot be decoded: it is no BMP, PNG, JPEG, TGA or HDR picture");
    built = with_texture(files, "bump huge.bmp");
    CHECK(built.codes() == Strings{"asset-too-large"});
    LowerOptions options;
    options.limits.file_bytes = 10;
    built = with_texture(files, "texture cut.bmp", options);
    REQUIRE(built.codes() == Strings{"asset-too-large"});
    CHECK(built.lowered.diagnostics[0].message == "texture 'cut.bmp' is larger than 10 bytes");
}

TEST_CASE("what is no file is unreadable, with the system's reason") {
    class Folder : public MemoryFiles {
      public:
        source::ReadResult read(std::string_view, std::uint64_t) override {
            return {source::ReadStatus::kNotAFile, {}, "it is a folder"};
        }
    } files;
    const auto built = with_texture(files, "texture tex");
    REQUIRE(built.codes() == Strings{"asset-unreadable"});
    CHECK(built.lowered.diagnostics[0].message == "texture 'tex' cannot be read: it is a folder");
}

TEST_CASE("all assets of a scene keep to one limit of bytes") {
    MemoryFiles files;
    for (const char* name : {"a", "b", "c"}) {
        files.files["scene/" + std::string(name) + ".bmp"] = red(8, 4);
    }
    files.files["scene/n.hdr"] = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\1\2\3\x80";
    const std::string scene = scene_of(kSphere,
                                       "Material { texture a.bmp }\nMaterial { texture b.bmp }\n"
                                       "Material { texture ./a.bmp bump b.bmp }\n"
                                       "Material { texture c.bmp }");
    LowerOptions options;
    options.limits.asset_bytes = std::uint64_t{3} * 8 * 4 * 3;
    CHECK(build(scene, files, options).codes().empty());
    --options.limits.asset_bytes;
    auto built = build(scene, files, options);
    REQUIRE(built.codes() == Strings{"asset-too-large"});
    const auto& diagnostic = built.lowered.diagnostics[0];
    CHECK(named(built, 0) == "c.bmp");
    CHECK(diagnostic.message ==
          "texture 'c.bmp' is too large: it takes 96 bytes (8 x 4 pixels), and of the 287 bytes "
          "for all assets of a scene together 95 are left");
    CHECK(diagnostic.notes == Strings{"tried 'scene/c.bmp'"});
    CHECK(built.scene().images.back().missing);

    // Floats take four times the bytes, whether they come from the file or are made.
    options.limits.asset_bytes = 12;
    CHECK(with_texture(files, "texture n.hdr", options).codes().empty());
    options.limits.asset_bytes = 11;
    CHECK(with_texture(files, "texture n.hdr", options).codes() == Strings{"asset-too-large"});
    options.limits.asset_bytes = 96;
    CHECK(with_texture(files, "texture a.bmp", options).codes().empty());
    options.decode_srgb = true;
    CHECK(with_texture(files, "texture a.bmp", options).codes() == Strings{"asset-too-large"});
    options.limits.asset_bytes = 96 * 5;
    CHECK(with_texture(files, "texture a.bmp bump a.bmp", options).codes().empty());
    --options.limits.asset_bytes;
    CHECK(with_texture(files, "texture a.bmp bump a.bmp", options).codes() ==
          Strings{"asset-too-large"});
}

TEST_CASE("a picture that claims much is not decoded for want of room") {
    MemoryFiles files;
    // 300 million pixels' worth of zeros in some 100 KB would be caught on the way; this is told
    // from its header.
    files.files["scene/bomb.png"] = png_of_stream(8000, 8000, 2, deflate_zeros(1U << 20));
    LowerOptions options;
    options.limits.asset_bytes = 100'000'000;
    const auto built = with_texture(files, "texture bomb.png", options);
    REQUIRE(built.codes() == Strings{"asset-too-large"});
    CHECK(built.lowered.diagnostics[0].message ==
          "texture 'bomb.png' is too large: it takes 192000000 bytes (8000 x 8000 pixels), and of "
          "the 100000000 bytes for all assets of a scene together 100000000 are left");
}

TEST_CASE("meshes count to the bytes of all assets, with their text") {
    MemoryFiles files;
    files.files["scene/m.obj"] = kTriangle;
    files.files["scene/fan.obj"] = kTriangle + "f 1 2 3 1 2 3 \\\n1 2 3\nvn 0 0 1\nvt 0 0\n";
    const auto codes = [&](const char* name, std::uint64_t limit) {
        LowerOptions options;
        options.limits.asset_bytes = limit;
        return build(scene_of(std::string("TriangleMesh { obj_file ") + name + " }"), files,
                     options)
            .codes();
    };
    const std::uint64_t triangle = kTriangle.size() + std::uint64_t{3} * 24 + 40;
    CHECK(codes("m.obj", triangle).empty());
    CHECK(codes("m.obj", triangle - 1) == Strings{"asset-too-large"});
    const std::uint64_t fan = files.files["scene/fan.obj"].size() + 3 * 24 + 8 * 40 + 24 + 16;
    // Texture coordinates are taken for larger than they are.
    CHECK(codes("fan.obj", fan + 8) == Strings{"asset-mesh-degenerate-face"});
    CHECK(codes("fan.obj", fan - 1) == Strings{"asset-too-large"});
}

TEST_CASE("an image is read and kept once, as a texture and as data") {
    MemoryFiles files;
    files.files["scene/t.bmp"] = bmp(2, 2, [](auto x, auto y) { return (x + 2 * y) * 0x102030U; });
    const auto built = build(scene_of(kSphere,
                                      "Material { bump t.bmp }\n"
                                      "Material { texture t.bmp normal ./t.bmp }\n"
                                      "Material { texture t.bmp bump t.bmp }"),
                             files);
    CHECK(built.codes().empty());
    CHECK(files.reads["scene/t.bmp"] == 1);
    const Scene& scene = built.scene();
    REQUIRE(scene.images.size() == 1);
    CHECK(scene.images[0].tag == ColorTag::kDisplay);
    CHECK(!scene.images[0].constant);
    CHECK(scene.materials[1].texture == scene.materials[1].normal_map);
    CHECK(scene.materials[2].bump_map == scene.materials[0].bump_map);
    const auto data = build(scene_of(kSphere, "Material { bump t.bmp }"), files);
    CHECK(data.scene().images.at(0).tag == ColorTag::kData);
}

TEST_CASE("cube maps take the first ending that all six faces have") {
    MemoryFiles files;
    add_cube(files, "sky", ".bmp", red(2, 2));
    const auto sky = [&] {
        return build(
            "Background { cubeMap sky }\n" + scene_of(kSphere, "Material { cubeMap sky/ }"), files);
    };
    auto built = sky();
    CHECK(built.codes().empty());
    REQUIRE(built.scene().cube_maps.size() == 1);
    CHECK(built.scene().materials[0].cube_map == built.scene().background.cube_map);
    CHECK(built.scene().images.size() == 6);
    files.files["scene/sky/left.png"] = red(4, 4);
    built = sky();
    CHECK(built.codes().empty());
    CHECK(built.scene().images.at(0).path == "scene/sky/left.bmp");
    add_cube(files, "sky", ".png", red(4, 4));
    CHECK(sky().scene().images.at(0).width == 4);
}

TEST_CASE("cube maps without a face, or of uneven faces") {
    MemoryFiles files;
    const auto sky = [&] {
        return build("Background { cubeMap sky }\n" + scene_of(kSphere), files);
    };
    auto built = sky();
    REQUIRE(built.codes() == Strings{"asset-cube-map-face"});
    CHECK(built.lowered.diagnostics[0].message == "cube map 'sky' does not exist");
    CHECK(named(built, 0) == "sky");
    CHECK(built.lowered.diagnostics[0].notes[0].find(".hdr .png .jpg .jpeg .tga .bmp") !=
          std::string::npos);
    CHECK(!built.scene().background.cube_map.valid());

    add_cube(files, "sky", ".bmp", red(2, 2));
    files.files.erase("scene/sky/down.bmp");
    built = sky();
    REQUIRE(built.codes() == Strings{"asset-cube-map-face"});
    CHECK(built.lowered.diagnostics[0].message == "cube map 'sky' has no face 'down.bmp'");

    files.files["scene/sky/down.bmp"] = red(2, 3);
    built = sky();
    REQUIRE(built.codes() == Strings{"asset-cube-map-shape"});
    CHECK(built.lowered.diagnostics[0].message == "cube map face 'down.bmp' is 2 x 3, not square");

    files.files["scene/sky/down.bmp"] = red(3, 3);
    built = sky();
    REQUIRE(built.codes() == Strings{"asset-cube-map-shape"});
    CHECK(built.lowered.diagnostics[0].message ==
          "cube map face 'down.bmp' is 3 x 3, but 'left.bmp' is 2 x 2");

    files.files["scene/sky/down.bmp"] = "BM";
    CHECK(sky().codes() == Strings{"asset-corrupt"});
}

TEST_CASE("problems of a mesh stand in the mesh, with the scene's path beside them") {
    MemoryFiles files;
    SUBCASE("missing") {
        const auto built = build(scene_of("TriangleMesh { obj_file no.obj }"), files);
        REQUIRE(built.codes() == Strings{"asset-missing"});
        CHECK(built.lowered.diagnostics[0].message == "mesh 'no.obj' does not exist");
        CHECK(named(built, 0) == "no.obj");
        CHECK(!built.lowered.renderable);
    }
    SUBCASE("an index out of range") {
        const auto built = with_mesh(files, kTriangle + "f 1 2 7\n");
        REQUIRE(built.codes() == Strings{"asset-mesh-index"});
        const auto& diagnostic = built.lowered.diagnostics[0];
        CHECK(named(built, 0) == "7");
        CHECK(built.sources->path(diagnostic.span.source) == "scene/m.obj");
        REQUIRE(diagnostic.related.size() == 1);
        CHECK(built.sources->text(diagnostic.related[0].span) == "m.obj");
        CHECK(built.scene().meshes.at(0).faces.size() == 1);
    }
    SUBCASE("numbers, statements, faces") {
        CHECK(with_mesh(files, kTriangle + "v 1 2 x\n").codes() == Strings{"asset-mesh-number"});
        CHECK(with_mesh(files, kTriangle + "v 1 2\n").codes() == Strings{"asset-mesh-statement"});
        CHECK(with_mesh(files, kTriangle + "f 1 2\n").codes() == Strings{"asset-mesh-face"});
    }
    SUBCASE("a texture coordinate that is no number") {
        for (const std::string bad : {"nan", "1e39"}) {
            CAPTURE(bad);
            const auto built = with_mesh(files, kTriangle + "vt " + bad + " 0\nf 1/1 2/1 3/1\n");
            REQUIRE(built.codes() == Strings{"asset-mesh-number"});
            const auto& diagnostic = built.lowered.diagnostics[0];
            CHECK(named(built, 0) == bad);
            CHECK(built.sources->path(diagnostic.span.source) == "scene/m.obj");
            REQUIRE(diagnostic.related.size() == 1);
            CHECK(built.sources->text(diagnostic.related[0].span) == "m.obj");
            CHECK(built.scene().meshes.at(0).faces.size() == 1);
        }
    }
    SUBCASE("unknown keywords") {
        const auto built = with_mesh(files, kTriangle + "s off\nhello 1 2\nhello 3\n");
        REQUIRE(built.codes() == Strings{"asset-mesh-keyword"});
        CHECK(built.lowered.diagnostics[0].severity == source::Severity::kWarning);
        CHECK(named(built, 0) == "hello");
        CHECK(built.lowered.renderable);
        const auto many = with_mesh(files, kTriangle + "a\nb\nc\nd\ne\nh\n");
        REQUIRE(many.codes().size() == 5);
        CHECK(many.lowered.diagnostics[4].notes == Strings{"other words are not listed"});
        const auto all = with_mesh(files, kTriangle + "a\nb\nc\nd\ne\na\n");
        REQUIRE(all.codes().size() == 5);
        CHECK(all.lowered.diagnostics[4].notes.empty());
    }
    SUBCASE("too many faces") {
        files.files["scene/m.obj"] = kTriangle + "f 1 2 3\nf 1 2 3\n";
        LowerOptions options;
        options.limits.mesh_faces = 2;
        const auto built = build(scene_of("TriangleMesh { obj_file m.obj }"), files, options);
        CHECK(built.codes() == Strings{"asset-mesh-too-many-faces"});
    }
    SUBCASE("an index of four billion takes no memory") {
        const auto built = with_mesh(files, kTriangle + "f 4000000000 1 2\nf 4294967295 1 2\n");
        CHECK(built.codes() == Strings{"asset-mesh-index", "asset-mesh-index"});
    }
    SUBCASE("no faces") {
        const auto built = with_mesh(files, "v 0 0 0\n");
        CHECK(built.codes() == Strings{"asset-mesh-empty"});
        CHECK(built.scene().objects.empty());
    }
    SUBCASE("degenerate faces are kept and told of once") {
        const auto built = with_mesh(files, kTriangle + "f 1 2 2\nf 1 1 1\n");
        REQUIRE(built.codes() == Strings{"asset-mesh-degenerate-face"});
        CHECK(built.lowered.diagnostics[0].message == "2 of 3 faces of the mesh have no area");
        CHECK(named(built, 0) == "f 1 2 2");
        CHECK(built.scene().meshes.at(0).faces.size() == 3);
    }
    SUBCASE("normals without length") {
        const auto built =
            with_mesh(files,
                      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nvn 0 0 2\nf 1//1 2//2 3//2\n"
                      "f 1//2 2//2 3//2\n");
        REQUIRE(built.codes() == Strings{"asset-mesh-zero-normal"});
        CHECK(built.scene().meshes.at(0).faces[0].corners[1].normal == Mesh::kNone);
        CHECK(built.scene().meshes.at(0).faces[1].corners[1].normal == 1);
        CHECK(built.scene().meshes.at(0).normals[1] == math::Vec3d{0, 0, 1});
    }
    SUBCASE("many problems are counted") {
        std::string text = kTriangle;
        for (int i = 0; i < 100; ++i) text += "f 1 2 9\n";
        const auto built = with_mesh(files, text);
        REQUIRE(built.lowered.diagnostics.size() == 20);
        CHECK(built.lowered.diagnostics[19].notes == Strings{"and 80 more errors in this file"});
    }
}

TEST_CASE("degenerate texture coordinates matter under a normal map") {
    MemoryFiles files;
    files.files["scene/n.bmp"] = bmp(2, 2, [](auto x, auto) { return 0x8080ffU + x * 0x101000U; });
    const std::string text =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
        "f 1/1 2/2 3/3\nf 1/1 2/2 3/2\nf 1 2 3\n";
    CHECK(with_mesh(files, text).codes().empty());
    const auto built = with_mesh(files, text, "Material { normal n.bmp }");
    REQUIRE(built.codes() == Strings{"asset-mesh-degenerate-uv"});
    CHECK(built.lowered.diagnostics[0].message ==
          "2 of 3 faces under a normal map have texture coordinates without area");
    CHECK(named(built, 0) == "f 1/1 2/2 3/2");
}

TEST_CASE("findings come in the order of the scene") {
    MemoryFiles files;
    const auto built =
        build(scene_of("TriangleMesh { obj_file a.obj }\nTriangleMesh { obj_file b.obj }",
                       "Material { texture c.bmp } Material { texture d.bmp }") +
                  "Background { cubeMap sky }",
              files);
    Strings names;
    for (std::size_t i = 0; i < built.lowered.diagnostics.size(); ++i) {
        names.push_back(named(built, i));
    }
    CHECK(names == Strings{"c.bmp", "d.bmp", "a.obj", "b.obj", "sky"});
}

TEST_CASE("a lint finds the same and keeps no pixels") {
    MemoryFiles files;
    files.files["scene/t.bmp"] = red(2, 2);
    files.files["scene/m.obj"] = kTriangle + "f 1 2 9\n";
    const std::string text = scene_of(
        "TriangleMesh { obj_file m.obj }\nTransform { Scale 1 0.0000001 1\n"
        "Sphere { center 0 0 0 radius 1 } }",
        "Material { texture t.bmp } Material { texture no.bmp }");
    const auto built = build(text, files);
    source::SourceMap sources;
    const auto id = sources.add("scene/test.txt", text);
    const auto checked = frontend::check(id, sources.text(id));
    Strings codes;
    for (const auto& d : check_assets(checked, sources, files)) codes.emplace_back(d.code->code);
    CHECK(codes == built.codes());
    CHECK(codes == Strings{"asset-missing", "asset-mesh-index", "transform-ill-conditioned"});
}

TEST_CASE("every code of this library has its page") {
    std::size_t count = 0;
    for (const auto* code : source::all_codes()) {
        if (!code->code.starts_with("asset-") && !code->code.starts_with("transform-out") &&
            !code->code.starts_with("transform-ill") && code->code != "motion-too-fast") {
            continue;
        }
        ++count;
        CAPTURE(code->code);
        CHECK(!code->title.empty());
        CHECK(code->why.size() > 40);
        CHECK(!code->example.empty());
        CHECK(!code->mend.empty());
    }
    CHECK(count == 19);
}

TEST_CASE("--transfer srgb decodes colours and pictures, but no data") {
    MemoryFiles files;
    files.files["scene/t.bmp"] = bmp(2, 2, [](auto x, auto y) { return (x + 2 * y) * 0x102030U; });
    LowerOptions options;
    options.decode_srgb = true;
    const auto built = with_texture(
        files, "texture t.bmp normal t.bmp diffuseColor 0.5 1 0 specularColor #808080", options);
    const Scene& scene = built.scene();
    CHECK(scene.materials[0].diffuse.x == doctest::Approx(0.21404114));
    CHECK(scene.materials[0].diffuse.y == 1);
    CHECK(scene.materials[0].specular.x == doctest::Approx(0.2158605));
    CHECK(scene.images[0].tag == ColorTag::kLinear);
    CHECK(scene.images[0].floats.size() == 12);
    CHECK(scene.images[1].tag == ColorTag::kData);
    CHECK(scene.images[1].bytes.size() == 12);
    CHECK(scene.lights.at(0).color == math::Vec3d{1, 1, 1});
}

TEST_CASE("compatibility modes read meshes and shade them as published") {
    MemoryFiles files;
    std::string ring;
    for (int i = 0; i < 121; ++i) ring += "v " + std::to_string(i) + " 0 0\n";
    files.files["scene/small.obj"] = kTriangle + "v 0 0 1\nf 1 2 4";
    files.files["scene/large.obj"] = ring + "v 0 1 0\nf 1 2 122\n";
    const auto flat = [&](const char* mesh, Compat compat, bool casting) {
        LowerOptions options;
        options.compat = compat;
        options.casting = casting;
        const auto built =
            build(scene_of(std::string("TriangleMesh { obj_file ") + mesh + " }"), files, options);
        // The last line of small.obj has no line end.
        REQUIRE(built.scene().meshes.at(0).faces.size() == 1);
        return built.scene().meshes[0].faces[0].corners[0].normal == Mesh::kNone;
    };
    CHECK(!flat("small.obj", Compat::kA4, false));
    CHECK(flat("small.obj", Compat::kA5, false));
    CHECK(!flat("large.obj", Compat::kA5, false));
    CHECK(!flat("small.obj", Compat::kFa2016, false));
    CHECK(flat("small.obj", Compat::kProject, false));
    CHECK(!flat("small.obj", Compat::kProject, true));
}
