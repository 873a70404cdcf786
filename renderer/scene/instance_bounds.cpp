// SPDX-License-Identifier: MIT
#include "renderer/scene/instance_bounds.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "ir/math/inverse.hpp"
#include "renderer/geometry/wide.hpp"

namespace cobble::renderer {

namespace {

using math::Affined;
using math::Vec3d;

std::array<Vec3d, 8> corners(const BoxBounds<double>& b) {
    std::array<Vec3d, 8> result;
    for (std::size_t i = 0; i < 8; ++i) {
        result[i] = {(i & 1U) != 0 ? b.hi.x : b.lo.x, (i & 2U) != 0 ? b.hi.y : b.lo.y,
                     (i & 4U) != 0 ? b.hi.z : b.lo.z};
    }
    return result;
}

double largest(Vec3d a) {
    const double x = std::fabs(a.x);
    const double y = std::fabs(a.y);
    const double z = std::fabs(a.z);
    return x > y ? (x > z ? x : z) : (y > z ? y : z);
}

/// Adds the image of `shape` under the inverse of a + f (b - a) for all f within `reach` of `at`.
/// Exact relation, with A(f) the linear part, D its change and d that of the offset, x(f) the image
/// of a corner, e = A(at)^-1 D:  x(f) - x(at) = -s (I + s e)^-1 A(at)^-1 (D x(at) + d), s = f - at,
/// so that |x(f) - x(at)| <= |s| |A^-1 (D x + d)| / (1 - |s| |e|).
bool add_interval(const BoxBounds<double>& shape, const Affined& a, const Affined& b, double at,
                  double reach, BoxBounds<double>& box) {
    const std::optional<Affined> back = math::inverse(lerp(a, b, at));
    if (!back) return false;
    Affined change;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 4; ++j) change.rows[i][j] = b.rows[i][j] - a.rows[i][j];
    }
    double e = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        double row = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            row += std::fabs(back->rows[i][0] * change.rows[0][j] +
                             back->rows[i][1] * change.rows[1][j] +
                             back->rows[i][2] * change.rows[2][j]);
        }
        e = row > e ? row : e;
    }
    if (!(reach * e < 0.5)) return false;
    for (const Vec3d corner : corners(shape)) {
        const Vec3d x = back->point(corner);
        const double away = reach * largest(back->vector(change.point(x))) / (1 - reach * e);
        // The doubles here err by far less than the padding in T that follows.
        box.add(x - Vec3d{away, away, away});
        box.add(x + Vec3d{away, away, away});
    }
    return true;
}

/// How far a hit's point may lie outside the image, for rays mapped by `key` in T.
template <typename T>
Vec3d rounding_pad(const InstanceKey<T>& key, const BoxBounds<double>& image) {
    const Affined w = key.world_to_object.template to<double>();
    Vec3d most;
    for (std::size_t i = 0; i < 3; ++i) {
        most[i] = std::fabs(image.lo[i]) > std::fabs(image.hi[i]) ? std::fabs(image.lo[i])
                                                                  : std::fabs(image.hi[i]);
    }
    Vec3d object;
    for (std::size_t i = 0; i < 3; ++i) {
        // Four roundings in a row of the map, four more where its entries are interpolated.
        object[i] = double{gamma<T>(8)} *
                    (((std::fabs(w.rows[i][0]) * most.x + std::fabs(w.rows[i][1]) * most.y) +
                      std::fabs(w.rows[i][2]) * most.z) +
                     std::fabs(w.rows[i][3]));
    }
    Vec3d pad;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& row = key.object_to_world.rows[i];
        pad[i] = (std::fabs(row[0]) * object.x + std::fabs(row[1]) * object.y) +
                 std::fabs(row[2]) * object.z;
    }
    return pad;
}

}  // namespace

template <typename T>
BoxBounds<T> instance_bounds(const BoxBounds<T>& shape, std::span<const InstanceKey<T>> keys) {
    constexpr T kFar = std::numeric_limits<T>::max() / 8;
    const BoxBounds<T> everything{{-kFar, -kFar, -kFar}, {kFar, kFar, kFar}};
    const BoxBounds<double> object{shape.lo.template to<double>(), shape.hi.template to<double>()};
    BoxBounds<double> box;
    for (std::size_t k = 0; k < keys.size(); ++k) {
        for (const Vec3d c : corners(object)) box.add(keys[k].object_to_world.point(c));
    }
    for (std::size_t k = 0; k + 1 < keys.size(); ++k) {
        const Affined a = keys[k].world_to_object.template to<double>();
        const Affined b = keys[k + 1].world_to_object.template to<double>();
        // Steps of a segment: 16 pad by a 32nd of the motion; more only where the map is extreme.
        bool done = false;
        for (int steps = 16; steps <= 1024 && !done; steps *= 4) {
            BoxBounds<double> segment;
            done = true;
            for (int i = 0; i < steps && done; ++i) {
                done = add_interval(object, a, b, (i + 0.5) / steps, 0.5 / steps, segment);
            }
            if (done) box.add(segment);
        }
        if (!done) return everything;
    }
    Vec3d pad;
    for (const auto& key : keys) {
        const Vec3d p = rounding_pad(key, box);
        for (std::size_t i = 0; i < 3; ++i) pad[i] = p[i] > pad[i] ? p[i] : pad[i];
    }
    BoxBounds<T> result;
    for (std::size_t i = 0; i < 3; ++i) {
        // Narrowing rounds to nearest: one epsilon of the magnitude more than makes up for it.
        const double lo = box.lo[i] - pad[i];
        const double hi = box.hi[i] + pad[i];
        const double eps{std::numeric_limits<T>::epsilon()};
        result.lo[i] = static_cast<T>(lo - std::fabs(lo) * eps);
        result.hi[i] = static_cast<T>(hi + std::fabs(hi) * eps);
        if (!(result.lo[i] >= -kFar && result.hi[i] <= kFar)) return everything;
    }
    return result;
}

template BoxBounds<float> instance_bounds(const BoxBounds<float>&,
                                          std::span<const InstanceKey<float>>);
template BoxBounds<double> instance_bounds(const BoxBounds<double>&,
                                           std::span<const InstanceKey<double>>);

}  // namespace cobble::renderer
