// SPDX-License-Identifier: MIT
// Rays a second of the reference intersection, one thread: by kind of ray and scene, in float and
// in double, through the tree and by brute force.
//
//   bench_rays [--json] [--seconds S]
//
// Primary rays come from a grid over the picture, in rows. From each of their hits start a shadow
// ray toward one light, the mirrored ray, the ray refracted into a body of index 1.5, and a diffuse
// ray in a random direction of the upper half. Generating them is not timed, nothing is shaded.
// Every figure is the best of the passes that fit into S seconds, and at least 3.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "renderer/intersect/intersect.hpp"
#include "renderer/intersect/surface.hpp"
#include "renderer/shading/fresnel.hpp"
#include "tools/bench/rays_scenes.hpp"
#include "tools/bench/timing.hpp"

namespace {

using cobble::bench::best_seconds;
using cobble::math::Vec3;
using cobble::math::Vec3d;
using namespace cobble::renderer;
namespace ir = cobble::ir;

template <typename T>
struct Query {
    Ray<T> ray;
    Exclude exclude;
};

constexpr std::array kKinds = {"primary", "shadow", "reflection", "refraction", "diffuse"};
constexpr std::size_t kShadow = 1;  // the one kind that asks for any hit

template <typename T>
using Queries = std::array<std::vector<Query<T>>, kKinds.size()>;

/// One kind of ray through one prepared scene.
struct Figure {
    std::size_t rays = 0;
    double rays_a_second = 0;
    double boxes_a_ray = 0;
    double primitives_a_ray = 0;
    double hit_share = 0;
};

/// A scene in one precision.
struct Results {
    std::array<Figure, kKinds.size()> tree, brute;
    double primitives_prepared_a_second = 0;  ///< with the tree
    std::size_t primitives = 0;
};

template <typename T>
Queries<T> queries_of(const PreparedScene<T>& scene, Vec3d eye, std::uint32_t side) {
    Queries<T> queries;
    auto& [primary, shadow, reflection, refraction, diffuse] = queries;
    const Vec3d light{3, 4, 2};
    std::uint64_t state = 7;
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const double u = 2 * (x + 0.5) / side - 1;
            const double v = 2 * (y + 0.5) / side - 1;
            Query<T> q;
            q.ray.origin = scene.to_local(eye);
            q.ray.direction = normalize(Vec3d{0.45 * u, 0.45 * v - 0.2, -1}).template to<T>();
            primary.push_back(q);
            Counters counters;
            const auto hit = closest_hit(scene, q.ray, q.exclude, counters);
            Vec3d random = cobble::bench::next_direction(state);
            if (!hit) continue;
            const auto s = surface_at(scene, q.ray, hit);
            const auto to_light = leave_toward(s, scene.to_local(light), T(0));
            shadow.push_back({to_light.ray, to_light.exclude});
            const auto away = [&s](Vec3<T> direction) -> Query<T> {
                const auto departure = leave(s, direction, T(0));
                return {departure.ray, departure.exclude};
            };
            Vec3<T> normal = s.geometric_normal;
            if (dot(normal, q.ray.direction) > 0) normal = -normal;
            reflection.push_back(away(reflect(q.ray.direction, normal)));
            refraction.push_back(away(refract(q.ray.direction, normal, T(1), T(1.5)).direction));
            if (dot(random, normal.template to<double>()) < 0) random = -random;
            diffuse.push_back(away(random.to<T>()));
        }
    }
    return queries;
}

template <typename T>
Figure measure(const PreparedScene<T>& scene, const std::vector<Query<T>>& queries, bool any,
               double seconds) {
    constexpr int kLeastPasses = 3;
    Counters counters;
    std::size_t hits = 0;
    const double best = best_seconds(seconds, kLeastPasses, [&] {
        counters = {};
        hits = 0;
        for (const auto& q : queries) {
            const bool hit = any ? any_hit(scene, q.ray, q.exclude, counters)
                                 : bool(closest_hit(scene, q.ray, q.exclude, counters));
            hits += hit ? 1 : 0;
        }
        return hits;
    });
    const auto n = static_cast<double>(queries.size());
    return {queries.size(), n / best, static_cast<double>(counters.box_tests) / n,
            static_cast<double>(counters.primitive_tests) / n, static_cast<double>(hits) / n};
}

template <typename T>
Results run(const ir::Scene& source, double seconds) {
    constexpr std::uint32_t kSide = 250;
    Results results;
    PrepareOptions options;
    const double preparing = best_seconds(0, 3, [&] { return prepare<T>(source, options); });
    const auto tree = prepare<T>(source, options);
    results.primitives = tree.geometry.triangles.size() + tree.geometry.spheres.size();
    const auto primitives = static_cast<double>(results.primitives);
    results.primitives_prepared_a_second = primitives / preparing;
    options.acceleration = Acceleration::kBruteForce;
    const auto brute = prepare<T>(source, options);

    Queries<T> queries = queries_of(tree, source.camera.center, kSide);
    for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
        auto& rays = queries[kind];
        results.tree[kind] = measure(tree, rays, kind == kShadow, seconds);
        // As many of them, from all over the picture, as brute force does in a quarter of a second.
        constexpr double kTests = 2e7;
        const auto every =
            static_cast<std::size_t>(1 + primitives * static_cast<double>(rays.size()) / kTests);
        std::vector<Query<T>> some;
        for (std::size_t i = 0; i < rays.size(); i += every) some.push_back(rays[i]);
        results.brute[kind] = measure(brute, some, kind == kShadow, seconds);
    }
    return results;
}

struct SceneResults {
    std::string name;
    Results in_float, in_double;
};

nlohmann::json as_json(const SceneResults& scene) {
    auto all = nlohmann::json::array();
    for (const bool exact : {false, true}) {
        const Results& results = exact ? scene.in_double : scene.in_float;
        for (const bool tree : {true, false}) {
            for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
                const Figure& f = (tree ? results.tree : results.brute)[kind];
                all.push_back({{"scene", scene.name},
                               {"precision", exact ? "double" : "float"},
                               {"method", tree ? "bvh" : "brute force"},
                               {"kind", kKinds[kind]},
                               {"rays", f.rays},
                               {"rays_per_second", f.rays_a_second},
                               {"box_tests_per_ray", f.boxes_a_ray},
                               {"primitive_tests_per_ray", f.primitives_a_ray},
                               {"hit_share", f.hit_share}});
            }
        }
        all.push_back({{"scene", scene.name},
                       {"precision", exact ? "double" : "float"},
                       {"method", "bvh"},
                       {"kind", "prepare"},
                       {"primitives", results.primitives},
                       {"primitives_per_second", results.primitives_prepared_a_second}});
    }
    return all;
}

void print(const SceneResults& scene) {
    const auto& [name, f, d] = scene;
    fmt::print(
        "{}: prepared with its tree at {:.2f} (float) and {:.2f} (double) million primitives "
        "a second\n",
        name, f.primitives_prepared_a_second * 1e-6, d.primitives_prepared_a_second * 1e-6);
    fmt::print("  {:<11}{:>6}{:>6}{:>8}{:>8}{:>8}{:>10}{:>10}{:>10}{:>10}{:>8}\n", "", "hits",
               "boxes", "prims", "BVH", "BVH", "float :", "brute", "brute", "BVH :", "BVH :");
    fmt::print("  {:<11}{:>6}{:>6}{:>8}{:>8}{:>8}{:>10}{:>10}{:>10}{:>10}{:>8}\n", "kind", "%",
               "/ray", "/ray", "float", "double", "double", "float", "double", "brute f",
               "brute d");
    for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
        const double tree = f.tree[kind].rays_a_second * 1e-6;
        const double tree_double = d.tree[kind].rays_a_second * 1e-6;
        const double brute = f.brute[kind].rays_a_second * 1e-6;
        const double brute_double = d.brute[kind].rays_a_second * 1e-6;
        fmt::print(
            "  {:<11}{:>6.0f}{:>6.1f}{:>8.1f}{:>8.2f}{:>8.2f}{:>10.1f}{:>10.4f}{:>10.4f}"
            "{:>10.0f}{:>8.0f}\n",
            kKinds[kind], f.tree[kind].hit_share * 100, f.tree[kind].boxes_a_ray,
            f.tree[kind].primitives_a_ray, tree, tree_double, tree / tree_double, brute,
            brute_double, tree / brute, tree_double / brute_double);
    }
    fmt::print("\n");
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"rays a second of the reference intersection, one thread"};
    bool json = false;
    double seconds = 0.3;
    app.add_flag("--json", json, "one JSON array instead of tables");
    app.add_option("--seconds", seconds, "time for each figure")->check(CLI::Range(0.0, 60.0));
    CLI11_PARSE(app, argc, argv);

    const std::array<std::pair<const char*, ir::Scene>, 3> scenes{
        {{"mesh of 480 triangles", cobble::bench::mesh_scene(16)},
         {"mesh of 70 312 triangles", cobble::bench::mesh_scene(188)},
         {"10 000 spheres", cobble::bench::sphere_scene(10000)}}};
    if (!json) {
        fmt::print(
            "== Rays: million a second, one thread, intersection alone (shadow: any hit, others: "
            "closest)\n\n");
    }
    auto all = nlohmann::json::array();
    for (const auto& [name, scene] : scenes) {
        const SceneResults results{name, run<float>(scene, seconds), run<double>(scene, seconds)};
        if (json) {
            for (auto& row : as_json(results)) all.push_back(row);
        } else {
            print(results);
        }
    }
    if (json) {
        fmt::print("{}\n", all.dump(2));
    } else {
        fmt::print(
            "hits: of the rays; boxes and prims: tests a ray in the tree; x : y is how many times "
            "as fast x is.\n\n");
    }
    return 0;
}
