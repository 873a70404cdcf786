// SPDX-License-Identifier: MIT
// Rays a second, one thread, by kind of ray, scene, precision and method.
//
//   bench_rays [--json] [--seconds S]
//
// Camera rays come from a grid over the picture, in rows; shadow rays leave each camera hit toward
// one light; bounce rays leave it in a random direction of the upper half. Generating them is not
// timed. Every figure is the best of the passes that fit into S seconds, and at least 3.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ir/math/elementary.hpp"
#include "ir/scene/scene.hpp"
#include "renderer/intersect/intersect.hpp"
#include "renderer/intersect/surface.hpp"

namespace {

using cobble::math::Vec3d;
using namespace cobble::renderer;
namespace ir = cobble::ir;

std::uint64_t next_bits(std::uint64_t& state) {
    // splitmix64 (Steele, Lea and Flood, OOPSLA 2014).
    state += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
}

double next_unit(std::uint64_t& state) {
    return static_cast<double>(next_bits(state) >> 11) * 0x1p-53;
}

Vec3d next_direction(std::uint64_t& state) {
    const double z = 2 * next_unit(state) - 1;
    const auto a = cobble::math::sincos(2 * cobble::math::kPi * next_unit(state));
    const double r = std::sqrt(1 - z * z);
    return {r * a.cos, r * a.sin, z};
}

void add_object(ir::Scene& scene, ir::ShapeKind kind, std::size_t shape) {
    ir::Object object;
    object.kind = kind;
    object.shape = static_cast<std::uint32_t>(shape);
    object.material = ir::MaterialId{0};
    scene.objects.push_back(object);
}

ir::Scene empty_scene() {
    ir::Scene scene;
    scene.materials.emplace_back();
    scene.camera.center = {0, 0.6, 3};
    return scene;
}

/// A bumpy sphere of 2 n (n - 1) or so triangles.
ir::Scene mesh_scene(std::uint32_t n) {
    ir::Scene scene = empty_scene();
    ir::Mesh mesh;
    for (std::uint32_t i = 0; i <= n; ++i) {
        for (std::uint32_t j = 0; j < n; ++j) {
            const auto a = cobble::math::sincos(cobble::math::kPi * i / n);
            const auto b = cobble::math::sincos(2 * cobble::math::kPi * j / n);
            const double wave = cobble::math::sin(9 * a.cos) * cobble::math::sin(7 * b.cos);
            const double r = 1 + 0.1 * wave;
            mesh.positions.push_back({r * a.sin * b.cos, r * a.cos, r * a.sin * b.sin});
        }
    }
    constexpr auto kNone = ir::Mesh::kNone;
    const auto face = [&mesh](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh.faces.push_back({{{{a, kNone, kNone}, {b, kNone, kNone}, {c, kNone, kNone}}}});
    };
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = 0; j < n; ++j) {
            const std::uint32_t k = (j + 1) % n;
            if (i > 0) face(i * n + j, i * n + k, (i + 1) * n + j);
            if (i + 1 < n) face(i * n + k, (i + 1) * n + k, (i + 1) * n + j);
        }
    }
    scene.meshes.push_back(std::move(mesh));
    add_object(scene, ir::ShapeKind::kMesh, 0);
    return scene;
}

ir::Scene sphere_scene(std::uint32_t n) {
    ir::Scene scene = empty_scene();
    std::uint64_t state = 1;
    for (std::uint32_t i = 0; i < n; ++i) {
        const Vec3d at = next_direction(state) * next_unit(state);
        scene.spheres.push_back({{{at, 0.02 + 0.02 * next_unit(state)}}});
        add_object(scene, ir::ShapeKind::kSphere, i);
    }
    return scene;
}

template <typename T>
struct Query {
    Ray<T> ray;
    Exclude exclude;
};

struct Figure {
    std::string scene, precision, method, kind;
    std::size_t rays = 0;
    double rays_a_second = 0;
    double box_tests_a_ray = 0;
    double primitive_tests_a_ray = 0;
    double hit_share = 0;
};

template <typename T>
Figure measure(const PreparedScene<T>& scene, const std::vector<Query<T>>& queries, bool any,
               double seconds) {
    using Clock = std::chrono::steady_clock;
    Figure figure;
    figure.rays = queries.size();
    const auto start = Clock::now();
    double best = 1e300;
    for (int pass = 0;
         pass < 3 || std::chrono::duration<double>(Clock::now() - start).count() < seconds;
         ++pass) {
        Counters counters;
        std::size_t hits = 0;
        const auto begin = Clock::now();
        for (const auto& q : queries) {
            const bool hit = any ? any_hit(scene, q.ray, q.exclude, counters)
                                 : bool(closest_hit(scene, q.ray, q.exclude, counters));
            hits += hit ? 1 : 0;
        }
        const double took = std::chrono::duration<double>(Clock::now() - begin).count();
        best = took < best ? took : best;
        const auto n = static_cast<double>(queries.size());
        figure.box_tests_a_ray = static_cast<double>(counters.box_tests) / n;
        figure.primitive_tests_a_ray = static_cast<double>(counters.primitive_tests) / n;
        figure.hit_share = static_cast<double>(hits) / n;
    }
    figure.rays_a_second = static_cast<double>(queries.size()) / best;
    return figure;
}

template <typename T>
void run(const std::string& name, const ir::Scene& source, Acceleration method, std::uint32_t side,
         double seconds, std::vector<Figure>& figures) {
    PrepareOptions options;
    options.acceleration = method;
    const auto begin = std::chrono::steady_clock::now();
    const auto scene = prepare<T>(source, options);
    const double built =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const bool is_float = sizeof(T) == sizeof(float);
    const bool tree = method == Acceleration::kBvh;

    std::vector<Query<T>> camera;
    std::vector<Query<T>> shadow;
    std::vector<Query<T>> bounce;
    const Vec3d eye = source.camera.center;
    const Vec3d light{3, 4, 2};
    std::uint64_t state = 7;
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const double u = 2 * (x + 0.5) / side - 1;
            const double v = 2 * (y + 0.5) / side - 1;
            Query<T> q;
            q.ray.origin = scene.to_local(eye);
            q.ray.direction = normalize(Vec3d{0.45 * u, 0.45 * v - 0.2, -1}).template to<T>();
            camera.push_back(q);
            Counters counters;
            const auto hit = closest_hit(scene, q.ray, q.exclude, counters);
            Vec3d random = next_direction(state);
            if (!hit) continue;
            const auto s = surface_at(scene, q.ray, hit);
            const auto to_light = leave_toward(s, scene.to_local(light), T(0));
            shadow.push_back({to_light.ray, to_light.exclude});
            if (dot(random, s.geometric_normal.template to<double>()) < 0) random = -random;
            const auto away = leave(s, random.to<T>(), T(0));
            bounce.push_back({away.ray, away.exclude});
        }
    }
    const auto add = [&](const std::string& kind, const std::vector<Query<T>>& queries, bool any) {
        Figure f = measure(scene, queries, any, seconds);
        f.scene = name;
        f.precision = is_float ? "float" : "double";
        f.method = tree ? "bvh" : "brute force";
        f.kind = kind;
        figures.push_back(f);
    };
    add("primary", camera, false);
    add("shadow", shadow, true);
    add("bounce", bounce, false);
    Figure preparation;
    preparation.scene = name;
    preparation.precision = is_float ? "float" : "double";
    preparation.method = tree ? "bvh" : "brute force";
    preparation.kind = "prepare (primitives)";
    preparation.rays = scene.geometry.triangles.size() + scene.geometry.spheres.size();
    preparation.rays_a_second = static_cast<double>(preparation.rays) / built;
    figures.push_back(preparation);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"rays a second of the reference intersection, one thread"};
    bool json = false;
    double seconds = 0.3;
    app.add_flag("--json", json, "one JSON array instead of a table");
    app.add_option("--seconds", seconds, "time for each figure")->check(CLI::Range(0.0, 60.0));
    CLI11_PARSE(app, argc, argv);

    std::vector<Figure> figures;
    const ir::Scene mesh = mesh_scene(188);
    const ir::Scene spheres = sphere_scene(10000);
    const ir::Scene small = mesh_scene(16);
    using enum Acceleration;
    run<float>("mesh, 70k triangles", mesh, kBvh, 300, seconds, figures);
    run<double>("mesh, 70k triangles", mesh, kBvh, 300, seconds, figures);
    run<float>("10k spheres", spheres, kBvh, 300, seconds, figures);
    run<double>("10k spheres", spheres, kBvh, 300, seconds, figures);
    run<float>("mesh, 480 triangles", small, kBvh, 100, seconds, figures);
    run<float>("mesh, 480 triangles", small, kBruteForce, 100, seconds, figures);
    run<double>("mesh, 480 triangles", small, kBruteForce, 100, seconds, figures);

    if (json) {
        auto all = nlohmann::json::array();
        for (const Figure& f : figures) {
            all.push_back({{"scene", f.scene},
                           {"precision", f.precision},
                           {"method", f.method},
                           {"kind", f.kind},
                           {"count", f.rays},
                           {"per_second", f.rays_a_second},
                           {"box_tests_per_ray", f.box_tests_a_ray},
                           {"primitive_tests_per_ray", f.primitive_tests_a_ray},
                           {"hit_share", f.hit_share}});
        }
        fmt::print("{}\n", all.dump(2));
        return 0;
    }
    fmt::print("{:<22}{:<8}{:<13}{:<22}{:>10}{:>10}{:>9}{:>9}{:>7}\n", "scene", "scalar", "method",
               "kind", "count", "M/s", "boxes", "prims", "hits");
    for (const Figure& f : figures) {
        fmt::print("{:<22}{:<8}{:<13}{:<22}{:>10}{:>10.3f}{:>9.1f}{:>9.1f}{:>6.0f}%\n", f.scene,
                   f.precision, f.method, f.kind, f.rays, f.rays_a_second * 1e-6, f.box_tests_a_ray,
                   f.primitive_tests_a_ray, f.hit_share * 100);
    }
    return 0;
}
