// SPDX-License-Identifier: MIT
#include "renderer/geometry/sphere.hpp"

namespace cobble::renderer {

template <typename T>
std::optional<Roots<T>> solve_quadratic(T a, T b, T c) {
    using W = Wide<T>;
    if (a == 0) {
        if (b == 0) return std::nullopt;
        const T root = -c / b;
        return Roots<T>{root, root};
    }
    // b^2 - 4 a c: products exact in W, the difference right to W's last bits, its sign exact.
    const W wide_b(b);
    const W discriminant = wide_b * wide_b - W(4) * W(a) * W(c);
    if (!(discriminant >= W(0))) return std::nullopt;
    const W root = wide_sqrt(discriminant);
    const W q = W(-0.5) * (b < 0 ? wide_b - root : wide_b + root);
    const T first = static_cast<T>(q / W(a));
    const T second = q > W(0) || q < W(0) ? static_cast<T>(W(c) / q) : T(0);
    return first < second ? Roots<T>{first, second} : Roots<T>{second, first};
}

template std::optional<Roots<float>> solve_quadratic(float, float, float);
template std::optional<Roots<double>> solve_quadratic(double, double, double);

}  // namespace cobble::renderer
