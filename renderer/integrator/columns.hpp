// SPDX-License-Identifier: MIT
// What a batch of rays knows, number by number: each in an array of its own over the rays, so that
// a loop over them takes as many at once as the processor's registers hold.
#pragma once

#include <cstddef>
#include <cstdint>

#include "ir/math/vec.hpp"

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

/// Samples that begin: of which pixel, which one, and where its first ray goes.
template <typename T>
struct CameraColumns {
    alignas(kColumnAlignment) std::uint32_t sample[kBatchSize];
    alignas(kColumnAlignment) std::uint64_t set[kBatchSize];  ///< of Draw::kPixel's points
    /// The pixel's upper left corner, then the place that the ray goes through.
    alignas(kColumnAlignment) double x[kBatchSize];
    alignas(kColumnAlignment) double y[kBatchSize];
    Columns3<T> direction;
};

/// The different surfaces that a batch meets: a few, where rays go nearly alike.
template <typename T>
struct SurfaceSlots {
    /// Vertices of a triangle; centre and radius (b.x) of a sphere; corners of a box.
    Columns3<double> a, b, c;
    Columns3<double> normal;      ///< geometric, unit; not of a sphere
    Columns3<double> na, nb, nc;  ///< at the vertices of a smooth triangle
    Columns3<T> kd;               ///< of plain materials
    Columns3<T> specular;
    alignas(kColumnAlignment) T index[kBatchSize];  ///< of refraction; 0: opaque
    alignas(kColumnAlignment) std::uint32_t face[kBatchSize];
    alignas(kColumnAlignment) std::uint32_t object[kBatchSize];
};

/// Hits, compacted and sorted by how their surface is to be computed.
template <typename T>
struct HitColumns {
    alignas(kColumnAlignment) std::int32_t slot[kBatchSize];
    Columns3<T> from, direction;  ///< of the ray
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

/// Rays that go on from the hits, of one kind.
template <typename T>
struct ChildColumns {
    Columns3<T> from, direction, weight;
    alignas(kColumnAlignment) std::int32_t outward[kBatchSize];
    alignas(kColumnAlignment) std::int32_t matters[kBatchSize];  ///< the weight is not zero
};

template <typename T>
struct ScatterColumns {
    Columns3<T> weight;                             ///< of the ray that came
    alignas(kColumnAlignment) T index[kBatchSize];  ///< of where it travelled
    ChildColumns<T> reflected, refracted;
    alignas(kColumnAlignment) T index_beyond[kBatchSize];  ///< of where the refracted ray travels
};

/// One light over the hits that are lit.
template <typename T>
struct LightColumns {
    Columns3<T> direction, target, intensity;  ///< of LightSample
    Columns3<T> share;                         ///< of the light that is sent on, unless hidden
    /// The ray that asks whether it is hidden.
    Columns3<T> from, way;
    alignas(kColumnAlignment) T t_max[kBatchSize];
    alignas(kColumnAlignment) std::int32_t outward[kBatchSize];
    alignas(kColumnAlignment) std::int32_t matters[kBatchSize];  ///< the share is not zero
};

/// Sums of pixels, as CompensatedSum keeps them.
struct PixelSums {
    Columns3<double> sum, rest;
};

}  // namespace cobble::renderer
