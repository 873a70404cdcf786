// SPDX-License-Identifier: MIT
// How a scene's geometry stands up to float: rays aimed where float errs first, cast in float by
// what renders (the fast core, in packets and one by one) and in double, and the answers compared.
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
// - lost: an object that no ray in float meets, though rays in double at its faces, from where the
//   camera is and to where the object is before either is narrowed, meet it first.
// - too coarse: an object with a hit where a pixel is narrower than a step of float, so that
//   neighbouring pixels are one.
// None is expected: each is a fault of the renderer or of what the scene asks of float. Where float
// and double name two different primitives, within rounding or not, arithmetic of 106 binary digits
// says which of them is met first.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
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
    std::uint32_t width = 640;    ///< of the picture whose pixels are measured
    std::uint32_t height = 480;
    Acceleration acceleration = Acceleration::kFast;
    /// What answers the rays in float, if not closest_hits(): another kernel to be measured. All
    /// spans have one length.
    std::function<void(const PreparedScene<float>&, std::span<const Ray<float>>,
                       std::span<const Exclude>, std::span<Hit<float>>)>
        cast = {};
    /// Called every few hundred rays with the part that is done, in [0, 1], and how many rays of
    /// all kinds that took; false: that is enough.
    std::function<bool(double, std::uint64_t)> go_on = {};
};

/// Of the rays, no object gets more than one in this many: one alone would learn nothing more.
inline constexpr std::uint64_t kLargestShare = 100;

/// Below this many ulps a pixel lies within the bound of 8 u, which is 4 ulps where they are
/// smallest: neighbouring pixels may see the same.
inline constexpr double kFewUlps = 4;

/// Below this many float is too coarse: its steps are wider than pixels, and can be seen.
inline constexpr double kLeastUlps = 1;

enum class StabilityFault : std::uint8_t { kCrack, kChanged, kSelfHit, kLost };

/// How finely float can tell points apart at a hit.
struct PixelPrecision {
    double distance = 0;   ///< from the camera
    double pixel = 0;      ///< how wide a pixel of the picture is there, world units
    double step = 0;       ///< float's, at the largest local coordinate of the camera and the hit
    math::Vec3d position;  ///< world
    ir::ObjectId object;

    /// The number of float's steps across a pixel.
    [[nodiscard]] double ulps() const { return pixel / step; }
};

/// One object, with the faults at hits on it: a crack counts for what double sees there.
struct ObjectStability {
    ir::ObjectId object;
    bool closed = false;     ///< a mesh each of whose edges belongs to two faces
    std::uint64_t rays = 0;  ///< aimed at it
    std::uint64_t hits = 0;  ///< float hits on it, whatever was aimed at
    std::uint64_t cracks = 0;
    std::uint64_t changed = 0;
    std::uint64_t self_hits = 0;
    /// Rays along which double sees it, which float sees along none at all. Not looked for where
    /// the measurement was stopped, or of what would cover less than a thousandth of a pixel.
    std::uint64_t lost = 0;
    std::optional<PixelPrecision> worst;  ///< the least ulps of all hits on it
    std::uint64_t faces = 1;              ///< of a mesh; anything else is one
    /// Those that are not there in float, as the notes say, if they can be seen: they would cover
    /// more than a thousandth of a pixel together.
    std::uint64_t faces_lost = 0;

    struct Example {
        StabilityFault fault = StabilityFault::kCrack;
        math::Vec3d position;  ///< world
        std::uint32_t face = 0;
    };
    std::optional<Example> example;  ///< the first fault along a ray

    /// Along rays.
    [[nodiscard]] std::uint64_t faults() const { return cracks + changed + self_hits + lost; }
    /// Infinite without hits.
    [[nodiscard]] double least_ulps() const {
        return worst ? worst->ulps() : std::numeric_limits<double>::infinity();
    }
    [[nodiscard]] bool too_coarse() const { return least_ulps() < kLeastUlps; }
    [[nodiscard]] bool sound() const { return faults() == 0 && !too_coarse(); }
};

/// Rays along which float and double name different primitives, explained by rounding or not, by
/// whose is met first in exact arithmetic.
struct PrimitiveChanges {
    std::uint64_t rays = 0;
    std::uint64_t for_double = 0, for_float = 0, for_both = 0;
    std::uint64_t open = 0;  ///< too close to call
};

struct Stability {
    std::uint64_t rays = 0;                ///< aimed at objects
    std::uint64_t picture_rays = 0;        ///< through the picture, on a grid
    std::uint64_t departures = 0;          ///< that left what was hit
    bool complete = true;                  ///< all rays that were to be cast have been
    std::vector<ObjectStability> objects;  ///< worst first: faults, then ulps, then index
    PrimitiveChanges changes;
    /// Among the rays through the picture; nothing if they hit nothing.
    std::optional<PixelPrecision> nearest, farthest;
    std::optional<PixelPrecision> worst;  ///< the least ulps of all hits
    std::vector<PreparationNote> notes;   ///< of preparing the scene in float

    /// All objects are sound: no cracks, changed hits or self-hits, none lost or too coarse.
    [[nodiscard]] bool clean() const;
};

/// Deterministic, unless `go_on` stops it: then what has been cast until then is told
/// of, a few rays for each object. Some 1 to 2 microseconds a ray; memory of the scene prepared in
/// float and in double.
Stability measure_stability(const ir::Scene& scene, const StabilityOptions& options);

}  // namespace cobble::renderer
