// SPDX-License-Identifier: MIT
// A ray and a shape in numbers of 106 binary digits, to decide who is right where float and
// double differ.
#pragma once

#include <array>
#include <cstdint>

#include "ir/math/double_double.hpp"
#include "ir/math/vec.hpp"
#include "renderer/geometry/primitives.hpp"
#include "renderer/geometry/ray.hpp"

namespace cobble::renderer {

enum class Meeting : std::uint8_t { kMisses, kMeets, kUnsure };

struct ExactMeeting {
    Meeting meeting = Meeting::kUnsure;
    math::DoubleDouble t;  ///< if it meets
};

/// Differences of doubles are exact here; products of three are to so much of their largest terms:
/// less than 32 operations, each with a relative error of at most 5 * 2^-106.
inline constexpr double kExactRounding = 0x1p-98;

/// Whether the line of the ray, ahead of its origin, passes through the triangle: certain, or said
/// to be unsure. `rounding`: how far off sums may be, relative to their terms; more than the
/// default if the ray itself was rounded.
ExactMeeting meet_exactly(const Ray<double>& ray, const std::array<math::Vec3d, 3>& vertices,
                          double rounding = kExactRounding);

/// The same for the nearest point of other shapes ahead of the origin.
ExactMeeting meet_exactly(const Ray<double>& ray, const SphereKey<double>& sphere,
                          double rounding = kExactRounding);
ExactMeeting meet_exactly(const Ray<double>& ray, const BoxBounds<double>& box,
                          double rounding = kExactRounding);
ExactMeeting meet_exactly(const Ray<double>& ray, const PlaneKey& plane,
                          double rounding = kExactRounding);

}  // namespace cobble::renderer
