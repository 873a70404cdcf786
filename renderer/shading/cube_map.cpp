// SPDX-License-Identifier: MIT
#include "renderer/shading/cube_map.hpp"

#include <algorithm>
#include <cmath>

#include "renderer/shading/texture.hpp"

namespace cobble::renderer {
namespace {

/// How a face lies on the cube: which axis it is across and on which side, and the axis and sign
/// that u and v follow.
struct FaceFrame {
    std::size_t axis;
    int side;
    std::size_t u_axis;
    int u_sign;
    std::size_t v_axis;
    int v_sign;
};

/// In the order of ir::CubeMap::Face.
constexpr std::array<FaceFrame, 6> kFrames = {{
    {0, -1, 2, -1, 1, 1},   // left
    {0, +1, 2, +1, 1, 1},   // right
    {1, +1, 0, +1, 2, 1},   // up
    {1, -1, 0, +1, 2, -1},  // down
    {2, +1, 0, -1, 1, 1},   // front
    {2, -1, 0, +1, 1, 1},   // back
}};

std::size_t face_across(std::size_t axis, bool positive) {
    constexpr std::array<std::array<std::size_t, 2>, 3> kFaces = {
        {{ir::CubeMap::kLeft, ir::CubeMap::kRight},
         {ir::CubeMap::kDown, ir::CubeMap::kUp},
         {ir::CubeMap::kBack, ir::CubeMap::kFront}}};
    return kFaces[axis][positive ? 1 : 0];
}

/// One cube map under one filter.
class Faces {
  public:
    Faces(const ir::Scene& scene, const ir::CubeMap& map) : scene_(&scene), map_(&map) {
        size_ = static_cast<std::int64_t>(image(0).width);
    }

    [[nodiscard]] std::int64_t size() const { return size_; }

    /// Texel (column, row) of a face, row from the bottom; each may be one beyond the face's ends.
    [[nodiscard]] ir::Color at(std::size_t face, std::int64_t column, std::int64_t row) const {
        const bool beyond_u = column < 0 || column >= size_;
        const bool beyond_v = row < 0 || row >= size_;
        if (beyond_u && beyond_v) {
            const std::int64_t inner_column = std::clamp<std::int64_t>(column, 0, size_ - 1);
            const std::int64_t inner_row = std::clamp<std::int64_t>(row, 0, size_ - 1);
            // Summed by face, not by who asks: the three faces agree to the last bit.
            const std::array<Place, 3> places = {Place{face, inner_column, inner_row},
                                                 across(face, column, inner_row),
                                                 across(face, inner_column, row)};
            std::array<ir::Color, 6> colors{};
            for (const Place& place : places) colors[place.face] = fetch(place);
            ir::Color sum;
            for (const ir::Color& color : colors) sum += color;
            return sum / 3.0;
        }
        return fetch(beyond_u || beyond_v ? across(face, column, row) : Place{face, column, row});
    }

  private:
    struct Place {
        std::size_t face;
        std::int64_t column, row;
    };

    [[nodiscard]] const ir::Image& image(std::size_t face) const {
        return scene_->images[map_->faces[face].value];
    }

    [[nodiscard]] ir::Color fetch(const Place& place) const {
        return texel(image(place.face), static_cast<std::uint32_t>(place.column),
                     static_cast<std::uint32_t>(size_ - 1 - place.row));
    }

    /// The texel next to an edge on its other side. Texel centres lie on an integer lattice in
    /// which faces are at +-size and centres at odd distances 2 i + 1 - size from the middle; one
    /// step over an edge, the coordinate that went beyond becomes the side and the old side, less
    /// one, the coordinate.
    [[nodiscard]] Place across(std::size_t face, std::int64_t column, std::int64_t row) const {
        const FaceFrame& from = kFrames[face];
        std::array<std::int64_t, 3> at{};
        at[from.axis] = from.side * (size_ - 1);
        at[from.u_axis] = from.u_sign * (2 * column + 1 - size_);
        at[from.v_axis] = from.v_sign * (2 * row + 1 - size_);
        const bool beyond_u = column < 0 || column >= size_;
        const std::size_t axis = beyond_u ? from.u_axis : from.v_axis;
        const std::size_t next = face_across(axis, at[axis] > 0);
        const FaceFrame& to = kFrames[next];
        return {next, (to.u_sign * at[to.u_axis] + size_ - 1) / 2,
                (to.v_sign * at[to.v_axis] + size_ - 1) / 2};
    }

    const ir::Scene* scene_;
    const ir::CubeMap* map_;
    std::int64_t size_;
};

bool complete(const ir::Scene& scene, const ir::CubeMap& map) {
    for (const ir::ImageId id : map.faces) {
        if (!id.valid()) return false;
        const ir::Image& image = scene.images[id.value];
        const ir::Image& first = scene.images[map.faces[0].value];
        if (image.missing || image.width == 0 || image.width != image.height ||
            image.width != first.width) {
            return false;
        }
    }
    return true;
}

}  // namespace

CubePoint cube_point(math::Vec3d direction) {
    const double x = std::fabs(direction.x);
    const double y = std::fabs(direction.y);
    const double z = std::fabs(direction.z);
    const std::size_t axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    const double largest = axis == 0 ? x : axis == 1 ? y : z;
    if (!(largest > 0) || !std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) return {};
    const std::size_t face = face_across(axis, direction[axis] > 0);
    const FaceFrame& frame = kFrames[face];
    const auto place = [&](std::size_t along, int sign) {
        return (1 + sign * (direction[along] / largest)) / 2;
    };
    return {static_cast<ir::CubeMap::Face>(face), place(frame.u_axis, frame.u_sign),
            place(frame.v_axis, frame.v_sign)};
}

ir::Color sample_cube_map(const ir::Scene& scene, const ir::CubeMap& map, ir::TextureFilter filter,
                          math::Vec3d direction) {
    if (!complete(scene, map)) return kErrorColor;
    const CubePoint point = cube_point(direction);
    const Faces faces(scene, map);
    const auto size = static_cast<double>(faces.size());
    if (filter == ir::TextureFilter::kNearest) {
        const auto place = [&](double coordinate) {
            return std::min(static_cast<std::int64_t>(coordinate * size), faces.size() - 1);
        };
        return faces.at(point.face, place(point.u), place(point.v));
    }
    const double x = point.u * size - 0.5;
    const double y = point.v * size - 0.5;
    const double column_floor = std::floor(x);
    const double row_floor = std::floor(y);
    const auto column = static_cast<std::int64_t>(column_floor);
    const auto row = static_cast<std::int64_t>(row_floor);
    const ir::Color low = math::lerp(faces.at(point.face, column, row),
                                     faces.at(point.face, column + 1, row), x - column_floor);
    const ir::Color high = math::lerp(faces.at(point.face, column, row + 1),
                                      faces.at(point.face, column + 1, row + 1), x - column_floor);
    return math::lerp(low, high, y - row_floor);
}

}  // namespace cobble::renderer
