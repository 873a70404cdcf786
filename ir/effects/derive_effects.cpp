// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "ir/effects.hpp"
#include "ir/lower/fold.hpp"

namespace cobble::ir {
namespace {

using Causes = std::vector<source::Span>;

bool black(Color c) { return c.x == 0 && c.y == 0 && c.z == 0; }

class Derivation {
  public:
    explicit Derivation(const Scene& scene) : scene_(scene) {
        used_.assign(scene.materials.size(), false);
        has_uv_.assign(scene.materials.size(), false);
        // Per mesh, not per object: many objects share one.
        std::vector<signed char> mesh_uv(scene.meshes.size(), -1);
        for (const Object& object : scene.objects) {
            const std::size_t material = object.material.value;
            used_[material] = true;
            if (has_uv_[material]) continue;
            if (object.kind == ShapeKind::kMesh) {
                auto& known = mesh_uv[object.shape];
                if (known < 0) known = has_uv_somewhere(scene, object) ? 1 : 0;
                has_uv_[material] = known == 1;
            } else {
                has_uv_[material] = has_uv_somewhere(scene, object);
            }
        }
    }

    Effects run() {
        lens();
        motion();
        lights();
        secondary_rays();
        surfaces();
        environment();
        return std::move(effects_);
    }

  private:
    /// The effect is on if something calls for it; `reason` is why not.
    void decide(Effect effect, Causes causes, std::string reason) {
        EffectState& state = effects_.states[static_cast<std::size_t>(effect)];
        state.on = !causes.empty();
        if (!state.on) state.reason = std::move(reason);
        state.causes = std::move(causes);
    }

    template <typename Test>
    [[nodiscard]] Causes used_materials(Test&& calls) const {
        Causes causes;
        for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
            if (used_[i] && calls(scene_.materials[i], i))
                causes.push_back(scene_.materials[i].span);
        }
        return causes;
    }

    template <typename Test>
    [[nodiscard]] bool any_used(Test&& test) const {
        return !used_materials(std::forward<Test>(test)).empty();
    }
    template <typename Test>
    [[nodiscard]] bool any_unused(Test&& test) const {
        for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
            if (!used_[i] && test(scene_.materials[i])) return true;
        }
        return false;
    }

    void lens() {
        Causes causes;
        if (scene_.camera.aperture > 0) causes.push_back(scene_.camera.span);
        decide(Effect::kDepthOfField, std::move(causes), "the camera's aperture is 0");
    }

    [[nodiscard]] bool moves(const Object& object) const {
        if (object.placement.count > 1) return true;
        if (object.placement.count == 1) return false;
        if (object.kind == ShapeKind::kSphere) return scene_.spheres[object.shape].keys.size() > 1;
        if (object.kind == ShapeKind::kTriangle) {
            return scene_.triangles[object.shape].keys.size() > 1;
        }
        return false;
    }

    void motion() {
        Causes causes;
        for (const Object& object : scene_.objects) {
            if (moves(object)) causes.push_back(object.span);
        }
        const bool closed = scene_.camera.shutter_open >= scene_.camera.shutter_close;
        std::string reason = "nothing moves";
        if (!causes.empty() && closed) {
            causes.clear();
            reason = "the shutter opens and closes at the same time";
        }
        decide(Effect::kMotionBlur, std::move(causes), std::move(reason));
    }

    void lights() {
        Causes lit;
        Causes sized;
        for (const Light& light : scene_.lights) {
            if (black(light.color)) continue;
            lit.push_back(light.span);
            if (light.radius > 0 || light.angle > 0) sized.push_back(light.span);
        }
        const char* const dark = scene_.lights.empty() ? "there are no lights"
                                 : lit.empty()         ? "all lights are black"
                                                       : "there is no object to cast one";
        const char* const point = lit.empty() ? dark : "no light has a radius or an angle";
        if (scene_.objects.empty()) lit.clear();
        if (scene_.compat == Compat::kA4) {
            lit.clear();
            sized.clear();
            decide(Effect::kShadows, {}, "the ray caster of 2012 has no shadows");
            decide(Effect::kSoftShadows, {}, "the ray caster of 2012 has no shadows");
        } else {
            decide(Effect::kShadows, lit, dark);
            decide(Effect::kSoftShadows, std::move(sized), point);
        }
        lit_ = std::any_of(scene_.lights.begin(), scene_.lights.end(),
                           [](const Light& light) { return !black(light.color); });
    }

    void secondary_rays() {
        const auto mirrors = [](const Material& m, std::size_t = 0) { return !black(m.specular); };
        const auto clear = [&](const Material& m, std::size_t = 0) {
            return m.refraction_index > 0 && !black(m.specular);
        };
        if (scene_.compat == Compat::kA4) {
            decide(Effect::kReflection, {}, "the ray caster of 2012 follows no mirrored rays");
            decide(Effect::kRefraction, {}, "the ray caster of 2012 follows no refracted rays");
            return;
        }
        decide(Effect::kReflection, used_materials(mirrors),
               any_unused(mirrors) ? "no object is made of a material with specularColor"
                                   : "no material has a specularColor");
        const bool only_black =
            any_used([](const Material& m, std::size_t) { return m.refraction_index > 0; });
        decide(Effect::kRefraction, used_materials(clear),
               only_black          ? "what has a refractionIndex has a black specularColor"
               : any_unused(clear) ? "no object is made of a material with refractionIndex"
                                   : "no material has a refractionIndex");
    }

    [[nodiscard]] bool varies(ImageId id) const {
        return id.valid() && !scene_.images[id.value].constant;
    }

    void surfaces() {
        // Published programs raise to the power 0 too: a highlight that covers the lit side.
        const bool any_shininess = scene_.compat != Compat::kNone && scene_.compat != Compat::kA5;
        Causes shiny = used_materials([&](const Material& m, std::size_t) {
            return (m.shininess > 0 || any_shininess) && !black(m.specular);
        });
        std::string reason = "no object has both a specularColor and shininess";
        if (scene_.compat == Compat::kA5) {
            shiny.clear();
            reason = "the ray tracer of 2012 has no highlights";
        } else if (!lit_) {
            shiny.clear();
            reason = "no light shines";
        }
        decide(Effect::kHighlights, std::move(shiny), std::move(reason));

        // A texture that lowering could not fold shows even if it has one colour.
        Causes textured = used_materials([&](const Material& m, std::size_t i) {
            return (m.texture.valid() && !m.has_noise && has_uv_[i]) || m.substituted;
        });
        const auto named = [](const Material& m, std::size_t = 0) {
            return m.texture.valid() || m.folded_texture.valid();
        };
        reason = "no material has a texture";
        if (any_used([](const Material& m, std::size_t) { return m.folded_texture.valid(); })) {
            reason = "every texture in use has one colour";
        } else if (any_used(named)) {
            reason = "no object with a texture has texture coordinates, or noise hides it";
        } else if (any_unused(named)) {
            reason = "no object is made of a material with a texture";
        }
        decide(Effect::kTextures, std::move(textured), std::move(reason));

        Causes relief = used_materials([&](const Material& m, std::size_t i) {
            return has_uv_[i] && (is_relief(m.normal_map) || varies(m.bump_map));
        });
        const auto mapped = [](const Material& m, std::size_t = 0) {
            return m.normal_map.valid() || m.bump_map.valid();
        };
        reason = any_used(mapped)     ? "the maps in use are flat, or lie on objects without "
                                        "texture coordinates"
                 : any_unused(mapped) ? "no object is made of a material with a normal or bump map"
                                      : "no material has a normal or bump map";
        decide(Effect::kNormalMaps, std::move(relief), std::move(reason));

        const auto noisy = [](const Material& m, std::size_t = 0) { return m.has_noise; };
        decide(Effect::kNoise, used_materials(noisy),
               any_unused(noisy) ? "no object is made of a material with Noise"
                                 : "no material has a Noise of two colours");
    }

    /// A map of one value tilts all normals alike, unless that value is the flat one.
    [[nodiscard]] bool is_relief(ImageId id) const {
        if (!id.valid()) return false;
        const Image& image = scene_.images[id.value];
        if (!image.constant || image.bytes.size() < 3) return true;
        return image.bytes[0] != 128 || image.bytes[1] != 128 || image.bytes[2] != 255;
    }

    void environment() {
        const auto mapped = [](const Material& m, std::size_t = 0) { return m.cube_map.valid(); };
        Causes causes;
        if (scene_.background.cube_map.valid()) causes.push_back(scene_.background.span);
        for (const auto& span : used_materials(mapped)) causes.push_back(span);
        std::sort(causes.begin(), causes.end(),
                  [](const auto& a, const auto& b) { return a.begin < b.begin; });
        decide(Effect::kEnvironment, std::move(causes),
               any_unused(mapped) ? "no object is made of a material with a cubeMap"
                                  : "neither Background nor a material has a cubeMap");
    }

    const Scene& scene_;
    Effects effects_;
    std::vector<bool> used_;    ///< per material: some object is made of it
    std::vector<bool> has_uv_;  ///< per material: some such object has texture coordinates
    bool lit_ = false;
};

}  // namespace

Effects derive_effects(const Scene& scene) { return Derivation(scene).run(); }

}  // namespace cobble::ir
