// SPDX-License-Identifier: MIT
// Twice the precision of the scalar in use: what decisions near a boundary are made in.
#pragma once

#include <cmath>
#include <limits>

#include "ir/math/double_double.hpp"
#include "ir/math/vec.hpp"

namespace cobble::renderer {

namespace detail {
template <typename T>
struct WideOf;
template <>
struct WideOf<float> {
    using type = double;
};
template <>
struct WideOf<double> {
    using type = math::DoubleDouble;
};
}  // namespace detail

/// double for float, double-double for double. Products of two T are exact in it.
template <typename T>
using Wide = typename detail::WideOf<T>::type;

template <typename T>
math::Vec3<Wide<T>> widen(math::Vec3<T> a) {
    return a.template to<Wide<T>>();
}

inline double wide_sqrt(double a) { return std::sqrt(a); }
inline math::DoubleDouble wide_sqrt(math::DoubleDouble a) { return math::sqrt(a); }

/// Half of the distance from 1 to the next number: the relative error of one rounding.
template <typename T>
inline constexpr T kRounding = std::numeric_limits<T>::epsilon() / 2;

/// Bound on the relative error of n roundings in a row (Higham, Accuracy and Stability of Numerical
/// Algorithms, section 3.1).
template <typename T>
constexpr T gamma(int n) {
    const T nu = static_cast<T>(n) * kRounding<T>;
    return nu / (1 - nu);
}

}  // namespace cobble::renderer
