// SPDX-License-Identifier: MIT
#include "renderer/compat/texture.hpp"

#include <cmath>

#include "renderer/shading/texture.hpp"

namespace cobble::renderer {
namespace {

/// Where a coordinate lies between two texels of a row (or column) of `size`.
struct Between {
    std::uint32_t first = 0, second = 0;
    double fraction = 0;
};

Between between(double position, std::uint32_t size) {
    const double last = size - 1.0;
    // Written so that NaN ends at 0.
    if (!(position > 0)) return {};
    if (position >= last) return {size - 1, size - 1, 0};
    const double floor = std::floor(position);
    const auto first = static_cast<std::uint32_t>(floor);
    return {first, first + 1, position - floor};
}

struct FacePoint {
    ir::CubeMap::Face face = ir::CubeMap::kFront;
    double u = 0.5, v = 0.5;
};

/// The face across the largest component (x before y before z), and the place on it.
FacePoint face_point(math::Vec3d d) {
    const double x = std::fabs(d.x);
    const double y = std::fabs(d.y);
    const double z = std::fabs(d.z);
    // Each quotient a is in [-1, 1]; to [0, 1], or the other way round.
    const auto up = [](double a) { return (a + 1) / 2; };
    const auto down = [](double a) { return 1 - (a + 1) / 2; };
    if (x >= y && x >= z && x > 0) {
        return d.x > 0 ? FacePoint{ir::CubeMap::kRight, up(d.z / d.x), up(d.y / d.x)}
                       : FacePoint{ir::CubeMap::kLeft, up(d.z / d.x), down(d.y / d.x)};
    }
    if (y >= z && y > 0) {
        return d.y > 0 ? FacePoint{ir::CubeMap::kUp, up(d.x / d.y), up(d.z / d.y)}
                       : FacePoint{ir::CubeMap::kDown, down(d.x / d.y), down(d.z / d.y)};
    }
    if (!(z > 0)) return {};
    return d.z > 0 ? FacePoint{ir::CubeMap::kFront, down(d.x / d.z), up(d.y / d.z)}
                   : FacePoint{ir::CubeMap::kBack, up(d.x / d.z), down(d.y / d.z)};
}

}  // namespace

ir::Color compat_texture(const ir::Image& image, math::Vec2d uv, bool nearest) {
    if (image.missing || image.width == 0 || image.height == 0) {
        return std::isfinite(uv.x) && std::isfinite(uv.y) ? error_checker(uv) : kErrorColor;
    }
    const Between x = between(uv.x * image.width, image.width);
    const Between y = between((1 - uv.y) * image.height, image.height);
    if (nearest) return texel(image, x.first, y.first);
    const ir::Color above =
        math::lerp(texel(image, x.first, y.first), texel(image, x.second, y.first), x.fraction);
    const ir::Color below =
        math::lerp(texel(image, x.first, y.second), texel(image, x.second, y.second), x.fraction);
    return math::lerp(above, below, y.fraction);
}

ir::Color compat_cube_map(const ir::Scene& scene, const ir::CubeMap& map, math::Vec3d direction) {
    const FacePoint point = face_point(direction);
    const ir::ImageId face = map.faces[point.face];
    if (!face.valid()) return kErrorColor;
    return compat_texture(scene.images[face.value], {point.u, point.v}, false);
}

}  // namespace cobble::renderer
