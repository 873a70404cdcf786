// SPDX-License-Identifier: MIT
#include "ir/lower/materials.hpp"

#include <cmath>

#include "ir/assets/obj/mesh_normals.hpp"
#include "ir/math/elementary.hpp"
#include "ir/math/srgb.hpp"

namespace cobble::ir {
namespace {

namespace field = frontend::field;
using frontend::BlockNodeId;
using frontend::BlockView;
using frontend::CheckedScene;
using grammar::BlockId;
using math::vec;
using math::Vec3d;

double radians(double degrees) { return degrees * (math::kPi / 180); }

Color color(const std::optional<std::array<double, 3>>& written, Color fallback,
            const LowerOptions& options) {
    const Color display = written ? vec(*written) : fallback;
    return options.decode_srgb ? math::srgb_to_linear(display) : display;
}

/// A unit vector perpendicular to a unit vector: with the axis along which it is smallest.
Vec3d any_perpendicular(Vec3d v) {
    const double x = std::fabs(v.x);
    const double y = std::fabs(v.y);
    const double z = std::fabs(v.z);
    const Vec3d axis = y <= x && y <= z ? Vec3d{0, 1, 0} : x <= z ? Vec3d{1, 0, 0} : Vec3d{0, 0, 1};
    return safe_normalize(cross(cross(v, axis), v));
}

std::optional<Camera> camera_of(const CheckedScene& checked, BlockNodeId block) {
    const BlockView view(checked.tokens, checked.ast, block);
    const auto center = field::PerspectiveCamera_center(view);
    const auto direction = field::PerspectiveCamera_direction(view);
    const auto up = field::PerspectiveCamera_up(view);
    const auto angle = field::PerspectiveCamera_angle(view);
    if (!center || !direction || !up || !angle) return std::nullopt;
    Camera camera;
    camera.center = vec(*center);
    camera.forward = safe_normalize(vec(*direction));
    camera.up_as_written = vec(*up);
    if (length(camera.forward) == 0 || !(*angle > 0) || !(*angle < 180)) return std::nullopt;
    // Unit vectors that are parallel to within 2^-40 leave too few digits for a direction.
    Vec3d across = cross(camera.forward, safe_normalize(camera.up_as_written));
    if (length(across) < 0x1p-40) {
        across = cross(camera.forward, any_perpendicular(camera.forward));
    }
    camera.right = safe_normalize(across);
    camera.up = cross(camera.right, camera.forward);
    camera.angle = radians(*angle);
    const double aperture = field::PerspectiveCamera_aperture(view).value_or(0);
    const double focus = field::PerspectiveCamera_focusDistance(view).value_or(0);
    if (aperture > 0 && focus > 0) {
        camera.aperture = aperture;
        camera.focus_distance = focus;
    }
    const int blades = field::PerspectiveCamera_blades(view).value_or(0);
    if (blades >= 3 && blades <= 16) camera.blades = static_cast<std::uint32_t>(blades);
    const double open = field::PerspectiveCamera_shutterOpen(view).value_or(0);
    const double close = field::PerspectiveCamera_shutterClose(view).value_or(1);
    if (open >= 0 && open <= close && close <= 1) {
        camera.shutter_open = open;
        camera.shutter_close = close;
    }
    camera.label = label_of(checked, block);
    camera.span = span_of(checked, block);
    return camera;
}

std::optional<Light> light_of(const CheckedScene& checked, BlockNodeId block,
                              const LowerOptions& options) {
    const BlockView view(checked.tokens, checked.ast, block);
    Light light;
    if (checked.ast.block(block).row == BlockId::kDirectionalLight) {
        const auto direction = field::DirectionalLight_direction(view);
        const auto written = field::DirectionalLight_color(view);
        if (!direction || !written) return std::nullopt;
        light.kind = Light::Kind::kDirectional;
        light.direction = safe_normalize(vec(*direction));
        if (length(light.direction) == 0) return std::nullopt;
        light.color = color(written, {}, options);
        light.angle = radians(field::DirectionalLight_angle(view).value_or(0));
    } else {
        light.position = vec(field::PointLight_position(view).value_or(std::array<double, 3>{}));
        light.color = color(field::PointLight_color(view), {}, options);
        light.falloff = std::max(field::PointLight_falloff(view).value_or(0), 0.0);
        light.radius = std::max(field::PointLight_radius(view).value_or(0), 0.0);
    }
    light.label = label_of(checked, block);
    light.span = span_of(checked, block);
    return light;
}

Noise noise_of(const CheckedScene& checked, BlockNodeId block, const LowerOptions& options) {
    const BlockView view(checked.tokens, checked.ast, block);
    Noise noise;
    int colors = 0;
    for (const auto& f : checked.ast.fields_of(block)) {
        if (f.row != grammar::FieldId::kNoise_color || f.broken || f.value_count < 3) continue;
        const auto values = checked.ast.values_of(f);
        const std::array<double, 3> written{values[0].number, values[1].number, values[2].number};
        (colors++ == 0 ? noise.color1 : noise.color2) = color(written, {}, options);
    }
    const int octaves = field::Noise_octaves(view).value_or(0);
    noise.octaves = octaves < 0 ? 0U : std::min(static_cast<std::uint32_t>(octaves), 32U);
    noise.frequency = field::Noise_frequency(view).value_or(1);
    noise.amplitude = field::Noise_amplitude(view).value_or(1);
    return noise;
}

// `Material` and `PhongMaterial` have the same fields, in rows of their own.
#define COBBLE_EITHER(name) \
    (row == BlockId::kMaterial ? field::Material_##name(view) : field::PhongMaterial_##name(view))

}  // namespace

source::Span span_of(const CheckedScene& checked, BlockNodeId block) {
    const auto& node = checked.cst.node(checked.ast.block(block).cst);
    const auto begin = checked.tokens.range({node.first_token}).begin;
    const auto last = node.end_token > node.first_token ? node.end_token - 1 : node.first_token;
    return {checked.source, begin, checked.tokens.range({last}).end};
}

std::string label_of(const CheckedScene& checked, BlockNodeId block) {
    const auto label = checked.ast.block(block).label;
    return label.valid() ? std::string(checked.tokens.text_of(label)) : std::string();
}

std::optional<Camera> lower_camera(const CheckedScene& checked) {
    for (const BlockNodeId block : checked.ast.roots) {
        if (checked.ast.block(block).row != BlockId::kPerspectiveCamera) continue;
        if (auto camera = camera_of(checked, block)) return camera;
    }
    return std::nullopt;
}

std::vector<Light> lower_lights(const CheckedScene& checked, const LowerOptions& options) {
    std::vector<Light> lights;
    for (const BlockNodeId section : checked.ast.roots) {
        if (checked.ast.block(section).row != BlockId::kLights) continue;
        for (const BlockNodeId child : checked.ast.children_of(section)) {
            const auto& block = checked.ast.block(child);
            if (block.broken || grammar::row(block.row).role != grammar::Role::kLight) continue;
            if (auto light = light_of(checked, child, options)) lights.push_back(std::move(*light));
        }
    }
    return lights;
}

Background lower_background(const CheckedScene& checked, const LowerOptions& options,
                            bool has_lights) {
    Background background;
    background.color = color(std::nullopt, background.color, options);
    for (const BlockNodeId block : checked.ast.roots) {
        if (checked.ast.block(block).row != BlockId::kBackground) continue;
        const BlockView view(checked.tokens, checked.ast, block);
        background.color = color(field::Background_color(view), {0.5, 0.5, 0.5}, options);
        background.ambient = color(field::Background_ambientLight(view), {}, options);
        background.span = span_of(checked, block);
    }
    if (!has_lights) background.ambient = {1, 1, 1};
    return background;
}

Material lower_material(const CheckedScene& checked, BlockNodeId block,
                        const MaterialAssets& assets, const LowerOptions& options) {
    const BlockView view(checked.tokens, checked.ast, block);
    const BlockId row = checked.ast.block(block).row;
    Material material;
    material.label = label_of(checked, block);
    material.span = span_of(checked, block);
    if (checked.ast.block(block).broken || grammar::row(row).role != grammar::Role::kMaterial) {
        material.substituted = true;
        return material;
    }
    material.diffuse = color(COBBLE_EITHER(diffuseColor), {1, 1, 1}, options);
    material.specular = color(COBBLE_EITHER(specularColor), {}, options);
    material.shininess = std::max(COBBLE_EITHER(shininess).value_or(0), 0.0);
    material.refraction_index = std::max(COBBLE_EITHER(refractionIndex).value_or(0), 0.0);
    material.texture = assets.texture;
    material.normal_map = assets.normal_map;
    material.bump_map = assets.bump_map;
    material.cube_map = assets.cube_map;
    if (COBBLE_EITHER(textureFilter).value_or("") == "nearest") {
        material.texture_filter = TextureFilter::kNearest;
    }
    if (const auto scale = COBBLE_EITHER(textureScale)) {
        if ((*scale)[0] != 0 && (*scale)[1] != 0) {
            material.texture_scale = {(*scale)[0], (*scale)[1]};
        }
    }
    for (const BlockNodeId child : checked.ast.children_of(block)) {
        const auto& noise = checked.ast.block(child);
        if (noise.row != BlockId::kNoise || noise.broken) continue;
        material.has_noise = true;
        material.noise = noise_of(checked, child, options);
    }
    return material;
}

}  // namespace cobble::ir
