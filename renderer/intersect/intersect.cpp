// SPDX-License-Identifier: MIT
#include "renderer/intersect/intersect.hpp"

#include <algorithm>
#include <limits>

#include "renderer/intersect/traversal.hpp"
#include "renderer/query/query.hpp"
#include "renderer/wide/wide.hpp"

namespace cobble::renderer {

namespace {

template <bool kAll, typename T>
Search<T, kAll> begin(const Ray<T>& ray, const Exclude& exclude) {
    Search<T, kAll> search;
    constexpr T kMost = std::numeric_limits<T>::max();
    search.best.t = ray.t_max < kMost ? ray.t_max : kMost;
    search.t_min = ray.t_min;
    search.time = ray.time;
    search.exclude = exclude;
    return search;
}

template <typename T>
void finish(const Search<T>& search, Counters& counters) {
    counters.box_tests += search.box_tests;
    counters.primitive_tests += search.primitive_tests;
}

/// Primitives [first, first + count) of one kind in the world. `stop` ends it between primitives.
template <typename T, bool kAll, typename VisitMesh, typename Stop>
void test_range(const Geometry<T>& g, const RayForms<T>& ray, PrimitiveKind kind, std::size_t first,
                std::size_t count, Search<T, kAll>& search, VisitMesh visit_mesh, Stop stop) {
    for (std::size_t i = first; i < first + count && !stop(); ++i) {
        switch (kind) {
            case PrimitiveKind::kTriangle: {
                const auto& t = g.triangles[i];
                test_triangle(ray, t.vertices, t.object, t.face, search);
                break;
            }
            case PrimitiveKind::kSphere: {
                const auto& s = g.spheres[i];
                test_sphere(ray, s.center, s.radius, s.object, search);
                break;
            }
            case PrimitiveKind::kBox:
                test_box(ray, g.boxes[i].bounds, g.boxes[i].object, search);
                break;
            case PrimitiveKind::kMovingTriangle:
                test_moving_triangle(g, ray, g.moving_triangles[i], search);
                break;
            case PrimitiveKind::kMovingSphere:
                test_moving_sphere(g, ray, g.moving_spheres[i], search);
                break;
            case PrimitiveKind::kInstance: {
                const Instance<T>& instance = g.instances[i];
                test_instance(g, ray, instance, search,
                              [&](const PlacedMesh<T>& mesh, const RayForms<T>& inside) {
                                  visit_mesh(mesh, inside, instance.object);
                              });
                break;
            }
        }
    }
}

template <typename T, bool kAll>
void test_mesh_range(const PlacedMesh<T>& mesh, const RayForms<T>& ray, ir::ObjectId object,
                     std::size_t first, std::size_t count, Search<T, kAll>& search) {
    for (std::size_t i = first; i < first + count; ++i) {
        const auto& t = mesh.triangles[i];
        test_triangle(ray, t.vertices, object, t.face, search);
    }
}

template <typename T, bool kAll, typename Stop>
void search_everything(const Geometry<T>& g, const RayForms<T>& ray, Search<T, kAll>& search,
                       Stop stop) {
    const auto visit_mesh = [&](const PlacedMesh<T>& mesh, const RayForms<T>& inside,
                                ir::ObjectId object) {
        test_mesh_range(mesh, inside, object, 0, mesh.triangles.size(), search);
    };
    const auto all = [&](PrimitiveKind kind, std::size_t count) {
        test_range(g, ray, kind, 0, count, search, visit_mesh, stop);
    };
    all(PrimitiveKind::kTriangle, g.triangles.size());
    all(PrimitiveKind::kSphere, g.spheres.size());
    all(PrimitiveKind::kBox, g.boxes.size());
    all(PrimitiveKind::kMovingTriangle, g.moving_triangles.size());
    all(PrimitiveKind::kMovingSphere, g.moving_spheres.size());
    all(PrimitiveKind::kInstance, g.instances.size());
}

template <typename T, typename Stop>
void search_tree(const Geometry<T>& g, const RayForms<T>& ray, Search<T>& search, Stop stop) {
    const auto visit_mesh = [&](const PlacedMesh<T>& mesh, const RayForms<T>& inside,
                                ir::ObjectId object) {
        traverse(
            mesh.tree, inside.slabs, search,
            [&](PrimitiveKind, std::uint32_t first, std::uint32_t count) {
                test_mesh_range(mesh, inside, object, first, count, search);
            },
            stop);
    };
    traverse(
        g.tree, ray.slabs, search,
        [&](PrimitiveKind kind, std::uint32_t first, std::uint32_t count) {
            test_range(g, ray, kind, first, count, search, visit_mesh, stop);
        },
        stop);
}

template <bool kAny, Acceleration kBy, typename T>
Hit<T> run(const PreparedScene<T>& scene, const Ray<T>& ray, const Exclude& exclude,
           Counters& counters) {
    const Geometry<T>& g = scene.geometry;
    Search<T> search = begin<false>(ray, exclude);
    const RayForms<T> forms(ray.origin, ray.direction);
    const auto stop = [&search] { return kAny && search.best.object.valid(); };
    // Planes first: what they hide need not be looked for.
    for (const MovingPrimitive& plane : g.planes) test_plane(g, forms, plane, search);
    if (!stop()) {
        if constexpr (kBy == Acceleration::kBvh) {
            search_tree(g, forms, search, stop);
        } else {
            search_everything(g, forms, search, stop);
        }
    }
    finish(search, counters);
    return search.best;
}

template <typename T>
Hit<T> fast_hit(const PreparedScene<T>& scene, const Ray<T>& ray, const Exclude& exclude, bool any,
                Counters& counters) {
    Hit<T> hit;
    search_wide(WideQuery<T>{&scene.geometry, &ray, &exclude, 1, any, false}, &hit, counters);
    return hit;
}

}  // namespace

template <typename T>
Hit<T> closest_hit(const PreparedScene<T>& scene, const Ray<T>& ray, const Exclude& exclude,
                   Counters& counters) {
    switch (scene.options.acceleration) {
        case Acceleration::kFast:
            return fast_hit(scene, ray, exclude, false, counters);
        case Acceleration::kBvh:
            return run<false, Acceleration::kBvh>(scene, ray, exclude, counters);
        case Acceleration::kBruteForce:
            break;
    }
    return run<false, Acceleration::kBruteForce>(scene, ray, exclude, counters);
}

template <typename T>
bool any_hit(const PreparedScene<T>& scene, const Ray<T>& ray, const Exclude& exclude,
             Counters& counters) {
    switch (scene.options.acceleration) {
        case Acceleration::kFast:
            return fast_hit(scene, ray, exclude, true, counters).object.valid();
        case Acceleration::kBvh:
            return run<true, Acceleration::kBvh>(scene, ray, exclude, counters).object.valid();
        case Acceleration::kBruteForce:
            break;
    }
    return run<true, Acceleration::kBruteForce>(scene, ray, exclude, counters).object.valid();
}

template <typename T>
Hit<T> closest_hit_brute_force(const PreparedScene<T>& scene, const Ray<T>& ray,
                               const Exclude& exclude, Counters& counters) {
    return run<false, Acceleration::kBruteForce>(scene, ray, exclude, counters);
}

template <typename T>
bool any_hit_brute_force(const PreparedScene<T>& scene, const Ray<T>& ray, const Exclude& exclude,
                         Counters& counters) {
    return run<true, Acceleration::kBruteForce>(scene, ray, exclude, counters).object.valid();
}

template <typename T>
std::vector<Hit<T>> enumerate_hits(const PreparedScene<T>& scene, const Ray<T>& ray) {
    const Geometry<T>& g = scene.geometry;
    std::vector<Hit<T>> hits;
    auto search = begin<true>(ray, Exclude{});
    search.all = &hits;
    search.rule = EdgeRule::kHalfOpen;
    const RayForms<T> forms(ray.origin, ray.direction);
    for (const MovingPrimitive& plane : g.planes) test_plane(g, forms, plane, search);
    search_everything(g, forms, search, [] { return false; });
    std::sort(hits.begin(), hits.end(), [](const Hit<T>& a, const Hit<T>& b) {
        if (a.t != b.t) return a.t < b.t;
        if (a.object != b.object) return a.object < b.object;
        return a.face < b.face;
    });
    return hits;
}

#define COBBLE_INSTANTIATE(T)                                                                 \
    template Hit<T> closest_hit(const PreparedScene<T>&, const Ray<T>&, const Exclude&,       \
                                Counters&);                                                   \
    template bool any_hit(const PreparedScene<T>&, const Ray<T>&, const Exclude&, Counters&); \
    template Hit<T> closest_hit_brute_force(const PreparedScene<T>&, const Ray<T>&,           \
                                            const Exclude&, Counters&);                       \
    template bool any_hit_brute_force(const PreparedScene<T>&, const Ray<T>&, const Exclude&, \
                                      Counters&);                                             \
    template std::vector<Hit<T>> enumerate_hits(const PreparedScene<T>&, const Ray<T>&);
COBBLE_INSTANTIATE(float)
COBBLE_INSTANTIATE(double)
#undef COBBLE_INSTANTIATE

}  // namespace cobble::renderer
