// SPDX-License-Identifier: MIT
// The rays to measure with, and what the reference says to each.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "renderer/geometry/hit.hpp"
#include "renderer/geometry/ray.hpp"
#include "renderer/scene/prepared_scene.hpp"
#include "tools/bench/inputs/input.hpp"

namespace cobble::bench {

struct RayKind {
    std::string_view name;
    std::string_view what;
    bool any = false;       ///< asks whether there is a hit, not for the closest
    bool coherent = false;  ///< neighbours in the set go the same way
};

inline constexpr std::array<RayKind, 4> kRayKinds{{
    {"primary", "through the middles of a picture's pixels, closest hit", false, true},
    {"shadow", "from where those hit to a point light, any hit", true, true},
    {"bounce", "from there in a random direction (cosine), closest hit", false, false},
    {"bounce-any", "the same rays, any hit", true, false},
}};

/// Pixels go by tiles of 8 x 8 and within them along Morton's curve, so that 8 rays in a row come
/// from 4 x 2 pixels and 16 from 4 x 4. The other kinds keep that order of their starts.
template <typename T>
struct RaySet {
    RayKind kind;
    std::vector<renderer::Ray<T>> rays;
    std::vector<renderer::Exclude> excludes;
    std::vector<renderer::Hit<T>> expected;  ///< an any hit: only whether it is valid
};

struct PictureSize {
    std::uint32_t width = 512, height = 512;
};

/// One set for each kind, in the order of kRayKinds. `reference` is the input's scene, prepared for
/// the reference. Directions are unit, but for shadow rays, which end at t = 1.
template <typename T>
std::vector<RaySet<T>> make_ray_sets(const renderer::PreparedScene<T>& reference,
                                     const Input& input, PictureSize size);

}  // namespace cobble::bench
