// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include "ir/effects.hpp"
#include "tests/ir/support.hpp"

using namespace cobble;
using namespace cobble::ir;
using namespace cobble::test;

namespace {

struct Case {
    const char* title;
    Effect effect;
    std::string material;
    std::string object;
    std::string extra;   ///< behind the Group
    std::string cause;   ///< how the first cause's text begins; empty: off
    std::string reason;  ///< if off
};

const std::string kSphere = "Sphere { center 0 0 0 radius 1 }";
const std::string kBare = "Triangle { vertex0 0 0 0 vertex1 1 0 0 vertex2 0 1 0 }";
const std::string kMoving =
    "Transform { Translate 0 0 0 Motion { Translate 1 0 0 } Sphere { center 0 0 0 radius 1 } }";

}  // namespace

TEST_CASE("effects are on for a cause in the file, and off for a reason") {
    MemoryFiles files;
    files.files["scene/t.bmp"] = bmp(2, 2, [](auto x, auto y) { return (x + 2 * y) * 0x102030U; });
    files.files["scene/one.bmp"] = bmp(2, 2, [](auto, auto) { return 0x102030U; });
    files.files["scene/flat.bmp"] = bmp(2, 2, [](auto, auto) { return 0x8080ffU; });
    files.files["scene/tilt.bmp"] = bmp(2, 2, [](auto, auto) { return 0xa080f0U; });
    for (const char* face : {"left", "right", "up", "down", "front", "back"}) {
        files.files[std::string("scene/sky/") + face + ".bmp"] = files.files["scene/t.bmp"];
    }
    const Case cases[] = {
        {"pinhole", Effect::kDepthOfField, "", kSphere, "", "", "the camera's aperture is 0"},
        {"still", Effect::kMotionBlur, "", kSphere, "", "", "nothing moves"},
        {"moving", Effect::kMotionBlur, "", kMoving, "", "Sphere", ""},
        {"moving to where it is", Effect::kMotionBlur, "",
         "Transform { Translate 1 0 0 Motion { Translate 1 0 0 } " + kSphere + " }", "", "",
         "nothing moves"},
        {"hard", Effect::kSoftShadows, "", kSphere, "", "", "no light has a radius or an angle"},
        {"lit", Effect::kShadows, "", kSphere, "", "DirectionalLight", ""},
        {"matt", Effect::kReflection, "", kSphere, "", "", "no material has a specularColor"},
        {"mirror", Effect::kReflection, "specularColor 1 0 0", kSphere, "", "Material", ""},
        {"opaque", Effect::kRefraction, "specularColor 1 1 1", kSphere, "", "",
         "no material has a refractionIndex"},
        {"black glass", Effect::kRefraction, "refractionIndex 1.5", kSphere, "", "",
         "what has a refractionIndex has a black specularColor"},
        {"glass", Effect::kRefraction, "refractionIndex 1.5 specularColor 1 1 1", kSphere, "",
         "Material", ""},
        {"dull", Effect::kHighlights, "specularColor 1 1 1", kSphere, "", "",
         "no object has both a specularColor and shininess"},
        {"shiny", Effect::kHighlights, "specularColor 1 1 1 shininess 9", kSphere, "", "Material",
         ""},
        {"plain", Effect::kTextures, "", kSphere, "", "", "no material has a texture"},
        {"textured", Effect::kTextures, "texture t.bmp", kSphere, "", "Material", ""},
        {"one colour", Effect::kTextures, "texture one.bmp", kSphere, "", "",
         "every texture in use has one colour"},
        {"no coordinates", Effect::kTextures, "texture t.bmp", kBare, "", "",
         "no object with a texture has texture coordinates, or noise hides it"},
        {"hidden", Effect::kTextures, "texture t.bmp Noise { color 1 1 1 }", kSphere, "", "",
         "no object with a texture has texture coordinates, or noise hides it"},
        {"missing", Effect::kTextures, "texture no.bmp", kSphere, "", "Material", ""},
        {"relief", Effect::kNormalMaps, "normal t.bmp", kSphere, "", "Material", ""},
        {"tilted", Effect::kNormalMaps, "normal tilt.bmp", kSphere, "", "Material", ""},
        {"flat", Effect::kNormalMaps, "normal flat.bmp bump one.bmp", kSphere, "", "",
         "the maps in use are flat, or lie on objects without texture coordinates"},
        {"bumpy", Effect::kNormalMaps, "bump t.bmp", kSphere, "", "Material", ""},
        {"marble", Effect::kNoise, "Noise { color 1 1 1 }", kSphere, "", "Material", ""},
        {"even marble", Effect::kNoise, "Noise { color 1 1 1 color 1 1 1 }", kSphere, "", "",
         "no material has a Noise of two colours"},
        {"sky", Effect::kEnvironment, "", kSphere, "Background { cubeMap sky }", "Background", ""},
        {"mapped", Effect::kEnvironment, "cubeMap sky", kSphere, "", "Material", ""},
        {"bare", Effect::kEnvironment, "", kSphere, "Background { }", "",
         "neither Background nor a material has a cubeMap"},
    };
    for (const Case& c : cases) {
        CAPTURE(c.title);
        const auto built =
            build(scene_of(c.object, "Material { " + c.material + " }") + c.extra, files);
        REQUIRE(!built.checked.has_errors());
        const Effects effects = derive_effects(built.scene());
        const EffectState& state = effects.states[static_cast<std::size_t>(c.effect)];
        CHECK(state.on == !c.cause.empty());
        CHECK(state.reason == c.reason);
        REQUIRE(state.causes.empty() == c.cause.empty());
        if (!state.on) continue;
        CHECK(built.sources->text(state.causes[0]).substr(0, c.cause.size()) == c.cause);
    }
}

TEST_CASE("materials that no object is made of call for nothing") {
    MemoryFiles files;
    const auto built = build(
        scene_of(kSphere, "Material { } Material { specularColor 1 1 1 refractionIndex 1.5 }"),
        files);
    const Effects effects = derive_effects(built.scene());
    CHECK(!effects.on(Effect::kReflection));
    CHECK(!effects.on(Effect::kRefraction));
    CHECK(effects.states[static_cast<std::size_t>(Effect::kReflection)].reason ==
          "no object is made of a material with specularColor");
}

TEST_CASE("lens, shutter and lights") {
    MemoryFiles files;
    const auto derive = [&](const std::string& camera, const std::string& lights) {
        const auto built =
            build("PerspectiveCamera { center 0 0 10 direction 0 0 -1 up 0 1 0 angle 30 " + camera +
                      " }\nLights { " + lights +
                      " }\nMaterials { Material { } }\nGroup { MaterialIndex 0 " + kMoving + " }",
                  files);
        REQUIRE(!built.checked.has_errors());
        return derive_effects(built.scene());
    };
    const auto open =
        derive("aperture 1 focusDistance 5", "PointLight { position 0 9 0 color 1 1 1 radius 1 }");
    CHECK(open.on(Effect::kDepthOfField));
    CHECK(open.on(Effect::kMotionBlur));
    CHECK(open.on(Effect::kSoftShadows));
    const auto closed = derive("shutterOpen 0.5 shutterClose 0.5", "");
    CHECK(!closed.on(Effect::kMotionBlur));
    CHECK(closed.states[static_cast<std::size_t>(Effect::kMotionBlur)].reason ==
          "the shutter opens and closes at the same time");
    CHECK(closed.states[static_cast<std::size_t>(Effect::kShadows)].reason ==
          "there are no lights");
    const auto dark = derive("", "PointLight { position 0 9 0 color 0 0 0 radius 1 }");
    CHECK(!dark.on(Effect::kShadows));
    CHECK(dark.states[static_cast<std::size_t>(Effect::kSoftShadows)].reason ==
          "all lights are black");
}

TEST_CASE("a texture of one colour becomes the colour where all of the surface carries it") {
    MemoryFiles files;
    files.files["scene/one.bmp"] = bmp(2, 2, [](auto, auto) { return 0xff3300U; });
    const auto folded =
        build(scene_of(kSphere, "Material { diffuseColor 0 0 1 texture one.bmp }"), files);
    CHECK(folded.scene().materials[0].diffuse == math::Vec3d{1, 0.2, 0});
    CHECK(!folded.scene().materials[0].texture.valid());
    CHECK(folded.scene().materials[0].folded_texture.valid());
    const auto kept =
        build(scene_of(kSphere + kBare, "Material { diffuseColor 0 0 1 texture one.bmp }"), files);
    CHECK(kept.scene().materials[0].diffuse == math::Vec3d{0, 0, 1});
    CHECK(kept.scene().materials[0].texture.valid());
    LowerOptions a4;
    a4.compat = Compat::kA4;
    const auto compat =
        build(scene_of(kSphere, "Material { diffuseColor 0 0 1 texture one.bmp }"), files, a4);
    CHECK(compat.scene().materials[0].texture.valid());
}

TEST_CASE("each effect has its name and its words") {
    for (std::size_t i = 0; i < kEffectCount; ++i) {
        const auto effect = static_cast<Effect>(i);
        CHECK(!name_of(effect).empty());
        CHECK(!description_of(effect).empty());
    }
    CHECK(name_of(Effect::kDepthOfField) == "depth-of-field");
}
