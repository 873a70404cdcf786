// SPDX-License-Identifier: MIT
// Small vectors. Sums of three are (x + y) + z everywhere, so that a result has one value.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace cobble::math {

template <typename T>
struct Vec2 {
    T x{}, y{};
    friend constexpr bool operator==(const Vec2&, const Vec2&) = default;
};

/// Points, directions, normals and colours (r, g, b as x, y, z).
template <typename T>
struct Vec3 {
    T x{}, y{}, z{};

    constexpr T& operator[](std::size_t i) { return i == 0 ? x : i == 1 ? y : z; }
    constexpr const T& operator[](std::size_t i) const { return i == 0 ? x : i == 1 ? y : z; }

    template <typename U>
    [[nodiscard]] constexpr Vec3<U> to() const {
        return {static_cast<U>(x), static_cast<U>(y), static_cast<U>(z)};
    }

    friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
    friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
    friend constexpr Vec3 operator*(Vec3 a, T s) { return {a.x * s, a.y * s, a.z * s}; }
    friend constexpr Vec3 operator*(T s, Vec3 a) { return a * s; }
    friend constexpr Vec3 operator*(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
    friend constexpr Vec3 operator/(Vec3 a, T s) { return {a.x / s, a.y / s, a.z / s}; }
    constexpr Vec3& operator+=(Vec3 b) { return *this = *this + b; }
    constexpr Vec3& operator-=(Vec3 b) { return *this = *this - b; }
    constexpr Vec3& operator*=(T s) { return *this = *this * s; }
};

using Vec2d = Vec2<double>;
using Vec3d = Vec3<double>;
using Vec3f = Vec3<float>;

constexpr Vec3d vec(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

/// No component is NaN or infinite.
template <typename T>
bool finite(Vec3<T> a) {
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

template <typename T>
constexpr T dot(Vec3<T> a, Vec3<T> b) {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

template <typename T>
constexpr Vec3<T> cross(Vec3<T> a, Vec3<T> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Square root is the one function of the C library in use: IEEE 754 defines its every bit.
template <typename T>
T length(Vec3<T> a) {
    return std::sqrt(dot(a, a));
}

/// A zero vector stays zero (0 / 1), so that no NaN is born here.
template <typename T>
Vec3<T> normalize(Vec3<T> a) {
    const T l = length(a);
    return a / (l > T(0) ? l : T(1));
}

/// `a + f (b - a)`: gives a's bits at f = 0.
template <typename T>
constexpr T lerp(T a, T b, T f) {
    return a + f * (b - a);
}

template <typename T>
constexpr Vec3<T> lerp(Vec3<T> a, Vec3<T> b, T f) {
    return {lerp(a.x, b.x, f), lerp(a.y, b.y, f), lerp(a.z, b.z, f)};
}

}  // namespace cobble::math
