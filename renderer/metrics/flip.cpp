// SPDX-License-Identifier: MIT
#include "renderer/metrics/flip.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "ir/math/elementary.hpp"
#include "ir/math/power_of_two.hpp"
#include "renderer/metrics/convolve.hpp"

namespace cobble::renderer {
namespace {

using math::Vec3d;

// --- Colour spaces (section 4.1) ---

/// CIE XYZ of linear RGB: exact for the chromaticities of sRGB's primaries and of D65.
Vec3d xyz_of(Vec3d c) {
    return {(10135552.0 * c.x + 8788810.0 * c.y + 4435075.0 * c.z) / 24577794,
            (2613072.0 * c.x + 8788810.0 * c.y + 887015.0 * c.z) / 12288897,
            (1425312.0 * c.x + 8788810.0 * c.y + 70074185.0 * c.z) / 73733382};
}

/// XYZ relative to white, so that white is 1 1 1.
Vec3d relative_xyz_of(Vec3d c) {
    const Vec3d white = xyz_of({1, 1, 1});
    const Vec3d xyz = xyz_of(c);
    return {xyz.x / white.x, xyz.y / white.y, xyz.z / white.z};
}

/// The inverse of relative_xyz_of, by Cramer's rule on its columns.
class FromRelativeXyz {
  public:
    FromRelativeXyz() {
        const Vec3d r = relative_xyz_of({1, 0, 0});
        const Vec3d g = relative_xyz_of({0, 1, 0});
        const Vec3d b = relative_xyz_of({0, 0, 1});
        const double determinant = math::dot(r, math::cross(g, b));
        rows_ = {math::cross(g, b) / determinant, math::cross(b, r) / determinant,
                 math::cross(r, g) / determinant};
    }
    Vec3d operator()(Vec3d xyz) const {
        return {math::dot(rows_[0], xyz), math::dot(rows_[1], xyz), math::dot(rows_[2], xyz)};
    }

  private:
    std::array<Vec3d, 3> rows_;
};

/// CIELab without its cube root: an achromatic, a red-green and a blue-yellow component.
Vec3d opponent_of(Vec3d color) {
    const Vec3d t = relative_xyz_of(color);
    return {116 * t.y - 16, 500 * (t.x - t.y), 200 * (t.y - t.z)};
}

Vec3d relative_xyz_of_opponent(Vec3d o) {
    const double y = (o.x + 16) / 116;
    return {y + o.y / 500, y, y - o.z / 200};
}

/// Of a number in (0.008, 2), to a few units in the last place; a power takes several times as
/// long. Halley's iteration triples the digits that are right: from 5 % three steps are plenty.
double cube_root(double x) {
    // A third of the exponent, as if the bits were a logarithm, and what keeps 1 near 1: (1023 -
    // 1023 / 3 - 0.033) 2^52, as in FreeBSD's cbrt.
    constexpr std::uint64_t kThirds = 0x2a9f789300000000;
    double y = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) / 3 + kThirds);
    for (int i = 0; i < 3; ++i) {
        const double cube = y * y * y;
        y = y * ((cube + 2 * x) / (2 * cube + x));
    }
    return y;
}

/// x^y for normal x > 0 and |y log2 x| < 1000, to some 1e-14 of the result: a map is not looked at
/// more closely, and math::pow, right to the last bits, takes ten times as long.
double power(double x, double y) {
    // x = 2^k m, m in [sqrt(1/2), sqrt(2)); log m = 2 atanh(s) with s = (m - 1) / (m + 1), of at
    // most 0.172, whose series is cut where its terms fall below 2^-53.
    constexpr std::uint64_t kRootHalf = 0x3fe6a09e667f3bcd;
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const auto k = static_cast<std::int64_t>(bits - kRootHalf) >> 52;
    const double m = std::bit_cast<double>(bits - (static_cast<std::uint64_t>(k) << 52U));
    const double s = (m - 1) / (m + 1);
    const double s2 = s * s;
    double atanh = 0;
    for (int n = 21; n >= 1; n -= 2) atanh = atanh * s2 + 1.0 / n;
    constexpr double kInverseLog2 = 1.4426950408889634;
    const double exponent = y * (static_cast<double>(k) + 2 * kInverseLog2 * s * atanh);
    // 2^exponent = 2^n e^f, |f| at most log(2) / 2.
    const double n = std::floor(exponent + 0.5);
    const double f = (exponent - n) / kInverseLog2;
    double e = 1;
    for (int i = 13; i >= 1; --i) e = 1 + f * (1.0 / i) * e;
    return e * math::power_of_two(static_cast<int>(n));
}

double lab_root(double t) {
    constexpr double kDelta = 6.0 / 29;
    return t > kDelta * kDelta * kDelta ? cube_root(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
}

/// CIELab whose chroma shrinks with lightness (the Hunt effect, section 4.1.2).
Vec3d hunt_lab_of(Vec3d color) {
    const Vec3d t = relative_xyz_of(color);
    const Vec3d f{lab_root(t.x), lab_root(t.y), lab_root(t.z)};
    const double lightness = 116 * f.y - 16;
    const double scale = 0.01 * lightness;
    return {lightness, scale * 500 * (f.x - f.y), scale * 200 * (f.y - f.z)};
}

/// City-block in lightness, Euclidean in chroma.
double hyab(Vec3d a, Vec3d b) {
    const Vec3d d = a - b;
    return std::fabs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

// --- The colour pipeline (section 4.1) ---

/// A contrast sensitivity function as a sum of two Gaussians a sqrt(pi / b) exp(-pi^2 x^2 / b), x
/// in degrees: the paper's table 1.
struct Sensitivity {
    double a1, b1, a2, b2;
};
constexpr std::array<Sensitivity, 3> kSensitivities{{
    {1, 0.0047, 0, 1e-5},       // achromatic
    {1, 0.0053, 0, 1e-5},       // red-green
    {34.1, 0.04, 13.5, 0.025},  // blue-yellow
}};
constexpr double kWidest = 0.04;  // the largest b of the table

/// The exponent of the colour difference, and where the two straight pieces that spread it over
/// [0, 1] meet: kPt at kPc of the largest difference (section 4.1.3).
constexpr double kQc = 0.7;
constexpr double kPc = 0.4;
constexpr double kPt = 0.95;

std::size_t sensitivity_radius(double pixels_per_degree) {
    const double deviation = std::sqrt(kWidest / (2 * math::kPi * math::kPi));
    return static_cast<std::size_t>(std::ceil(3 * deviation * pixels_per_degree));
}

/// One component of an image, blurred as the eye blurs it.
Grid seen(const Grid& grid, const Sensitivity& sensitivity, double pixels_per_degree) {
    constexpr double kPi2 = math::kPi * math::kPi;
    const std::size_t radius = sensitivity_radius(pixels_per_degree);
    // A Gaussian of two variables is the product of two of one; so is its sum over the square.
    const auto kernel_of = [&](double b) {
        return sampled_kernel(radius, [&](double x) {
            const double degrees = x / pixels_per_degree;
            return math::exp(-kPi2 * degrees * degrees / b);
        });
    };
    const auto weigh = [](const Kernel& kernel, double a, double b) {
        const double sum = kernel.sum();
        return a * std::sqrt(math::kPi / b) * sum * sum;
    };
    Kernel first = kernel_of(sensitivity.b1);
    const double weight1 = weigh(first, sensitivity.a1, sensitivity.b1);
    first.scale(1 / first.sum());
    Grid result = convolved(grid, first, first);
    if (sensitivity.a2 == 0) return result;

    Kernel second = kernel_of(sensitivity.b2);
    const double weight2 = weigh(second, sensitivity.a2, sensitivity.b2);
    second.scale(1 / second.sum());
    const Grid other = convolved(grid, second, second);
    for (std::size_t i = 0; i < result.values.size(); ++i) {
        result.values[i] =
            (weight1 * result.values[i] + weight2 * other.values[i]) / (weight1 + weight2);
    }
    return result;
}

/// Pixels as the eye sees them, in the Hunt-adjusted CIELab.
std::vector<Vec3d> seen_colors(const LinearImage& image, double pixels_per_degree) {
    std::array<Grid, 3> planes;
    for (Grid& plane : planes) plane = Grid(image.width, image.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const Vec3d opponent = opponent_of(image.pixels[i]);
        for (std::size_t c = 0; c < 3; ++c) planes[c].values[i] = opponent[c];
    }
    for (std::size_t c = 0; c < 3; ++c) {
        planes[c] = seen(planes[c], kSensitivities[c], pixels_per_degree);
    }
    const FromRelativeXyz rgb_of;
    std::vector<Vec3d> result(image.pixels.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        Vec3d rgb = rgb_of(relative_xyz_of_opponent(
            {planes[0].values[i], planes[1].values[i], planes[2].values[i]}));
        for (std::size_t c = 0; c < 3; ++c) rgb[c] = std::clamp(rgb[c], 0.0, 1.0);
        result[i] = hunt_lab_of(rgb);
    }
    return result;
}

/// A colour difference in [0, 1].
double redistributed(double difference, double largest) {
    const double knee = kPc * largest;
    if (difference < knee) return kPt / knee * difference;
    return kPt + (difference - knee) / (largest - knee) * (1 - kPt);
}

// --- The feature pipeline (section 4.2) ---

/// Width in degrees of the lines and points that the eye looks for.
constexpr double kFeatureWidth = 0.082;

double feature_deviation(double pixels_per_degree) {
    return 0.5 * kFeatureWidth * pixels_per_degree;
}

std::size_t feature_radius(double pixels_per_degree) {
    return static_cast<std::size_t>(std::ceil(3 * feature_deviation(pixels_per_degree)));
}

struct Features {
    Grid edges, points;
};

Grid magnitude(const Grid& x, const Grid& y) {
    Grid result(x.width, x.height);
    for (std::size_t i = 0; i < result.values.size(); ++i) {
        result.values[i] = std::sqrt(x.values[i] * x.values[i] + y.values[i] * y.values[i]);
    }
    return result;
}

Features features_of(const LinearImage& image, double pixels_per_degree) {
    Grid grey(image.width, image.height);
    for (std::size_t i = 0; i < grey.values.size(); ++i) {
        grey.values[i] = (opponent_of(image.pixels[i]).x + 16) / 116;
    }
    const double deviation = feature_deviation(pixels_per_degree);
    const double variance = deviation * deviation;
    const std::size_t radius = feature_radius(pixels_per_degree);
    const auto gauss = [variance](double x) { return math::exp(-x * x / (2 * variance)); };
    Kernel blur = sampled_kernel(radius, gauss);
    blur.scale(1 / blur.sum());
    // First and second derivatives of the Gaussian, their positive weights scaled to the sum 1, the
    // negative ones to -1. The other direction's Gaussian is a common factor of both.
    Kernel edge = sampled_kernel(radius, [&](double x) { return -x * gauss(x); });
    Kernel point =
        sampled_kernel(radius, [&](double x) { return (x * x / variance - 1) * gauss(x); });
    edge.balance();
    point.balance();
    const Grid blurred = convolved_rows(grey, blur);
    return {magnitude(convolved(grey, edge, blur), convolved_columns(blurred, edge)),
            magnitude(convolved(grey, point, blur), convolved_columns(blurred, point))};
}

}  // namespace

std::size_t flip_reach(double pixels_per_degree) {
    return std::max(sensitivity_radius(pixels_per_degree), feature_radius(pixels_per_degree));
}

std::vector<double> flip(const LinearImage& reference, const LinearImage& test,
                         double pixels_per_degree) {
    const std::vector<Vec3d> colors_a = seen_colors(reference, pixels_per_degree);
    const std::vector<Vec3d> colors_b = seen_colors(test, pixels_per_degree);
    const Features features_a = features_of(reference, pixels_per_degree);
    const Features features_b = features_of(test, pixels_per_degree);
    // Pure green and pure blue lie furthest apart.
    const double largest = power(hyab(hunt_lab_of({0, 1, 0}), hunt_lab_of({0, 0, 1})), kQc);

    std::vector<double> result(colors_a.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        const double distance = hyab(colors_a[i], colors_b[i]);
        if (!(distance > 0)) continue;
        const double color = redistributed(power(distance, kQc), largest);
        const double edges = std::fabs(features_a.edges.values[i] - features_b.edges.values[i]);
        const double points = std::fabs(features_a.points.values[i] - features_b.points.values[i]);
        // The exponent of their difference is a half.
        const double feature = std::sqrt(std::max(edges, points) / std::sqrt(2.0));
        // Section 4.3: features strengthen a colour difference; alone they are none.
        result[i] = std::clamp(power(color, 1 - feature), 0.0, 1.0);
    }
    return result;
}

}  // namespace cobble::renderer
