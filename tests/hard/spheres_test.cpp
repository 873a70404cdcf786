// SPDX-License-Identifier: MIT
// Spheres, quadratics and planes: rows 17, 18, 19 and 21 of the hard cases.
#include <doctest/doctest.h>

#include <limits>
#include <utility>

#include "renderer/geometry/sphere.hpp"
#include "tests/hard/scenes.hpp"
#include "tests/oracle/exact.hpp"

namespace cobble::test {

namespace {

/// By how many steps of T `x` is off the double-double `exact`.
template <typename T>
double steps_off(T x, math::DoubleDouble exact) {
    const T size = std::fabs(static_cast<T>(exact.hi));
    const T step = std::nextafter(size, std::numeric_limits<T>::infinity()) - size;
    return std::fabs((math::DoubleDouble(double{x}) - exact).hi) / double{step};
}

}  // namespace

TEST_CASE("row 17: spheres of all sizes from all distances, against exact arithmetic") {
    Random random(17);
    int compared = 0;
    int hits = 0;
    double worst_residual = 0;
    double worst_t = 0;
    for (int i = 0; i < 100000; ++i) {
        const double radius = std::pow(10.0, random.in(-3, 5.5));
        const double distance = radius * std::pow(10.0, random.in(0.5, i % 4 == 0 ? 7.0 : 5.3));
        const auto center = random.point(radius).to<float>();
        const auto r = static_cast<float>(radius);
        const auto o = (center.to<double>() + random.direction() * distance).to<float>();
        const Vec3d side = cross(normalize((center - o).to<double>()), random.direction());
        const Vec3d target = center.to<double>() + side * (radius * random.in(0, 1.2));
        const auto d = normalize(target - o.to<double>()).to<float>();
        // The discriminant, (f . d)^2 - d . d (f . f - r^2), exactly.
        using oracle::Exact;
        const auto f =
            oracle::minus(oracle::exact(o.to<double>()), oracle::exact(center.to<double>()));
        const auto e = oracle::exact(d.to<double>());
        const Exact b = oracle::exact_dot(f, e);
        const Exact a = oracle::exact_dot(e, e);
        const Exact c = oracle::exact_dot(f, f) - Exact(r) * Exact(r);
        const Exact discriminant = b * b - a * c;
        const double reach = length(o.to<double>() - center.to<double>()) + radius;
        // Distance of the line from the centre: r^2 - disc / a = distance^2.
        const double away =
            std::sqrt(std::max(0.0, radius * radius - (discriminant.near() / a.near()).hi));
        const auto roots = renderer::intersect_sphere(o, d, center, r);
        if (std::fabs(away - r) > 8 * 0x1p-24 * reach) {
            ++compared;
            CHECK(roots.has_value() == (discriminant.sign() >= 0));
        }
        if (!roots || discriminant.sign() < 0) continue;
        ++hits;
        const Vec3d p = o.to<double>() + d.to<double>() * double{roots->near};
        worst_residual = std::max(
            worst_residual, std::fabs(length(p - center.to<double>()) - r) / (8 * 0x1p-24 * reach));
        const auto exact_t = (-b.near() - sqrt(discriminant.near())) / a.near();
        const double cosine = dot(normalize(p - center.to<double>()), -d.to<double>());
        if (cosine > 0.1) {
            const double most = std::max(exact_t.hi, reach - radius);
            worst_t = std::max(worst_t,
                               std::fabs((exact_t - math::DoubleDouble(double{roots->near})).hi) /
                                   (4 * 0x1p-23 * most));
        }
    }
    CHECK(compared > 90000);
    CHECK(hits > 30000);
    CHECK(worst_residual <= 1);
    CHECK(worst_t <= 1);
}

TEST_CASE("row 18: a table of what a sphere answers") {
    SceneMaker make;
    make.sphere({0, 0, 0}, 1);
    const auto f = renderer::prepare<float>(make.scene);
    const auto d = renderer::prepare<double>(make.scene);
    struct Row {
        Vec3d origin, direction;
        double t;  ///< 0: no hit
    };
    const Row rows[] = {
        {{0, 0, 5}, {0, 0, -1}, 4},      {{0, 0, 5}, {0, 0, 1}, 0},
        {{0, 0, 0}, {0, 0, -1}, 1},      {{0, 0, 0.5}, {0, 0, 1}, 0.5},
        {{0, 0, 1}, {0, 0, -1}, 2},      {{0, 0, 1}, {0, 0, 1}, 0},
        {{1, 0, 5}, {0, 0, -1}, 5},      {{0, 1, 5}, {0, 0, -2}, 2.5},
        {{1.0001, 0, 5}, {0, 0, -1}, 0}, {{0, 0, 5}, {0, 0, -0.5}, 8},
        {{0, 0, 1}, {0, 1, 0}, 0},       {{-1, 0, 0}, {1, 0, 0}, 2},
    };
    renderer::Counters counters;
    for (const Row& row : rows) {
        const auto a = closest_hit(f, ray<float>(row.origin, row.direction), {}, counters);
        const auto b = closest_hit(d, ray<double>(row.origin, row.direction), {}, counters);
        CAPTURE(row.origin.x);
        CAPTURE(row.origin.z);
        CAPTURE(row.direction.z);
        CHECK((a ? double{a.t} : 0.0) == row.t);
        CHECK((b ? b.t : 0.0) == row.t);
    }
    // Tangent lines by the thousand: no NaN, and the residual is small whenever one hits.
    Random random(18);
    int bad = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3d n = random.direction();
        const Vec3d along = normalize(cross(n, random.direction()));
        const auto r = ray<float>(n - along * random.in(0, 100), along);
        const auto hit = closest_hit(f, r, {}, counters);
        if (!hit) continue;
        const Vec3d p = r.origin.to<double>() + r.direction.to<double>() * double{hit.t};
        const double reach = length(r.origin.to<double>()) + 1;
        if (!(std::fabs(length(p) - 1) <= 8 * 0x1p-24 * reach)) ++bad;
    }
    CHECK(bad == 0);
}

TEST_CASE("row 19: quadratics, against roots of the exact discriminant") {
    Random random(19);
    int compared = 0;
    int wrong = 0;
    int close = 0;  ///< pairs that are almost one root
    const auto check = [&](auto a, auto b, auto c, int ulps) {
        const auto roots = renderer::solve_quadratic(a, b, c);
        using oracle::Exact;
        const int sign = (Exact(b) * Exact(b) - Exact(4) * Exact(a) * Exact(c)).sign();
        if (a != 0 && roots.has_value() != (sign >= 0)) ++wrong;
        if (!roots) return;
        ++compared;
        if (!(roots->near <= roots->far)) ++wrong;
        if (a == 0) {
            if (steps_off(roots->near, -math::DoubleDouble(double{c}) / double{b}) > ulps) ++wrong;
            return;
        }
        // The discriminant is exact, its root good to 2^-100, and nothing cancels after that.
        const auto root = sqrt((Exact(b) * Exact(b) - Exact(4) * Exact(a) * Exact(c)).near());
        const math::DoubleDouble wide_b(double{b});
        const auto q = (b < 0 ? wide_b - root : wide_b + root) * math::DoubleDouble(-0.5);
        auto near = q / math::DoubleDouble(double{a});
        auto far = q.hi != 0 ? math::DoubleDouble(double{c}) / q : math::DoubleDouble(0);
        if (far < near) std::swap(near, far);
        if (!(steps_off(roots->near, near) <= ulps)) ++wrong;
        if (!(steps_off(roots->far, far) <= ulps)) ++wrong;
        if (far.hi - near.hi <= std::fabs(far.hi) * 0x1p-6) ++close;
    };
    for (int i = 0; i < 40000; ++i) {
        double a = random.in(-1, 1);
        double b = random.in(-2, 2);
        double c = random.in(-1, 1);
        if (i % 6 == 1) b *= 1e6;   // b^2 far above 4 a c
        if (i % 6 == 2) a *= 1e-6;  // almost a line
        if (i % 6 == 3) c = 0;
        if (i % 6 == 4) c = b * b / (4 * a) * (1 - random.unit() * 1e-5);
        check(static_cast<float>(a), static_cast<float>(b), static_cast<float>(c), 1);
        if (i % 4 == 0) check(a, b, c, 2);
    }
    check(1.0F, -2.0F, 1.0F, 1);
    check(1.0, -2.0, 1.0, 2);
    check(0.0F, 2.0F, -1.0F, 1);
    CHECK(!renderer::solve_quadratic(0.0F, 0.0F, 1.0F));
    CHECK(!renderer::solve_quadratic(1.0F, 0.0F, 1.0F));
    CHECK(compared > 25000);
    CHECK(close > 1000);
    CHECK(wrong == 0);
}

TEST_CASE("row 21: a plane's t grows along the scanline up to the horizon at 1e8") {
    SceneMaker make;
    make.plane({0, 1, 0}, 0);
    const auto scene = renderer::prepare<float>(make.scene);
    renderer::Counters counters;
    float last = 0;
    int steps = 0;
    for (double slope = 1; slope > 1e-8; slope *= 0.99) {
        const auto r = ray<float>({0, 1, 0}, normalize(Vec3d{0.3, -slope, -1}));
        const auto hit = closest_hit(scene, r, {}, counters);
        REQUIRE(hit);
        CHECK(hit.t > last);
        last = hit.t;
        ++steps;
        const auto s = surface_at(scene, r, hit);
        CHECK(s.position.y == 0);
        CHECK(std::fabs(s.uv.x) <= 2 * hit.t);
    }
    CHECK(steps > 1500);
    CHECK(last > 9e7F);
    // Along it, in it, away from it.
    CHECK(!closest_hit(scene, ray<float>({0, 1, 0}, {1, 0, 0}), {}, counters));
    CHECK(!closest_hit(scene, ray<float>({0, 0, 0}, {1, 0, 0}), {}, counters));
    CHECK(!closest_hit(scene, ray<float>({0, 0, 0}, {0, -1, 0}), {}, counters));
    CHECK(!closest_hit(scene, ray<float>({0, 1, 0}, {0, 1, 0}), {}, counters));
    CHECK(closest_hit(scene, ray<float>({0, -1e-30, 0}, {1, 1e-7, 0}), {}, counters));
}

}  // namespace cobble::test
