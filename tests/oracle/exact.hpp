// SPDX-License-Identifier: MIT
// Numbers without rounding: sums of doubles that do not overlap (Shewchuk, Adaptive Precision
// Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997), and the orientation
// predicates made of them. Slow and simple; exact while no product over- or underflows.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "ir/math/double_double.hpp"
#include "ir/math/vec.hpp"

namespace cobble::oracle {

class Exact {
  public:
    Exact() = default;
    // A double is the same number here, so the conversion is silent.
    Exact(double value) {
        if (value != 0) parts_.push_back(value);
    }

    [[nodiscard]] int sign() const {
        if (parts_.empty()) return 0;
        return parts_.back() > 0 ? 1 : -1;
    }
    [[nodiscard]] math::DoubleDouble near() const {
        math::DoubleDouble sum;
        for (const double part : parts_) sum += math::DoubleDouble(part);
        return sum;
    }

    friend Exact operator+(Exact a, const Exact& b) {
        for (const double part : b.parts_) a.grow(part);
        return a;
    }
    friend Exact operator-(const Exact& a) {
        Exact result = a;
        for (double& part : result.parts_) part = -part;
        return result;
    }
    friend Exact operator-(const Exact& a, const Exact& b) { return a + -b; }
    friend Exact operator*(const Exact& a, const Exact& b) {
        Exact sum;
        for (const double x : a.parts_) {
            for (const double y : b.parts_) {
                const auto p = math::two_product(x, y);
                sum.grow(p.lo);
                sum.grow(p.hi);
            }
        }
        return sum;
    }

  private:
    void grow(double x) {
        std::vector<double> grown;
        for (const double part : parts_) {
            const auto s = math::two_sum(x, part);
            if (s.lo != 0) grown.push_back(s.lo);
            x = s.hi;
        }
        if (x != 0) grown.push_back(x);
        parts_ = std::move(grown);
    }

    std::vector<double> parts_;  ///< least first
};

using ExactVec = math::Vec3<Exact>;

inline ExactVec exact(math::Vec3d a) { return {Exact(a.x), Exact(a.y), Exact(a.z)}; }
inline ExactVec minus(const ExactVec& a, const ExactVec& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Exact exact_dot(const ExactVec& a, const ExactVec& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline ExactVec exact_cross(const ExactVec& a, const ExactVec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// On which side of the edge a-b the line through o along d passes: (a - o) x (b - o) . d.
inline Exact exact_side(math::Vec3d o, math::Vec3d d, math::Vec3d a, math::Vec3d b) {
    return exact_dot(exact_cross(minus(exact(a), exact(o)), minus(exact(b), exact(o))), exact(d));
}

/// Its sign; by double alone where that is sure: each of the six products of three differences, and
/// their sums, is off by less than 16 roundings of the product of the magnitudes.
inline int side_sign(math::Vec3d o, math::Vec3d d, math::Vec3d a, math::Vec3d b) {
    const math::Vec3d p = a - o;
    const math::Vec3d q = b - o;
    const double rough = dot(cross(p, q), d);
    const double size = 6 * std::sqrt(dot(p, p)) * std::sqrt(dot(q, q)) * std::sqrt(dot(d, d));
    if (std::fabs(rough) > 16 * 0x1p-53 * size) return rough > 0 ? 1 : -1;
    return exact_side(o, d, a, b).sign();
}

/// t of the line's crossing of the plane through a, b and c, to some 2^-100; NaN if parallel.
inline math::DoubleDouble exact_plane_t(math::Vec3d o, math::Vec3d d, math::Vec3d a, math::Vec3d b,
                                        math::Vec3d c) {
    const ExactVec n = exact_cross(minus(exact(b), exact(a)), minus(exact(c), exact(a)));
    return exact_dot(n, minus(exact(a), exact(o))).near() / exact_dot(n, exact(d)).near();
}

}  // namespace cobble::oracle
