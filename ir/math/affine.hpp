// SPDX-License-Identifier: MIT
// Affine maps: three rows of four numbers; the last row of the 4x4 matrix is always 0 0 0 1.
#pragma once

#include <array>

#include "ir/math/vec.hpp"

namespace cobble::math {

/// Maps a point p to ((r[i][0] p.x + r[i][1] p.y) + r[i][2] p.z) + r[i][3] for each row i: this
/// order of operations is part of what an instance means.
template <typename T>
struct Affine {
    std::array<std::array<T, 4>, 3> rows{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

    [[nodiscard]] constexpr Vec3<T> point(Vec3<T> p) const {
        return {row_point(0, p), row_point(1, p), row_point(2, p)};
    }
    [[nodiscard]] constexpr Vec3<T> vector(Vec3<T> v) const {
        return {row_vector(0, v), row_vector(1, v), row_vector(2, v)};
    }
    /// Transpose times v, for normals: call it on the inverse of the map of points.
    [[nodiscard]] constexpr Vec3<T> transposed_vector(Vec3<T> v) const {
        return {column_dot(0, v), column_dot(1, v), column_dot(2, v)};
    }
    template <typename U>
    [[nodiscard]] constexpr Affine<U> to() const {
        Affine<U> result;
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 4; ++j) result.rows[i][j] = static_cast<U>(rows[i][j]);
        }
        return result;
    }
    friend constexpr bool operator==(const Affine&, const Affine&) = default;

  private:
    constexpr T row_vector(std::size_t i, Vec3<T> v) const {
        return (rows[i][0] * v.x + rows[i][1] * v.y) + rows[i][2] * v.z;
    }
    constexpr T row_point(std::size_t i, Vec3<T> p) const { return row_vector(i, p) + rows[i][3]; }
    constexpr T column_dot(std::size_t j, Vec3<T> v) const {
        return (rows[0][j] * v.x + rows[1][j] * v.y) + rows[2][j] * v.z;
    }
};

using Affined = Affine<double>;

/// Entry by entry: how a moving thing's world-to-object map runs from one key to the next.
template <typename T>
constexpr Affine<T> lerp(const Affine<T>& a, const Affine<T>& b, T f) {
    Affine<T> result;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            result.rows[i][j] = lerp(a.rows[i][j], b.rows[i][j], f);
        }
    }
    return result;
}

/// a after b.
template <typename T>
constexpr Affine<T> operator*(const Affine<T>& a, const Affine<T>& b) {
    Affine<T> result;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            const T sum = (a.rows[i][0] * b.rows[0][j] + a.rows[i][1] * b.rows[1][j]) +
                          a.rows[i][2] * b.rows[2][j];
            result.rows[i][j] = j == 3 ? sum + a.rows[i][3] : sum;
        }
    }
    return result;
}

}  // namespace cobble::math
