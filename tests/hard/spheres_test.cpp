// SPDX-License-Identifier: MIT
// Spheres, quadratics and planes: rows 17, 18, 19 and 21 of the hard cases.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "renderer/geometry/sphere.hpp"
#include "tests/hard/cores.hpp"
#include "tests/hard/wrong_shapes.hpp"
#include "tests/oracle/exact.hpp"
#include "tests/support/record.hpp"

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

namespace {

struct Spheres {
    int compared = 0;
    int wrong = 0;  ///< hit or miss told wrongly, farther than 8u of the reach from the outline
    int hits = 0;
    double worst_residual = 0;  ///< distance of the point from the sphere over 8u of the reach
    double worst_t = 0;         ///< error of t, not grazing, over 4 ulp
};

/// One sphere after the other, 1e-3 to 3e5 in size, from 3 to 1e7 radii away, by `kernel`.
template <typename Kernel>
Spheres many_spheres(int count, Kernel kernel) {
    Random random(17);
    Spheres result;
    for (int i = 0; i < count; ++i) {
        const double radius = std::pow(10.0, random.in(-3, 5.5));
        const double distance = radius * std::pow(10.0, random.in(0.5, i % 4 == 0 ? 7.0 : 5.3));
        const auto center = random.point(radius).to<float>();
        const auto r = static_cast<float>(radius);
        FloatRay aimed;
        aimed.origin = (center.to<double>() + random.direction() * distance).to<float>();
        const auto& o = aimed.origin;
        const Vec3d side = cross(normalize((center - o).to<double>()), random.direction());
        const Vec3d target = center.to<double>() + side * (radius * random.in(0, 1.2));
        aimed.direction = normalize(target - o.to<double>()).to<float>();
        const auto& d = aimed.direction;
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
        const auto roots = kernel(aimed, center, r);
        if (std::fabs(away - r) > 8 * 0x1p-24 * reach) {
            ++result.compared;
            result.wrong += roots.has_value() == (discriminant.sign() >= 0) ? 0 : 1;
        }
        if (!roots || discriminant.sign() < 0) continue;
        ++result.hits;
        const Vec3d p = o.to<double>() + d.to<double>() * double{roots->near};
        result.worst_residual =
            std::max(result.worst_residual,
                     std::fabs(length(p - center.to<double>()) - r) / (8 * 0x1p-24 * reach));
        const auto exact_t = (-b.near() - sqrt(discriminant.near())) / a.near();
        const double cosine = dot(normalize(p - center.to<double>()), -d.to<double>());
        if (cosine > 0.1) {
            const double most = std::max(exact_t.hi, reach - radius);
            result.worst_t = std::max(
                result.worst_t, std::fabs((exact_t - math::DoubleDouble(double{roots->near})).hi) /
                                    (4 * 0x1p-23 * most));
        }
    }
    return result;
}

}  // namespace

TEST_CASE("row 17: spheres of all sizes from all distances, against exact arithmetic") {
    const Spheres right = many_spheres(40000, sound_sphere);
    CHECK(right.compared > 36000);
    CHECK(right.wrong == 0);
    CHECK(right.hits > 12000);
    CHECK(right.worst_residual <= 1);
    CHECK(right.worst_t <= 1);
    record(17, counted(right.wrong) + " of " + counted(right.compared) +
                   " wrong; the point off the sphere by " + brief(right.worst_residual) +
                   " of the bound at most, the distance by " + brief(right.worst_t));
    const Spheres plain = many_spheres(4000, plain_sphere);
    CHECK(plain.wrong > 0);
    CHECK(plain.worst_residual > 1);
}

namespace {

/// Spheres of a size and a cluster of them, from far away: at their outlines and at them.
template <typename T>
void check_spheres_by_all_cores(int rays) {
    Random random(171);
    for (const double radius : {1e-3, 1.0, 3e5}) {
        for (const double away : {3.0, 1e3, 1e5}) {
            SceneMaker make;
            for (int i = 0; i < 24; ++i) make.sphere(random.point(radius * 3), radius);
            Questions<T> cores(make.scene);
            const auto& scene = cores.reference;
            const Vec3d eye = random.direction() * (radius * (away + 6));
            for (int i = 0; i < rays; ++i) {
                const auto& key = make.scene.spheres[random.below(24)].keys[0];
                const Vec3d side = normalize(cross(key.center - eye, random.direction()));
                const double f = i % 2 == 0 ? 1 + std::ldexp(random.in(-1, 1),
                                                             -static_cast<int>(random.below(30)))
                                            : random.in(0, 1.2);
                renderer::Ray<T> r;
                r.origin = scene.to_local(eye);
                r.direction = scene.to_local(key.center + side * (radius * f)) - r.origin;
                cores.ask(r);
            }
            CHECK(cores.differences() == "");
        }
    }
}

}  // namespace

TEST_CASE("rows 17 and 18: every core gives one answer to rays at spheres and their outlines") {
    check_spheres_by_all_cores<float>(300);
    check_spheres_by_all_cores<double>(60);
}

namespace {

/// Tangents of the unit sphere around zero by the thousand: points that are off it.
template <typename Cast>
int tangents_off(int count, Cast cast) {
    SceneMaker make;
    make.sphere({0, 0, 0}, 1);
    Questions<float> cores(make.scene);
    Random random(18);
    int bad = 0;
    for (int i = 0; i < count; ++i) {
        const Vec3d n = random.direction();
        const Vec3d along = normalize(cross(n, random.direction()));
        const auto r = ray<float>(n - along * random.in(0, 100), along);
        if (i % 8 == 0) cores.ask(r);
        const renderer::Hit<float> hit = cast(cores.reference, r);
        if (!hit) continue;
        const Vec3d p = r.origin.to<double>() + r.direction.to<double>() * double{hit.t};
        const double reach = length(r.origin.to<double>()) + 1;
        if (!(std::fabs(length(p) - 1) <= 8 * 0x1p-24 * reach)) ++bad;
    }
    CHECK(cores.differences() == "");
    return bad;
}

}  // namespace

TEST_CASE("row 18: a table of what a sphere answers") {
    SceneMaker make;
    make.sphere({0, 0, 0}, 1);
    Questions<float> f(make.scene);
    Questions<double> d(make.scene);
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
    for (const Row& row : rows) {
        const auto a = f.ask(ray<float>(row.origin, row.direction));
        const auto b = d.ask(ray<double>(row.origin, row.direction));
        CAPTURE(row.origin.x);
        CAPTURE(row.origin.z);
        CAPTURE(row.direction.z);
        CHECK((a ? double{a.t} : 0.0) == row.t);
        CHECK((b ? b.t : 0.0) == row.t);
    }
    CHECK(f.differences() == "");
    CHECK(d.differences() == "");
    // No NaN, and the residual is small whenever a tangent hits.
    CHECK(tangents_off(20000, kByTree) == 0);
    record(18, "12 of 12 rows as they are due; 0 of 20,000 tangents off the sphere");
    Kernels plain;
    plain.sphere = plain_sphere;
    CHECK(tangents_off(2000, plain) > 0);
}

namespace {

struct Quadratics {
    int compared = 0;
    int wrong = 0;
    int close = 0;  ///< pairs that are almost one root
};

/// One equation: whether it has roots, and each root's error in steps of T.
template <typename T, typename Solve>
void check_quadratic(T a, T b, T c, int ulps, Solve solve, Quadratics& result) {
    const std::optional<renderer::Roots<T>> roots = solve(a, b, c);
    using oracle::Exact;
    const Exact discriminant = Exact(b) * Exact(b) - Exact(4) * Exact(a) * Exact(c);
    if (a != 0 && roots.has_value() != (discriminant.sign() >= 0)) ++result.wrong;
    if (!roots) return;
    ++result.compared;
    if (!(roots->near <= roots->far)) ++result.wrong;
    if (a == 0) {
        const auto root = -math::DoubleDouble(double{c}) / double{b};
        if (!(steps_off(roots->near, root) <= ulps)) ++result.wrong;
        return;
    }
    if (discriminant.sign() < 0) return;
    // The discriminant is exact, its root good to 2^-100, and nothing cancels after that.
    const auto root = sqrt(discriminant.near());
    const math::DoubleDouble wide_b(double{b});
    const auto q = (b < 0 ? wide_b - root : wide_b + root) * math::DoubleDouble(-0.5);
    auto near = q / math::DoubleDouble(double{a});
    auto far = q.hi != 0 ? math::DoubleDouble(double{c}) / q : math::DoubleDouble(0);
    if (far < near) std::swap(near, far);
    if (!(steps_off(roots->near, near) <= ulps)) ++result.wrong;
    if (!(steps_off(roots->far, far) <= ulps)) ++result.wrong;
    if (far.hi - near.hi <= std::fabs(far.hi) * 0x1p-6) ++result.close;
}

template <typename T, typename Solve>
Quadratics quadratics(int count, int ulps, Solve solve) {
    Random random(19);
    Quadratics result;
    for (int i = 0; i < count; ++i) {
        double a = random.in(-1, 1);
        double b = random.in(-2, 2);
        double c = random.in(-1, 1);
        if (i % 6 == 1) b *= 1e6;   // b^2 far above 4 a c
        if (i % 6 == 2) a *= 1e-6;  // almost a line
        if (i % 6 == 3) c = 0;
        if (i % 6 == 4) c = b * b / (4 * a) * (1 - random.unit() * 1e-5);
        check_quadratic(static_cast<T>(a), static_cast<T>(b), static_cast<T>(c), ulps, solve,
                        result);
    }
    return result;
}

}  // namespace

TEST_CASE("row 19: quadratics, against roots of the exact discriminant") {
    const auto in_float = [](float a, float b, float c) {
        return renderer::solve_quadratic(a, b, c);
    };
    const auto in_double = [](double a, double b, double c) {
        return renderer::solve_quadratic(a, b, c);
    };
    Quadratics f = quadratics<float>(40000, 1, in_float);
    Quadratics d = quadratics<double>(10000, 2, in_double);
    check_quadratic(1.0F, -2.0F, 1.0F, 1, in_float, f);
    check_quadratic(1.0, -2.0, 1.0, 2, in_double, d);
    check_quadratic(0.0F, 2.0F, -1.0F, 1, in_float, f);
    CHECK(!renderer::solve_quadratic(0.0F, 0.0F, 1.0F));
    CHECK(!renderer::solve_quadratic(1.0F, 0.0F, 1.0F));
    CHECK(f.compared + d.compared > 25000);
    CHECK(f.close + d.close > 1000);
    CHECK(f.wrong == 0);
    CHECK(d.wrong == 0);
    record(19, counted(f.wrong) + " of " + counted(f.compared) + " beyond 1 ulp in float, " +
                   counted(d.wrong) + " of " + counted(d.compared) + " beyond 2 in double");
    CHECK(quadratics<float>(2000, 1, plain_quadratic).wrong > 500);
}

namespace {

struct Scanline {
    int steps = 0;
    int wrong = 0;  ///< no hit, one that is no farther than the last, one off the plane
    float last = 0;
};

/// From 1 above a plane, down the picture's middle up to where it is 1e8 away.
template <typename Cast>
Scanline to_the_horizon(Questions<float>& cores, Cast cast) {
    const auto& scene = cores.reference;
    Scanline result;
    for (double slope = 1; slope > 1e-8; slope *= 0.99) {
        const auto r = ray<float>({0, 1, 0}, normalize(Vec3d{0.3, -slope, -1}));
        cores.ask(r);
        const renderer::Hit<float> hit = cast(scene, r);
        ++result.steps;
        if (!hit || !(hit.t > result.last)) {
            ++result.wrong;
            continue;
        }
        result.last = hit.t;
        const auto s = surface_at(scene, r, hit);
        if (s.position.y != 0 || !(std::fabs(s.uv.x) <= 2 * hit.t)) ++result.wrong;
    }
    return result;
}

}  // namespace

TEST_CASE("row 21: a plane's t grows along the scanline up to the horizon at 1e8") {
    SceneMaker make;
    make.plane({0, 1, 0}, 0);
    Questions<float> cores(make.scene);
    const Scanline right = to_the_horizon(cores, kByTree);
    CHECK(right.steps > 1500);
    CHECK(right.wrong == 0);
    CHECK(right.last > 9e7F);
    record(21, counted(right.wrong) + " of " + counted(right.steps) + " steps wrong, up to " +
                   brief(double{right.last}));
    // Along it, in it, away from it.
    CHECK(!cores.ask(ray<float>({0, 1, 0}, {1, 0, 0})));
    CHECK(!cores.ask(ray<float>({0, 0, 0}, {1, 0, 0})));
    CHECK(!cores.ask(ray<float>({0, 0, 0}, {0, -1, 0})));
    CHECK(!cores.ask(ray<float>({0, 1, 0}, {0, 1, 0})));
    CHECK(cores.ask(ray<float>({0, -1e-30, 0}, {1, 1e-7, 0})));
    CHECK(cores.differences() == "");
    Kernels wrong;
    wrong.plane = parallel_epsilon;
    CHECK(to_the_horizon(cores, wrong).wrong > 100);
}

}  // namespace cobble::test
