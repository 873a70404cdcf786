// SPDX-License-Identifier: MIT
// How a scene's geometry stands up to float: rays aimed where float errs first, cast in float and
// in double, and the answers compared.
//
// Float may be off by the bound that the tests of the renderer hold it to: 8 u of the coordinates
// that a hit depends on (u = 2^-24), and what mapping into an instance may err. A float answer is
// right if it lies between the nearest and the farthest of what double sees along the same ray and
// along sixteen around it, up to that bound away. So rays at a silhouette are right either way, and
// what is counted is beyond what rounding explains:
// - a crack: float sees through, to something behind all of these or to nothing;
// - a changed hit: float sees something in front of all of these;
// - a self-hit: a ray that leaves a float hit as shading does meets, within the bound that it
//   started at, the same surface or one that lies with it, from behind, and no ray that leaves the
//   hits in double so meets anything so near.
// None is expected: each is a fault of the renderer or of what the scene asks of float.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "ir/math/vec.hpp"
#include "ir/scene/scene.hpp"
#include "renderer/geometry/hit.hpp"
#include "renderer/geometry/ray.hpp"
#include "renderer/scene/preparation_note.hpp"
#include "renderer/scene/prepared_scene.hpp"

namespace cobble::renderer {

struct StabilityOptions {
    std::uint64_t rays = 200000;  ///< in all, spread evenly over the objects; see kLargestShare
    std::uint32_t height = 480;   ///< of the picture whose pixels are measured
    /// What answers the rays in float, if not closest_hit(): another kernel to be measured.
    std::function<Hit<float>(const PreparedScene<float>&, const Ray<float>&, const Exclude&)> cast =
        {};
};

/// Of the rays, no object gets more than one in this many: one alone would learn nothing more.
inline constexpr std::uint64_t kLargestShare = 100;

/// Below this many ulps a pixel lies within the bound of 8 u, which is 4 ulps where they are
/// smallest: neighbouring pixels may see the same.
inline constexpr double kFewUlps = 4;

enum class StabilityFault : std::uint8_t { kCrack, kChanged, kSelfHit };

/// One object, with the faults at hits on it: a crack counts for what double sees there.
struct ObjectStability {
    ir::ObjectId object;
    std::uint64_t rays = 0;  ///< aimed at it
    std::uint64_t hits = 0;  ///< float hits on it, whatever was aimed at
    std::uint64_t cracks = 0;
    std::uint64_t changed = 0;
    std::uint64_t self_hits = 0;
    /// The least number of float's steps, at the size of the local coordinates of the eye and the
    /// hit, that a pixel in the middle of the picture is wide at a hit. Infinite without hits.
    double least_ulps = std::numeric_limits<double>::infinity();

    struct Example {
        StabilityFault fault = StabilityFault::kCrack;
        math::Vec3d position;  ///< world
        std::uint32_t face = 0;
    };
    std::optional<Example> example;  ///< the first fault

    [[nodiscard]] std::uint64_t faults() const { return cracks + changed + self_hits; }
};

struct Stability {
    std::uint64_t rays = 0;
    std::vector<ObjectStability> objects;  ///< worst first: faults, then ulps, then index
    std::vector<PreparationNote> notes;    ///< of preparing the scene in float

    /// No cracks, changed hits or self-hits.
    [[nodiscard]] bool clean() const;
};

/// Deterministic. Some 5 microseconds a ray and more in scenes of many triangles; memory of the
/// scene prepared in float and in double.
Stability measure_stability(const ir::Scene& scene, const StabilityOptions& options);

}  // namespace cobble::renderer
