// SPDX-License-Identifier: MIT
// The primitives as the ray loop sees them: local coordinates in T, nothing degenerate.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "ir/math/affine.hpp"
#include "ir/math/vec.hpp"
#include "ir/scene/ids.hpp"

namespace cobble::renderer {

enum class PrimitiveKind : std::uint8_t {
    kTriangle,
    kSphere,
    kBox,
    kMovingTriangle,
    kMovingSphere,
    kInstance,
};
inline constexpr std::size_t kPrimitiveKinds = 6;

/// An axis-aligned box; inside out (lo = inf, hi = -inf) if empty.
template <typename T>
struct BoxBounds {
    math::Vec3<T> lo{std::numeric_limits<T>::infinity(), std::numeric_limits<T>::infinity(),
                     std::numeric_limits<T>::infinity()};
    math::Vec3<T> hi{-std::numeric_limits<T>::infinity(), -std::numeric_limits<T>::infinity(),
                     -std::numeric_limits<T>::infinity()};

    constexpr void add(math::Vec3<T> p) {
        for (std::size_t i = 0; i < 3; ++i) {
            lo[i] = p[i] < lo[i] ? p[i] : lo[i];
            hi[i] = p[i] > hi[i] ? p[i] : hi[i];
        }
    }
    constexpr void add(const BoxBounds& b) {
        for (std::size_t i = 0; i < 3; ++i) {
            lo[i] = b.lo[i] < lo[i] ? b.lo[i] : lo[i];
            hi[i] = b.hi[i] > hi[i] ? b.hi[i] : hi[i];
        }
    }
    [[nodiscard]] constexpr bool empty() const { return !(lo.x <= hi.x); }
    friend constexpr bool operator==(const BoxBounds&, const BoxBounds&) = default;
};

template <typename T>
struct TrianglePrimitive {
    std::array<math::Vec3<T>, 3> vertices;
    ir::ObjectId object;
    std::uint32_t face = 0;
};

template <typename T>
struct SpherePrimitive {
    math::Vec3<T> center;
    T radius = 0;  ///< above 0
    ir::ObjectId object;
};

template <typename T>
struct BoxPrimitive {
    BoxBounds<T> bounds;
    ir::ObjectId object;
};

/// `keys` states at equal steps of time, linear in between; at [first, first + keys) of the
/// scene's arrays of keys.
struct MovingPrimitive {
    std::uint32_t first = 0;
    std::uint32_t keys = 0;
    ir::ObjectId object;
};

template <typename T>
struct SphereKey {
    math::Vec3<T> center;
    T radius = 0;
};

/// The points p with p . normal = offset, at one time. Double whatever T is: planes reach far, and
/// there are few of them. The normal is unit only of a plane that rests.
struct PlaneKey {
    math::Vec3d normal;
    double offset = 0;
};

}  // namespace cobble::renderer
