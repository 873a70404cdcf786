// SPDX-License-Identifier: MIT
#include "renderer/geometry/triangle.hpp"

namespace cobble::renderer::detail {

double common_scale(const std::array<ShearedPoint<double>, 3>& points) {
    double most = 0;
    for (const auto& p : points) {
        if (std::fabs(p.x) > most) most = std::fabs(p.x);
        if (std::fabs(p.y) > most) most = std::fabs(p.y);
    }
    // To around 1; two steps reach every exponent.
    double scale = 1;
    if (most > 0x1p400) scale = 0x1p-600;
    if (most < 0x1p-300 && most > 0) scale = 0x1p600;
    return scale;
}

namespace {

double near_double(double a) { return a; }
double near_double(math::DoubleDouble a) { return a.hi; }

/// 2^-53; and for double-double more than the error of any of its operations (Joldes, Muller and
/// Popescu, Tight and rigorous error bounds for basic building blocks of double-word arithmetic,
/// 2017: below 10 2^-106).
template <typename T>
constexpr double kWideRounding = sizeof(T) == sizeof(float) ? 0x1p-53 : 0x1p-102;

}  // namespace

template <typename T>
std::optional<TriangleHit<T>> near_edge(const RayShear<T>& ray,
                                        const std::array<math::Vec3<T>, 3>& vertices) {
    using W = Wide<T>;
    const math::Vec3<W> from = widen(ray.origin);
    const W sx = W(ray.direction[ray.kx]) / W(ray.direction[ray.kz]);
    const W sy = W(ray.direction[ray.ky]) / W(ray.direction[ray.kz]);
    std::array<ShearedPoint<T>, 3> rough;
    for (std::size_t i = 0; i < 3; ++i) rough[i] = shear(ray, vertices[i] - ray.origin);
    const W scale(common_scale(rough));
    W x[3];
    W y[3];
    double size = 0;
    double depth = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const math::Vec3<W> p = (widen(vertices[i]) - from) * scale;
        x[i] = p[ray.kx] - sx * p[ray.kz];
        y[i] = p[ray.ky] - sy * p[ray.kz];
        size += std::fabs(near_double(x[i])) + std::fabs(near_double(y[i]));
        depth += std::fabs(near_double(p[ray.kz]));
    }
    std::array<W, 3> weights{x[2] * y[1] - y[2] * x[1], x[0] * y[2] - y[0] * x[2],
                             x[1] * y[0] - y[1] * x[0]};
    double least = 0;
    double most = 0;
    for (const W& weight : weights) {
        const double e = near_double(weight);
        if (e < least) least = e;
        if (e > most) most = e;
    }
    const double error = edge_error(kWideRounding<T>, size, depth);
    // Written so that what is no number is no hit. Exactly one side is sure to have a weight.
    if (!((most > error) != (least < -error))) return std::nullopt;
    const bool positive = most > error;
    W det(0);
    for (W& weight : weights) {
        if (!positive) weight = -weight;
        if (weight < W(0)) weight = W(0);
        det = det + weight;
    }
    return met_at(ray, vertices, weights, det);
}

template std::optional<TriangleHit<float>> near_edge(const RayShear<float>&,
                                                     const std::array<math::Vec3<float>, 3>&);
template std::optional<TriangleHit<double>> near_edge(const RayShear<double>&,
                                                      const std::array<math::Vec3<double>, 3>&);

}  // namespace cobble::renderer::detail
