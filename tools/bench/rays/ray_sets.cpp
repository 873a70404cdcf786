// SPDX-License-Identifier: MIT
#include "tools/bench/rays/ray_sets.hpp"

#include <cmath>
#include <cstdint>

#include "ir/math/elementary.hpp"
#include "renderer/intersect/intersect.hpp"
#include "renderer/intersect/surface.hpp"
#include "tools/bench/inputs/random.hpp"

namespace cobble::bench {

using math::Vec3d;

namespace {

struct Pixel {
    std::uint32_t x, y;
};

std::vector<Pixel> pixels_by_tiles(PictureSize size) {
    std::vector<Pixel> pixels;
    for (std::uint32_t y0 = 0; y0 < size.height; y0 += 8) {
        for (std::uint32_t x0 = 0; x0 < size.width; x0 += 8) {
            for (std::uint32_t i = 0; i < 64; ++i) {
                const Pixel p{x0 + ((i & 1) | (i >> 1 & 2) | (i >> 2 & 4)),
                              y0 + ((i >> 1 & 1) | (i >> 2 & 2) | (i >> 3 & 4))};
                if (p.x < size.width && p.y < size.height) pixels.push_back(p);
            }
        }
    }
    return pixels;
}

Vec3d direction_of(const ir::Camera& camera, PictureSize size, Pixel pixel) {
    const auto angle = math::sincos(camera.angle / 2);
    const double tangent = angle.sin / angle.cos;
    const double right = (2 * (pixel.x + 0.5) - size.width) / size.height;
    const double up = (size.height - 2 * (pixel.y + 0.5)) / size.height;
    return normalize(camera.forward + camera.right * (right * tangent) +
                     camera.up * (up * tangent));
}

}  // namespace

template <typename T>
std::vector<RaySet<T>> make_ray_sets(const renderer::PreparedScene<T>& reference,
                                     const Input& input, PictureSize size) {
    std::vector<RaySet<T>> sets(kRayKinds.size());
    for (std::size_t i = 0; i < sets.size(); ++i) sets[i].kind = kRayKinds[i];
    const Vec3d eye = input.scene.camera.center;
    const Vec3d light = input.scene.lights[0].position;
    renderer::Counters counters;
    Random random(7);
    for (const Pixel& pixel : pixels_by_tiles(size)) {
        renderer::Ray<T> ray;
        ray.origin = reference.to_local(eye);
        ray.direction = direction_of(input.scene.camera, size, pixel).template to<T>();
        sets[0].rays.push_back(ray);
        sets[0].excludes.emplace_back();
        const auto hit = closest_hit(reference, ray, {}, counters);
        sets[0].expected.push_back(hit);
        const Vec3d ball = random.direction();
        if (!hit) continue;
        const auto surface = surface_at(reference, ray, hit);
        const auto to_light = leave_toward(surface, reference.to_local(light), T(0));
        sets[1].rays.push_back(to_light.ray);
        sets[1].excludes.push_back(to_light.exclude);
        // The normal toward the viewer, plus a point of the unit sphere: Lambert's cosine.
        auto normal = surface.geometric_normal.template to<double>();
        if (dot(normal, ray.direction.template to<double>()) > 0) normal = -normal;
        const auto away = leave(surface, normalize(normal + ball).template to<T>(), T(0));
        sets[2].rays.push_back(away.ray);
        sets[2].excludes.push_back(away.exclude);
    }
    sets[3].rays = sets[2].rays;
    sets[3].excludes = sets[2].excludes;
    for (std::size_t i = 1; i < sets.size(); ++i) {
        for (std::size_t k = 0; k < sets[i].rays.size(); ++k) {
            const renderer::Ray<T>& ray = sets[i].rays[k];
            const renderer::Exclude& exclude = sets[i].excludes[k];
            renderer::Hit<T> hit;
            if (!sets[i].kind.any) {
                hit = closest_hit(reference, ray, exclude, counters);
            } else if (any_hit(reference, ray, exclude, counters)) {
                hit.object = ir::ObjectId{0};
            }
            sets[i].expected.push_back(hit);
        }
    }
    return sets;
}

template std::vector<RaySet<float>> make_ray_sets(const renderer::PreparedScene<float>&,
                                                  const Input&, PictureSize);
template std::vector<RaySet<double>> make_ray_sets(const renderer::PreparedScene<double>&,
                                                   const Input&, PictureSize);

}  // namespace cobble::bench
