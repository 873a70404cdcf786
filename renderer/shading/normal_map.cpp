// SPDX-License-Identifier: MIT
#include "renderer/shading/normal_map.hpp"

#include <algorithm>
#include <cmath>

#include "renderer/shading/frame.hpp"
#include "renderer/shading/texture.hpp"

namespace cobble::renderer {
namespace {

/// T along u, B toward v, N: perpendicular, unit.
Frame<double> tangent_frame(math::Vec3d normal, math::Vec3d dp_du, math::Vec3d dp_dv) {
    // Scaled first, so that the length of a tangent (a texture over a kilometre, or over an atom)
    // does not matter to the test below.
    const math::Vec3d along = math::normalize(dp_du);
    const math::Vec3d flat = along - math::dot(along, normal) * normal;
    // The sine of the angle between tangent and normal; below this the rest is mostly rounding of
    // a float tangent (2^-24 / 1e-4 is an angle of 0.03 degrees).
    constexpr double kLeastSine = 1e-4;
    if (!(math::length(flat) > kLeastSine)) return frame_around(normal);
    const math::Vec3d x = math::normalize(flat);
    const math::Vec3d y = math::cross(normal, x);
    const bool mirrored = math::dot(y, dp_dv) < 0;
    return {x, mirrored ? -y : y, normal};
}

}  // namespace

math::Vec3d mapped_normal(const ir::Image& image, ir::TextureFilter filter, math::Vec2d uv) {
    const math::Vec3d raw = sample_data(image, filter, uv);
    const auto component = [](double c) { return std::clamp((c - 128) / 127, -1.0, 1.0); };
    return {component(raw.x), component(raw.y), component(raw.z)};
}

math::Vec2d bump_slope(const ir::Image& image, ir::TextureFilter filter, math::Vec2d uv) {
    if (image.missing || image.width == 0 || image.height == 0) return {};
    constexpr double kHeight = 0.05;  // the language's: white stands this part of a repeat out
    const double du = 1.0 / image.width;
    const double dv = 1.0 / image.height;
    const auto height = [&](double u, double v) {
        return sample_data(image, filter, {u, v}).x / 255;
    };
    const double right = height(uv.x + du, uv.y);
    const double left = height(uv.x - du, uv.y);
    const double upper = height(uv.x, uv.y + dv);
    const double lower = height(uv.x, uv.y - dv);
    return {kHeight * (right - left) / (2 * du), kHeight * (upper - lower) / (2 * dv)};
}

template <typename T>
math::Vec3<T> bend_normal(math::Vec3<T> normal, math::Vec3<T> dp_du, math::Vec3<T> dp_dv,
                          math::Vec3d tangent_space) {
    if (tangent_space.x == 0 && tangent_space.y == 0 && tangent_space.z > 0) return normal;
    const auto n = normal.template to<double>();
    const Frame<double> frame =
        tangent_frame(n, dp_du.template to<double>(), dp_dv.template to<double>());
    const math::Vec3d bent = frame.to_world(tangent_space);
    // A map may store a zero normal; there is nothing to bend toward.
    if (!(math::dot(bent, bent) > 0)) return normal;
    return math::normalize(bent).template to<T>();
}

template math::Vec3<float> bend_normal(math::Vec3<float>, math::Vec3<float>, math::Vec3<float>,
                                       math::Vec3d);
template math::Vec3<double> bend_normal(math::Vec3<double>, math::Vec3<double>, math::Vec3<double>,
                                        math::Vec3d);

}  // namespace cobble::renderer
