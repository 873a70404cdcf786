// SPDX-License-Identifier: MIT
// The primitives as the ray loop sees them: local coordinates in T, nothing degenerate.
#pragma once

#include <array>
#include <cstdint>

#include "ir/math/affine.hpp"
#include "ir/math/box_bounds.hpp"
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

using math::BoxBounds;

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
