// SPDX-License-Identifier: MIT
#include "renderer/metrics/compare.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/metrics/convolve.hpp"
#include "renderer/metrics/flip.hpp"

namespace cobble::renderer {
namespace {

Plane32 filled(std::uint32_t width, std::uint32_t height, float r, float g, float b) {
    Plane32 plane{width, height, 3, {}};
    for (std::uint32_t i = 0; i < width * height; ++i) {
        plane.values.insert(plane.values.end(), {r, g, b});
    }
    return plane;
}

Plane32 checkers(std::uint32_t size, float dark, float bright) {
    Plane32 plane{size, size, 3, {}};
    for (std::uint32_t i = 0; i < size * size; ++i) {
        const float value = ((i % size) / 3 + (i / size) / 3) % 2 == 0 ? dark : bright;
        plane.values.insert(plane.values.end(), {value, value * 0.9F, value * 0.5F});
    }
    return plane;
}

struct Figures {
    double mse, rel_mse, mae, maximum, percentile_99;
    std::uint64_t differing;
};

/// Means to within rounding, the rest exactly.
void check_figures(const Comparison& c, const Figures& expected) {
    constexpr double kRounding = 1e-6;
    CHECK(std::abs(c.mse - expected.mse) <= kRounding * expected.mse);
    CHECK(std::abs(c.rel_mse - expected.rel_mse) <= kRounding * expected.rel_mse);
    CHECK(std::abs(c.mae - expected.mae) <= kRounding * expected.mae);
    CHECK(c.maximum == expected.maximum);
    CHECK(c.percentile_99 == expected.percentile_99);
    CHECK(c.differing == expected.differing);
}

TEST_CASE("figures of a hand-made pair") {
    // Two pixels: differences 0.5 0 0 and 0 0 -1.
    const Plane32 a{2, 1, 3, {0.5F, 0, 0, 0, 0, 2}};
    const Plane32 b{2, 1, 3, {1, 0, 0, 0, 0, 1}};
    const Comparison c = compare(a, b);
    REQUIRE(c.error.empty());
    check_figures(c, {(0.25 + 1) / 6, (0.25 / 0.26 + 1 / 4.01) / 6, 1.5 / 6, 1, 1, 2});
    CHECK(c.clamped == 1);
    CHECK(c.not_finite == 0);
    CHECK(c.pixels_per_degree == 67);
}

TEST_CASE("99 % of the pixels are not above the percentile") {
    Plane32 a = filled(100, 10, 0, 0, 0);
    Plane32 b = a;
    for (std::size_t i = 0; i < 10; ++i) b.values[i * 3] = 0.5F;
    CHECK(compare(a, b).percentile_99 == 0);
    b.values[10 * 3] = 0.25F;  // the eleventh of 1000
    CHECK(compare(a, b).percentile_99 == 0.25);
}

TEST_CASE("equal pictures differ by nothing") {
    const Plane32 a = checkers(24, 0.1F, 0.8F);
    const Comparison c = compare(a, a);
    check_figures(c, {0, 0, 0, 0, 0, 0});
    CHECK(c.flip == 0);
    CHECK(c.flip_maximum == 0);
}

TEST_CASE("FLIP is symmetric, lies in [0, 1] and grows with the difference") {
    const Plane32 a = checkers(32, 0.2F, 0.7F);
    double last = 0;
    for (const float dark : {0.25F, 0.35F, 0.5F}) {
        const Plane32 b = checkers(32, dark, 0.7F);
        const Comparison forth = compare(a, b);
        CHECK(forth.flip == compare(b, a).flip);
        CHECK(forth.flip > last);
        CHECK(forth.flip_maximum <= 1);
        last = forth.flip;
    }
}

/// The paper's formulas by hand for pictures of one colour, which no filter changes and which have
/// no features.
double spread(double hyab) {
    // CIELab of sRGB green (87.735, -86.183, 83.180) and blue (32.297, 79.188, -107.860), as colour
    // calculators give them; chroma times lightness / 100; |dL| + distance in chroma.
    const double chroma =
        std::hypot(0.87735 * -86.183 - 0.32297 * 79.188, 0.87735 * 83.180 - 0.32297 * -107.860);
    const double largest = std::pow(87.735 - 32.297 + chroma, 0.7);
    const double d = std::pow(hyab, 0.7);
    const double knee = 0.4 * largest;
    return d < knee ? 0.95 / knee * d : 0.95 + (d - knee) / (largest - knee) * 0.05;
}

TEST_CASE("FLIP of flat pictures is the paper's closed form") {
    const Plane32 black = filled(8, 8, 0, 0, 0);
    const Plane32 white = filled(8, 8, 1, 1, 1);
    // Lightness 0 and 100.
    CHECK(compare(black, white).flip == doctest::Approx(spread(100)).epsilon(1e-5));
    // What the authors' own program, in single precision, makes of it.
    CHECK(compare(black, white).flip == doctest::Approx(0.967392).epsilon(2e-5));
    // sRGB 119 has lightness 50.03 (colour calculators).
    const float grey = 119.0F / 255;
    CHECK(compare(black, filled(8, 8, grey, grey, grey)).flip ==
          doctest::Approx(spread(50.034)).epsilon(1e-4));
    // Green and blue are the furthest apart: 1 by definition.
    CHECK(compare(filled(8, 8, 0, 1, 0), filled(8, 8, 0, 0, 1)).flip == doctest::Approx(1));
    // The same light given as light.
    CHECK(compare(filled(4, 4, 0.5F, 0.5F, 0.5F),
                  filled(4, 4, 0.21404114F, 0.21404114F, 0.21404114F), {67, false, true})
              .flip == doctest::Approx(0).epsilon(1e-3));
}

/// A disc of one colour on another, its middle at (x, 16).
Plane32 disc(std::uint32_t size, std::uint32_t x) {
    Plane32 plane{size, size, 3, {}};
    for (std::uint32_t i = 0; i < size * size; ++i) {
        const int dx = static_cast<int>(i % size) - static_cast<int>(x);
        const int dy = static_cast<int>(i / size) - 16;
        if (dx * dx + dy * dy < 81) {
            plane.values.insert(plane.values.end(), {0.875F, 0.25F, 0.125F});
        } else {
            plane.values.insert(plane.values.end(), {0.25F, 0.375F, 0.5F});
        }
    }
    return plane;
}

/// Multiples of 1/255 without a pattern.
Plane32 scrambled(std::uint32_t size, std::uint32_t state) {
    Plane32 plane{size, size, 3, {}};
    for (std::uint32_t i = 0; i < 3 * size * size; ++i) {
        state = state * 1664525U + 1013904223U;
        plane.values.push_back(static_cast<float>(state >> 24U) / 255.0F);
    }
    return plane;
}

/// A line one pixel wide, or none.
Plane32 line(std::uint32_t size, float brightness) {
    Plane32 plane = filled(size, size, 0.5F, 0.5F, 0.5F);
    for (std::uint32_t y = 0; y < size; ++y) {
        for (std::size_t c = 0; c < 3; ++c) plane.values[(y * size + 16) * 3 + c] = brightness;
    }
    return plane;
}

TEST_CASE("FLIP is that of its authors' own program") {
    // What the FLIP.h that the paper's authors publish (version 1.6, LDR, on a processor) makes of
    // these pictures, which are made by rule so that anybody can ask it again: mean, maximum, and
    // the map at (10, 20). It works in single precision and prints six digits.
    struct Published {
        const char* name;
        Plane32 a, b;
        bool light;
        double pixels_per_degree;
        double mean, maximum, at;
    };
    const Plane32 dark = checkers(32, 0.2F, 0.7F);
    const Plane32 bright = checkers(32, 0.35F, 0.7F);
    const Published all[] = {
        {"checkers", dark, bright, false, 67, 0.183926, 0.552801, 0.150362},
        {"checkers", dark, bright, false, 20, 0.338797, 0.582748, 0.113950},
        {"disc", disc(32, 16), disc(32, 17), true, 67, 0.068252, 0.319334, 0.198192},
        {"disc", disc(32, 16), disc(32, 17), true, 20, 0.050030, 0.655858, 0.188346},
        {"scrambled", scrambled(32, 1), scrambled(32, 2), true, 67, 0.393877, 0.945172, 0.339461},
        {"scrambled", scrambled(32, 1), scrambled(32, 2), true, 20, 0.813275, 0.986031, 0.548132},
        {"line", line(32, 0.5F), line(32, 0.75F), true, 67, 0.029632, 0.280153, 0},
        {"line", line(32, 0.5F), line(32, 0.75F), true, 20, 0.020567, 0.544456, 0},
    };
    for (const Published& p : all) {
        CAPTURE(p.name);
        CAPTURE(p.pixels_per_degree);
        const Comparison c = compare(p.a, p.b, {p.pixels_per_degree, p.light, p.light});
        CHECK(c.flip == doctest::Approx(p.mean).epsilon(1e-4));
        CHECK(c.flip_maximum == doctest::Approx(p.maximum).epsilon(1e-4));
        CHECK(static_cast<double>(c.map.at(10, 20, 0)) == doctest::Approx(p.at).epsilon(1e-4));
    }
}

TEST_CASE("pixels beyond a tolerance are counted, and those at it are not") {
    const Plane32 a = filled(4, 1, 0.5F, 0.5F, 0.5F);
    Plane32 b = a;
    b.values[0] = 0.75F;
    b.values[4] = 0.25F;
    b.values[8] = 0.625F;
    const auto beyond = [&](double tolerance) {
        CompareOptions how;
        how.tolerance = tolerance;
        return compare(a, b, how).beyond_tolerance;
    };
    CHECK(compare(a, b).beyond_tolerance == 0);
    CHECK(beyond(0.25) == 0);
    CHECK(beyond(0.2) == 2);
    CHECK(beyond(0.125) == 2);
    CHECK(beyond(0) == 3);
}

TEST_CASE("what the eye cannot resolve counts less") {
    // Fine black and white against its mean in light (display 0.7354): seen from further away (more
    // pixels in a degree) the difference fades.
    Plane32 fine{48, 48, 3, {}};
    for (std::uint32_t i = 0; i < 48 * 48; ++i) {
        const float value = (i % 48 + i / 48) % 2 == 0 ? 0.0F : 1.0F;
        fine.values.insert(fine.values.end(), {value, value, value});
    }
    const Plane32 flat = filled(48, 48, 0.7354F, 0.7354F, 0.7354F);
    const double near = compare(fine, flat, {20, false, false}).flip;
    const double far = compare(fine, flat, {120, false, false}).flip;
    CHECK(near > 0.5);
    CHECK(far < 0.1);
}

TEST_CASE("the map shows where") {
    const Plane32 a = filled(64, 64, 0.5F, 0.5F, 0.5F);
    Plane32 b = a;
    for (std::size_t c = 0; c < 3; ++c) b.values[(32 * 64 + 10) * 3 + c] = 1;
    const Comparison result = compare(a, b);
    CHECK(result.map.channels == 1);
    CHECK(result.map.at(10, 32, 0) == static_cast<float>(result.flip_maximum));
    CHECK(result.map.at(50, 10, 0) == 0);
    CHECK(result.differing == 1);
}

TEST_CASE("large pictures are worked on in tiles, which does not show") {
    // Three tiles by two, of which the left ones are equal; the whole at once is the reference.
    constexpr std::uint32_t kWidth = 530;
    constexpr std::uint32_t kHeight = 270;
    constexpr std::uint32_t kEqual = 280;
    Plane32 a{kWidth, kHeight, 3, {}};
    Plane32 b{kWidth, kHeight, 3, {}};
    LinearImage whole_a{kWidth, kHeight, {}};
    LinearImage whole_b{kWidth, kHeight, {}};
    std::uint32_t state = 1;
    const auto next = [&state] {
        return static_cast<float>((state = state * 69069 + 1) >> 8) * 0x1p-24F;
    };
    for (std::size_t i = 0; i < std::size_t{kWidth} * kHeight; ++i) {
        math::Vec3d pixel;
        for (std::size_t c = 0; c < 3; ++c) {
            a.values.push_back(1.5F * next());
            pixel[c] = std::min(1.0, static_cast<double>(a.values.back()));
        }
        whole_a.pixels.push_back(pixel);
        for (std::size_t c = 0; c < 3; ++c) {
            b.values.push_back(i % kWidth < kEqual ? a.values[3 * i + c] : 1.5F * next());
            pixel[c] = std::min(1.0, static_cast<double>(b.values.back()));
        }
        whole_b.pixels.push_back(pixel);
    }
    const Comparison result = compare(a, b, {67, true, true, 1});
    const std::vector<double> whole = flip(whole_a, whole_b, 67);
    std::uint64_t outside = 0;
    for (const float value : a.values) outside += value > 1 ? 1 : 0;
    for (const float value : b.values) outside += value > 1 ? 1 : 0;
    CHECK(result.clamped == outside);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        differing += result.map.values[i] == static_cast<float>(whole[i]) ? 0 : 1;
    }
    CHECK(differing == 0);
    const Comparison by_three = compare(a, b, {67, true, true, 3});
    CHECK(by_three.flip == result.flip);
    CHECK(by_three.map.values == result.map.values);
}

TEST_CASE("NaN and infinity are counted, not summed") {
    const Plane32 a = filled(2, 2, 0.5F, 0.5F, 0.5F);
    Plane32 b = a;
    b.values[0] = std::numeric_limits<float>::quiet_NaN();
    b.values[5] = std::numeric_limits<float>::infinity();
    const Comparison c = compare(a, b);
    CHECK(c.not_finite == 2);
    CHECK(c.mse == 0);
    CHECK(c.maximum == 0);
    CHECK(c.flip > 0);
    CHECK(c.flip <= 1);
}

TEST_CASE("what cannot be compared says why") {
    const Plane32 a = filled(2, 2, 0, 0, 0);
    CHECK(compare(a, filled(2, 3, 0, 0, 0)).error ==
          "the pictures differ in size: 2 x 2 and 2 x 3");
    CHECK(compare(a, Plane32{}).error == "a picture without pixels cannot be compared");
    CHECK(compare(a, a, {0, false, false}).error ==
          "pixels per degree must lie between 0 and 4000, not 0");
    CHECK_FALSE(compare(a, a, {std::nan(""), false, false}).error.empty());
    const Plane32 grey{2, 2, 1, {0, 0, 0, 0}};
    CHECK(compare(a, grey).mse == 0);
}

TEST_CASE("from so near that a pixel is wider than any feature, there are none to compare") {
    // The weights of the filters for edges and points are then all 0.
    Plane32 a = filled(4, 4, 0.5F, 0.5F, 0.5F);
    Plane32 b = a;
    b.values[5] = 1;
    const auto c = compare(a, b, {0.01, true, false});
    CHECK(c.error.empty());
    CHECK(std::isfinite(c.flip));
    CHECK(c.flip > 0);
}

TEST_CASE("the heat map rises in lightness") {
    Plane32 ramp{101, 1, 1, {}};
    for (int i = 0; i <= 100; ++i) ramp.values.push_back(static_cast<float>(i) / 100);
    const Plane32 colors = heat_map(ramp);
    float last = -1;
    for (std::uint32_t x = 0; x <= 100; ++x) {
        // Rec. 709 weights on display values: enough for an order.
        const float luma = 0.2126F * colors.at(x, 0, 0) + 0.7152F * colors.at(x, 0, 1) +
                           0.0722F * colors.at(x, 0, 2);
        CHECK(luma > last);
        last = luma;
    }
    const Plane32 outside{2, 1, 1, {-1, std::numeric_limits<float>::quiet_NaN()}};
    CHECK(heat_map(outside).at(0, 0, 0) == colors.at(0, 0, 0));
    CHECK(heat_map(outside).at(1, 0, 2) == colors.at(0, 0, 2));
}

TEST_CASE("filters repeat the edge and keep their weights' order") {
    Grid grid(4, 1);
    grid.values = {1, 2, 3, 4};
    const Kernel one{{1}};
    const Kernel shift{{1, 0, 0}};  // takes the left neighbour
    CHECK(convolved(grid, shift, one).values == std::vector<double>{1, 1, 2, 3});
    Grid column(1, 3);
    column.values = {1, 2, 3};
    CHECK(convolved(column, one, shift).values == std::vector<double>{1, 1, 2});
    Kernel slope{{4, 0, -2}};
    slope.balance();
    CHECK(slope.weights == std::vector<double>{1, 0, -1});
}

}  // namespace
}  // namespace cobble::renderer
