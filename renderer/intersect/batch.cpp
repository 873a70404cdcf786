// SPDX-License-Identifier: MIT
#include "renderer/intersect/batch.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "renderer/wide/wide.hpp"

namespace cobble::renderer {

template <typename T>
void closest_hits(const PreparedScene<T>& scene, std::span<const Ray<T>> rays,
                  std::span<const Exclude> excludes, std::span<Hit<T>> hits, Counters& counters,
                  Coherence coherence) {
    if (scene.options.acceleration == Acceleration::kFast) {
        search_wide(WideQuery<T>{&scene.geometry, rays.data(), excludes.data(), rays.size(), false,
                                 coherence == Coherence::kCoherent},
                    hits.data(), counters);
        return;
    }
    for (std::size_t i = 0; i < rays.size(); ++i) {
        hits[i] = closest_hit(scene, rays[i], excludes[i], counters);
    }
}

template <typename T>
void any_hits(const PreparedScene<T>& scene, std::span<const Ray<T>> rays,
              std::span<const Exclude> excludes, std::span<Hit<T>> hits, Counters& counters,
              Coherence coherence) {
    if (scene.options.acceleration == Acceleration::kFast) {
        search_wide(WideQuery<T>{&scene.geometry, rays.data(), excludes.data(), rays.size(), true,
                                 coherence == Coherence::kCoherent},
                    hits.data(), counters);
        return;
    }
    for (std::size_t i = 0; i < rays.size(); ++i) {
        // Which object it is means nothing.
        const bool any = any_hit(scene, rays[i], excludes[i], counters);
        hits[i].object = any ? ir::ObjectId{0} : ir::ObjectId{};
    }
}

template <typename T>
void any_hits(const PreparedScene<T>& scene, std::span<const Ray<T>> rays,
              std::span<const Exclude> excludes, std::span<std::uint8_t> hit, Counters& counters,
              Coherence coherence) {
    constexpr std::size_t kPart = 256;
    std::array<Hit<T>, kPart> part;
    for (std::size_t first = 0; first < rays.size(); first += kPart) {
        const std::size_t count = std::min(kPart, rays.size() - first);
        any_hits(scene, rays.subspan(first, count), excludes.subspan(first, count),
                 std::span<Hit<T>>(part).first(count), counters, coherence);
        for (std::size_t i = 0; i < count; ++i) hit[first + i] = part[i] ? 1 : 0;
    }
}

template <typename T>
void closest_hits(const PreparedScene<T>& scene, const RayColumns<T>& rays, std::span<Hit<T>> hits,
                  Counters& counters, Coherence coherence) {
    if (scene.options.acceleration == Acceleration::kFast) {
        search_wide(WideQuery<T>{&scene.geometry, nullptr, nullptr, hits.size(), false,
                                 coherence == Coherence::kCoherent, &rays},
                    hits.data(), counters);
        return;
    }
    for (std::size_t i = 0; i < hits.size(); ++i) {
        hits[i] = closest_hit(scene, rays.ray(i), rays.exclude(i), counters);
    }
}

template <typename T>
void any_hits(const PreparedScene<T>& scene, const RayColumns<T>& rays, std::span<Hit<T>> hits,
              Counters& counters, Coherence coherence) {
    if (scene.options.acceleration == Acceleration::kFast) {
        search_wide(WideQuery<T>{&scene.geometry, nullptr, nullptr, hits.size(), true,
                                 coherence == Coherence::kCoherent, &rays},
                    hits.data(), counters);
        return;
    }
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const bool any = any_hit(scene, rays.ray(i), rays.exclude(i), counters);
        hits[i].object = any ? ir::ObjectId{0} : ir::ObjectId{};
    }
}

#define COBBLE_INSTANTIATE(T)                                                                      \
    template void closest_hits(const PreparedScene<T>&, std::span<const Ray<T>>,                   \
                               std::span<const Exclude>, std::span<Hit<T>>, Counters&, Coherence); \
    template void any_hits(const PreparedScene<T>&, std::span<const Ray<T>>,                       \
                           std::span<const Exclude>, std::span<std::uint8_t>, Counters&,           \
                           Coherence);                                                             \
    template void any_hits(const PreparedScene<T>&, std::span<const Ray<T>>,                       \
                           std::span<const Exclude>, std::span<Hit<T>>, Counters&, Coherence);     \
    template void closest_hits(const PreparedScene<T>&, const RayColumns<T>&, std::span<Hit<T>>,   \
                               Counters&, Coherence);                                              \
    template void any_hits(const PreparedScene<T>&, const RayColumns<T>&, std::span<Hit<T>>,       \
                           Counters&, Coherence);
COBBLE_INSTANTIATE(float)
COBBLE_INSTANTIATE(double)
#undef COBBLE_INSTANTIATE

}  // namespace cobble::renderer
