// SPDX-License-Identifier: MIT
#include "renderer/intersect/batch.hpp"

#include <cstddef>

namespace cobble::renderer {

template <typename T>
void closest_hits(const PreparedScene<T>& scene, std::span<const Ray<T>> rays,
                  std::span<const Exclude> excludes, std::span<Hit<T>> hits, Counters& counters,
                  Coherence) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        hits[i] = closest_hit(scene, rays[i], excludes[i], counters);
    }
}

template <typename T>
void any_hits(const PreparedScene<T>& scene, std::span<const Ray<T>> rays,
              std::span<const Exclude> excludes, std::span<std::uint8_t> hit, Counters& counters,
              Coherence) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        hit[i] = any_hit(scene, rays[i], excludes[i], counters) ? 1 : 0;
    }
}

#define COBBLE_INSTANTIATE(T)                                                                      \
    template void closest_hits(const PreparedScene<T>&, std::span<const Ray<T>>,                   \
                               std::span<const Exclude>, std::span<Hit<T>>, Counters&, Coherence); \
    template void any_hits(const PreparedScene<T>&, std::span<const Ray<T>>,                       \
                           std::span<const Exclude>, std::span<std::uint8_t>, Counters&,           \
                           Coherence);
COBBLE_INSTANTIATE(float)
COBBLE_INSTANTIATE(double)
#undef COBBLE_INSTANTIATE

}  // namespace cobble::renderer
