// SPDX-License-Identifier: MIT
#include "renderer/shading/cube_map.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/shading/texture.hpp"
#include "tests/support/record.hpp"

using namespace cobble;
using ir::Color;
using ir::CubeMap;
using ir::TextureFilter;
using math::Vec3d;

namespace {

/// Six faces of numbers that have nothing to do with each other.
ir::Scene scrambled(std::uint32_t size) {
    ir::Scene scene;
    std::uint32_t state = 12345;
    CubeMap map;
    for (std::uint32_t face = 0; face < 6; ++face) {
        ir::Image image;
        image.width = image.height = size;
        for (std::uint32_t i = 0; i < 3 * size * size; ++i) {
            state = state * 1664525U + 1013904223U;
            image.bytes.push_back(static_cast<std::uint8_t>(state >> 24U));
        }
        map.faces[face] = ir::ImageId{face};
        scene.images.push_back(std::move(image));
    }
    scene.cube_maps.push_back(map);
    return scene;
}

Color sample(const ir::Scene& scene, Vec3d direction,
             TextureFilter filter = TextureFilter::kBilinear) {
    return renderer::sample_cube_map(scene, scene.cube_maps[0], filter, direction);
}

double difference(Color a, Color b) {
    return std::max({std::fabs(a.x - b.x), std::fabs(a.y - b.y), std::fabs(a.z - b.z)});
}

/// The way from the middle of the cube [-1, 1]^3 to a place on it, by the faces' own axes.
Vec3d direction_of(const renderer::CubePoint& point) {
    const double u = 2 * point.u - 1;
    const double v = 2 * point.v - 1;
    switch (point.face) {
        case CubeMap::kLeft:
            return {-1, v, -u};
        case CubeMap::kRight:
            return {1, v, u};
        case CubeMap::kUp:
            return {u, 1, v};
        case CubeMap::kDown:
            return {u, -1, -v};
        case CubeMap::kFront:
            return {-u, v, 1};
        case CubeMap::kBack:
            return {u, v, -1};
    }
    return {};
}

}  // namespace

TEST_CASE("axes meet the middles of the faces that the language names") {
    const auto face = [](Vec3d d) { return renderer::cube_point(d).face; };
    CHECK(face({2, 0, 0}) == CubeMap::kRight);
    CHECK(face({-2, 0, 0}) == CubeMap::kLeft);
    CHECK(face({0, 2, 0}) == CubeMap::kUp);
    CHECK(face({0, -2, 0}) == CubeMap::kDown);
    CHECK(face({0, 0, 2}) == CubeMap::kFront);
    CHECK(face({0, 0, -2}) == CubeMap::kBack);
    // Ties: x before y before z.
    CHECK(face({1, 1, 1}) == CubeMap::kRight);
    CHECK(face({-1, 1, -1}) == CubeMap::kLeft);
    CHECK(face({0, -1, 1}) == CubeMap::kDown);

    // The usual camera looks along -z: right is right and up is up on the face called back.
    const renderer::CubePoint back = renderer::cube_point({0.5, 0.25, -1});
    CHECK(back.u == 0.75);
    CHECK(back.v == 0.625);
    const renderer::CubePoint front = renderer::cube_point({0.5, 0.25, 1});
    CHECK(front.u == 0.25);
    CHECK(front.v == 0.625);
    const renderer::CubePoint right = renderer::cube_point({1, 0.5, 0.25});
    CHECK(right.u == 0.625);
    CHECK(right.v == 0.75);
    const renderer::CubePoint left = renderer::cube_point({-1, 0.5, 0.25});
    CHECK(left.u == 0.375);
    CHECK(left.v == 0.75);
    const renderer::CubePoint up = renderer::cube_point({0.5, 1, 0.25});
    CHECK(up.u == 0.75);
    CHECK(up.v == 0.625);
    const renderer::CubePoint down = renderer::cube_point({0.5, -1, 0.25});
    CHECK(down.u == 0.75);
    CHECK(down.v == 0.375);
}

TEST_CASE("a place on a face leads back to its direction") {
    std::uint32_t state = 7;
    const auto next = [&] {
        state = state * 1664525U + 1013904223U;
        return state / 2147483648.0 - 1;
    };
    for (int i = 0; i < 1000; ++i) {
        Vec3d d{next(), next(), next()};
        const Vec3d back = direction_of(renderer::cube_point(d));
        d = d / std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
        CHECK(math::length(back - d) < 1e-14);
    }
}

TEST_CASE("row 33: colours are continuous over all twelve edges, from both sides") {
    double worst = 0;
    for (const std::uint32_t size : {1U, 2U, 5U, 16U}) {
        const ir::Scene scene = scrambled(size);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (int signs = 0; signs < 4; ++signs) {
                const std::size_t a = (axis + 1) % 3;
                const std::size_t b = (axis + 2) % 3;
                // Along the edge, corners included; -0 among the places.
                for (int i = -64; i <= 64; ++i) {
                    Vec3d edge;
                    edge[axis] = i == 0 ? -0.0 : i / 64.0;
                    edge[a] = (signs & 1) != 0 ? 1 : -1;
                    edge[b] = (signs & 2) != 0 ? 1 : -1;
                    const double step = 1e-6;
                    Vec3d one = edge;
                    one[a] *= 1 - step;
                    Vec3d other = edge;
                    other[b] *= 1 - step;
                    // Slope of the filter: at most 1 a texel, size / 2 texels a unit, three axes.
                    const double slope = 3 * size * step;
                    CHECK(difference(sample(scene, one), sample(scene, other)) <= slope);
                    CHECK(difference(sample(scene, one), sample(scene, edge)) <= slope);
                    worst = std::max(worst,
                                     difference(sample(scene, one), sample(scene, other)) / slope);
                }
            }
        }
    }
    test::record(33, "steps over an edge of " + test::brief(worst) + " of the bound at most");
}

TEST_CASE("row 33: neighbours over an edge are the texels that touch there") {
    // Nearest colours on both sides of an edge, a quarter of a texel away from it, are the two
    // that bilinear mixes half and half on it.
    const std::uint32_t size = 8;
    const ir::Scene scene = scrambled(size);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (int signs = 0; signs < 4; ++signs) {
            for (std::uint32_t i = 0; i < size; ++i) {
                const std::size_t a = (axis + 1) % 3;
                const std::size_t b = (axis + 2) % 3;
                Vec3d edge;
                edge[axis] = (2.0 * i + 1) / size - 1;
                edge[a] = (signs & 1) != 0 ? 1 : -1;
                edge[b] = (signs & 2) != 0 ? 1 : -1;
                Vec3d one = edge;
                one[a] *= 0.99;
                Vec3d other = edge;
                other[b] *= 0.99;
                const Color mean = (sample(scene, one, TextureFilter::kNearest) +
                                    sample(scene, other, TextureFilter::kNearest)) /
                                   2.0;
                CHECK(difference(sample(scene, edge), mean) < 1e-12);
            }
        }
    }
}

TEST_CASE("row 33: directions that are none are safe") {
    const ir::Scene scene = scrambled(4);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const Vec3d d : {Vec3d{0, 0, 0}, Vec3d{-0.0, 0, -0.0}, Vec3d{nan, 1, 0},
                          Vec3d{infinity, 1, 0}, Vec3d{5e-324, 0, 0}, Vec3d{1e308, 1e308, 1e308}}) {
        const Color color = sample(scene, d);
        CHECK(std::isfinite(color.x));
        CHECK(color.x >= 0);
        CHECK(color.x <= 1);
    }
}

TEST_CASE("a face that is missing, or of another size, shows as an error") {
    ir::Scene scene = scrambled(4);
    scene.images[3].missing = true;
    CHECK(sample(scene, {0, 0, 1}) == renderer::kErrorColor);
    scene = scrambled(4);
    scene.images[2].width = 2;
    CHECK(sample(scene, {0, 0, 1}) == renderer::kErrorColor);
}
