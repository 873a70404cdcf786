// SPDX-License-Identifier: MIT
// What a batch of rays knows, number by number: each in an array of its own over the rays, so that
// a loop over them takes as many at once as the processor's registers hold.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "ir/math/vec.hpp"
#include "renderer/sampling/sobol.hpp"

namespace cobble::renderer {

/// Rays in a batch, at most.
inline constexpr std::size_t kBatchSize = 128;

/// A cache line.
inline constexpr std::size_t kColumnAlignment = 64;

template <typename T>
struct Columns3 {
    alignas(kColumnAlignment) T x[kBatchSize];
    alignas(kColumnAlignment) T y[kBatchSize];
    alignas(kColumnAlignment) T z[kBatchSize];

    [[nodiscard]] math::Vec3<T> at(std::size_t i) const { return {x[i], y[i], z[i]}; }
    void set(std::size_t i, math::Vec3<T> v) {
        x[i] = v.x;
        y[i] = v.y;
        z[i] = v.z;
    }
};

/// Samples of one pixel, one after the other in a batch.
struct PixelRun {
    std::uint32_t x = 0, y = 0;  ///< the pixel, in the whole picture
    std::uint32_t begin = 0;     ///< place of the first one in the batch
    std::uint32_t count = 0;
    std::uint32_t first = 0;  ///< of the pixel's samples
    SobolSeeds seeds;         ///< of Draw::kPixel's points
};

/// Samples that begin: which ones, and where their first rays go.
struct CameraColumns {
    /// Loops over a run may go on to the end of a register.
    static constexpr std::size_t kRoom = kBatchSize + 16;

    std::array<PixelRun, kBatchSize> runs;
    std::size_t run_count = 0;
    /// The place in the picture that the ray goes through.
    alignas(kColumnAlignment) double x[kRoom];
    alignas(kColumnAlignment) double y[kRoom];
};

/// What surfaces of plain materials are computed from.
template <typename T>
struct SurfaceForms {
    /// Vertices of a triangle; centre and radius (b.x) of a sphere; corners of a box.
    Columns3<T> a, b, c;
    Columns3<double> normal;      ///< geometric, unit; not of a sphere
    Columns3<double> na, nb, nc;  ///< at the vertices of a smooth triangle
};

/// The different surfaces that a batch meets: a few, where rays go nearly alike.
template <typename T>
struct SurfaceSlots {
    SurfaceForms<T> forms;
    Columns3<T> kd;  ///< of plain materials
    Columns3<T> specular;
    alignas(kColumnAlignment) T index[kBatchSize];  ///< of refraction; 0: opaque
    alignas(kColumnAlignment) std::uint32_t face[kBatchSize];
    alignas(kColumnAlignment) std::uint32_t object[kBatchSize];
};

/// Hits, compacted and sorted by how their surface is to be computed.
template <typename T>
struct HitColumns {
    alignas(kColumnAlignment) std::int32_t slot[kBatchSize];
    alignas(kColumnAlignment) T t[kBatchSize];
    alignas(kColumnAlignment) T u[kBatchSize];
    alignas(kColumnAlignment) T v[kBatchSize];

    // What SurfacePoint and SurfaceLook say.
    Columns3<T> position;
    Columns3<T> geometric;  ///< never turned
    Columns3<T> normal;     ///< for light
    Columns3<T> kd;
    alignas(kColumnAlignment) T error[kBatchSize];
    alignas(kColumnAlignment) std::int32_t turned[kBatchSize];  ///< toward the viewer: 1

    Columns3<T> light;  ///< that arrived so far
};

/// Which way a direction goes, below kHeadings: a bit for each axis along which it runs backward,
/// and from the fourth on the axis along which it goes farthest.
template <typename T>
std::int32_t heading(math::Vec3<T> direction) {
    const T x = std::fabs(direction.x), y = std::fabs(direction.y), z = std::fabs(direction.z);
    const std::int32_t other = y > z ? 8 : 16;
    const std::int32_t axis = x > (y > z ? y : z) ? 0 : other;
    return axis | (direction.x < T(0) ? 1 : 0) | (direction.y < T(0) ? 2 : 0) |
           (direction.z < T(0) ? 4 : 0);
}
inline constexpr std::size_t kHeadings = 24;

/// Rays that go on from the hits, of one kind.
template <typename T>
struct ChildColumns {
    Columns3<T> from, direction, weight;
    alignas(kColumnAlignment) std::int32_t outward[kBatchSize];
    alignas(kColumnAlignment) std::int32_t matters[kBatchSize];  ///< the weight is not zero
    alignas(kColumnAlignment) std::int32_t heading[kBatchSize];  ///< heading()
};

/// What both kinds have in common.
template <typename T>
struct ScatterColumns {
    Columns3<T> weight;                                    ///< of the ray that came
    alignas(kColumnAlignment) T index[kBatchSize];         ///< of where it travelled
    alignas(kColumnAlignment) T index_beyond[kBatchSize];  ///< of where the refracted ray travels
};

/// One light over the hits that are lit.
template <typename T>
struct LightColumns {
    Columns3<T> direction, target, intensity;  ///< of LightSample
    Columns3<T> share;                         ///< of the light that is sent on, unless hidden
    alignas(kColumnAlignment) std::int32_t matters[kBatchSize];  ///< the share is not zero
};

/// The ray that asks whether it is hidden.
template <typename T>
struct ShadowColumns {
    Columns3<T> from, way;
    alignas(kColumnAlignment) T t_max[kBatchSize];
    alignas(kColumnAlignment) std::int32_t outward[kBatchSize];
};

/// Sums of pixels, as CompensatedSum keeps them.
struct PixelSums {
    Columns3<double> sum, rest;
};

}  // namespace cobble::renderer
