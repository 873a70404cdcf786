// SPDX-License-Identifier: MIT
// Pictures around spheres, where their ends meet: row 34 of the hard cases.
#include <doctest/doctest.h>

#include <algorithm>
#include <functional>

#include "renderer/shading/texture.hpp"
#include "tests/hard/scenes.hpp"
#include "tests/support/record.hpp"

namespace cobble::test {

namespace {

/// Grey, from a function of texel centres in [0, 1), rows from the top.
ir::Image grey(std::uint32_t width, std::uint32_t height,
               const std::function<double(double, double)>& value) {
    ir::Image image;
    image.width = width;
    image.height = height;
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const double g = value((x + 0.5) / width, 1 - (y + 0.5) / height);
            image.bytes.insert(image.bytes.end(), 3,
                               static_cast<std::uint8_t>(std::lround(255 * g)));
        }
    }
    return image;
}

/// The point of a unit sphere under a direction.
template <typename T>
renderer::SurfacePoint<T> point_at(const renderer::PreparedScene<T>& scene, Vec3d n) {
    renderer::Counters counters;
    renderer::Ray<T> r;
    r.origin = scene.to_local(n * 3.0);
    r.direction = -n.to<T>();
    const auto hit = closest_hit(scene, r, {}, counters);
    REQUIRE(hit);
    return surface_at(scene, r, hit);
}

template <typename T>
double shade(const ir::Image& image, const renderer::SurfacePoint<T>& s) {
    return renderer::sample_texture(image, ir::TextureFilter::kBilinear,
                                    {double{s.uv.x}, double{s.uv.y}})
        .x;
}

template <typename T>
void check_sphere() {
    SceneMaker make;
    make.sphere({}, 1);
    const auto scene = renderer::prepare<T>(make.scene);
    const ir::Image cosine =
        grey(256, 128, [](double u, double) { return 0.5 + 0.5 * math::cos(2 * math::kPi * u); });
    const ir::Image one = grey(1, 1, [](double, double) { return 0.4; });
    const ir::Image column = grey(1, 64, [](double, double v) { return v; });
    double worst = 0;
    // The seam runs down the side of +z, where u is 0.
    for (double y = -0.99; y < 1; y += 0.03) {
        for (const double off : {0.0, 1e-30, 1e-12, 1e-7, 1e-5}) {
            const double r = std::sqrt(1 - y * y);
            const auto left = point_at(scene, {-off, y, r});
            const auto right = point_at(scene, {off, y, r});
            for (const auto& s : {left, right}) {
                CHECK(s.uv.x >= 0);
                CHECK(s.uv.x <= 1);
                const double from_white = std::fabs(shade(cosine, s) - 1);
                CHECK(from_white <= 5e-3);
                worst = std::max(worst, from_white);
                CHECK(shade(one, s) == 102 / 255.0);
            }
            CHECK(std::fabs(shade(cosine, left) - shade(cosine, right)) <= 5e-3);
            CHECK(std::fabs(shade(column, left) - shade(column, right)) <= 5e-3);
        }
    }
    record(34, "off by " + brief(worst) + " at the seam at most, " + name_of_type<T>());
    // Around each pole; pictures repeat, so that the first and last half of a texel blend with the
    // other end, alike all the way round.
    for (const double side : {1.0, -1.0}) {
        for (const double off : {0.0, 1e-30, 1e-9, 1e-4, 0.05}) {
            double first = -1;
            for (double turn = 0; turn < 6.28; turn += 0.1) {
                const Vec3d n{off * math::sin(turn), side * std::sqrt(1 - off * off),
                              off * math::cos(turn)};
                const auto s = point_at(scene, n);
                CHECK(s.uv.x >= 0);
                CHECK(s.uv.x <= 1);
                CHECK(s.uv.y >= 0);
                CHECK(s.uv.y <= 1);
                CHECK(std::fabs(double{s.uv.y} - (side > 0 ? 1 : 0)) <= off / 3 + 1e-3);
                CHECK(length(s.dp_du) <= 2 * math::kPi * (off + 1e-3));
                CHECK(length(s.dp_dv) <= 4);
                CHECK(shade(one, s) == 102 / 255.0);
                const double g = shade(column, s);
                if (first < 0) first = g;
                CHECK(std::fabs(g - first) <= 5e-3);
            }
        }
    }
}

}  // namespace

TEST_CASE("row 34: a picture around a sphere meets itself at its seam, and the poles are points") {
    check_sphere<float>();
    check_sphere<double>();
}

}  // namespace cobble::test
