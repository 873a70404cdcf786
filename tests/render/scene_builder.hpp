// SPDX-License-Identifier: MIT
// Small scenes as values, and their pictures.
#pragma once

#include <cmath>
#include <initializer_list>
#include <memory>
#include <utility>

#include "ir/scene/scene.hpp"
#include "renderer/job/render_job.hpp"
#include "renderer/settings.hpp"

namespace cobble::test {

using ir::Color;
using ir::Effect;
using math::Vec3d;

/// A camera at z = 10 that looks along -z, a dark room without lights, nothing in it.
class SceneBuilder {
  public:
    SceneBuilder() {
        camera({0, 0, 10}, {0, 0, -1}, 0.5);
        scene_.background.color = {};
    }

    SceneBuilder& camera(Vec3d center, Vec3d direction, double angle) {
        ir::Camera& c = scene_.camera;
        c.center = center;
        c.forward = math::normalize(direction);
        const Vec3d up = std::fabs(c.forward.y) > 0.99 ? Vec3d{0, 0, -1} : Vec3d{0, 1, 0};
        c.right = math::normalize(math::cross(c.forward, up));
        c.up = math::cross(c.right, c.forward);
        c.up_as_written = c.up;
        c.angle = angle;
        return *this;
    }
    SceneBuilder& lens(double aperture, double focus, std::uint32_t blades = 0) {
        scene_.camera.aperture = aperture;
        scene_.camera.focus_distance = focus;
        scene_.camera.blades = blades;
        return *this;
    }
    SceneBuilder& shutter(double open, double close) {
        scene_.camera.shutter_open = open;
        scene_.camera.shutter_close = close;
        return *this;
    }
    SceneBuilder& background(Color color, Color ambient = {}) {
        scene_.background.color = color;
        scene_.background.ambient = ambient;
        return *this;
    }
    SceneBuilder& point_light(Vec3d position, Color color, double radius = 0, double falloff = 0) {
        ir::Light light;
        light.position = position;
        light.color = color;
        light.radius = radius;
        light.falloff = falloff;
        scene_.lights.push_back(light);
        return *this;
    }
    SceneBuilder& sun(Vec3d direction, Color color, double angle = 0) {
        ir::Light light;
        light.kind = ir::Light::Kind::kDirectional;
        light.direction = math::normalize(direction);
        light.color = color;
        light.angle = angle;
        scene_.lights.push_back(light);
        return *this;
    }
    /// Following objects are made of it.
    ir::Material& material(Color diffuse, Color specular = {}, double shininess = 0,
                           double refraction_index = 0) {
        ir::Material material;
        material.diffuse = diffuse;
        material.specular = specular;
        material.shininess = shininess;
        material.refraction_index = refraction_index;
        scene_.materials.push_back(std::move(material));
        return scene_.materials.back();
    }
    SceneBuilder& sphere(Vec3d center, double radius) {
        add(ir::ShapeKind::kSphere, scene_.spheres.size());
        scene_.spheres.push_back({{{center, radius}}});
        return *this;
    }
    SceneBuilder& moving_sphere(Vec3d from, Vec3d to, double radius) {
        add(ir::ShapeKind::kSphere, scene_.spheres.size());
        scene_.spheres.push_back({{{from, radius}, {to, radius}}});
        return *this;
    }
    /// u along x and v along z, or y for a plane that faces z.
    SceneBuilder& plane(Vec3d normal, double offset) {
        add(ir::ShapeKind::kPlane, scene_.planes.size());
        ir::Plane plane;
        plane.normal = math::normalize(normal);
        plane.offset = offset;
        plane.u_axis = std::fabs(plane.normal.x) < 0.9 ? Vec3d{1, 0, 0} : Vec3d{0, 0, 1};
        plane.v_axis = std::fabs(plane.normal.y) < 0.9 ? Vec3d{0, 1, 0} : Vec3d{0, 0, -1};
        scene_.planes.push_back(plane);
        return *this;
    }
    SceneBuilder& box(Vec3d min, Vec3d max) {
        add(ir::ShapeKind::kBox, scene_.boxes.size());
        scene_.boxes.push_back({min, max});
        return *this;
    }
    SceneBuilder& triangle(Vec3d a, Vec3d b, Vec3d c) {
        add(ir::ShapeKind::kTriangle, scene_.triangles.size());
        scene_.triangles.push_back({{{a, b, c}}});
        return *this;
    }
    /// A mesh as it stands, in world space.
    SceneBuilder& mesh(ir::Mesh mesh) {
        add(ir::ShapeKind::kMesh, scene_.meshes.size());
        scene_.meshes.push_back(std::move(mesh));
        return *this;
    }
    ir::ImageId image(ir::Image image) {
        scene_.images.push_back(std::move(image));
        return {static_cast<std::uint32_t>(scene_.images.size() - 1)};
    }
    [[nodiscard]] ir::Scene& scene() { return scene_; }

  private:
    void add(ir::ShapeKind kind, std::size_t shape) {
        if (scene_.materials.empty()) material({1, 1, 1});
        ir::Object object;
        object.kind = kind;
        object.shape = static_cast<std::uint32_t>(shape);
        object.material = {static_cast<std::uint32_t>(scene_.materials.size() - 1)};
        // A place in an imaginary file, so that reports can name it.
        const auto index = static_cast<std::uint32_t>(scene_.objects.size());
        object.span.begin = 100 * index;
        object.span.end = 100 * index + 10;
        scene_.objects.push_back(object);
    }

    ir::Scene scene_;
};

inline ir::Effects effects(std::initializer_list<Effect> on) {
    ir::Effects result;
    for (const Effect effect : on) result.states[static_cast<std::size_t>(effect)].on = true;
    return result;
}

inline ir::Effects all_effects() {
    ir::Effects result;
    for (ir::EffectState& state : result.states) state.on = true;
    return result;
}

inline ir::Effects without(ir::Effects effects, Effect effect) {
    effects.states[static_cast<std::size_t>(effect)].on = false;
    return effects;
}

inline renderer::Settings settings(std::uint32_t width, std::uint32_t height,
                                   std::uint32_t samples = 1, ir::Effects on = all_effects()) {
    renderer::Settings result;
    result.width = width;
    result.height = height;
    result.samples = samples;
    result.effects = std::move(on);
    return result;
}

struct Rendered {
    renderer::Picture picture;
    renderer::Stats stats;

    [[nodiscard]] Color color(std::uint32_t x, std::uint32_t y) const {
        return {picture.color.at(x, y, 0), picture.color.at(x, y, 1), picture.color.at(x, y, 2)};
    }
};

inline renderer::Deadline soon(int milliseconds) {
    return std::chrono::steady_clock::now() + std::chrono::milliseconds(milliseconds);
}

/// To the end, on `threads` threads, in steps of `milliseconds`.
inline Rendered render(const ir::Scene& scene, const renderer::Settings& settings,
                       std::uint32_t threads = 1, int milliseconds = 1000000) {
    const auto scheduler =
        threads == 1 ? renderer::make_serial_scheduler() : renderer::make_thread_scheduler(threads);
    const auto job = renderer::start_render(scene, settings, *scheduler);
    while (!job->step(soon(milliseconds)).done) {
    }
    return {job->picture(), job->stats()};
}

}  // namespace cobble::test
