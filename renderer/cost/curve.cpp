// SPDX-License-Identifier: MIT
#include "renderer/cost/curve.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "ir/math/elementary.hpp"
#include "ir/math/srgb.hpp"
#include "renderer/estimate/jackknife.hpp"

namespace cobble::renderer {
namespace {

/// Least squares of log(error) over log(samples); not measured if fewer than two points have an
/// error.
double slope_of(const std::vector<Scatters>& points,
                const std::function<double(const Scatters&)>& mean_square) {
    const std::size_t first = points.size() > 6 ? points.size() / 2 : points.size() > 3 ? 1 : 0;
    double n = 0, x_sum = 0, y_sum = 0, xx = 0, xy = 0;
    for (std::size_t i = first; i < points.size(); ++i) {
        const double square = mean_square(points[i]);
        if (!(square > 0)) continue;
        const double x = math::log(points[i].samples);
        const double y = math::log(square) / 2;
        n += 1;
        x_sum += x;
        y_sum += y;
        xx += x * x;
        xy += x * y;
    }
    const double spread = n * xx - x_sum * x_sum;
    return n < 2 || !(spread > 0) ? kNotMeasured : (n * xy - x_sum * y_sum) / spread;
}

}  // namespace

Scatters scatter_of(const ScrambleSums& sums, std::uint32_t samples, double seconds, bool light) {
    const std::uint32_t scrambles = sums.scrambles();
    Scatters result;
    result.samples = samples;
    result.seconds = seconds;
    result.left_out.assign(scrambles, 0);
    const double n = scrambles;
    std::vector<math::Vec3d> means(scrambles);
    for (std::size_t i = 0; i < sums.pixels(); ++i) {
        math::Vec3d sum;
        for (std::uint32_t k = 0; k < scrambles; ++k) {
            means[k] = sums.mean_of(i, k);
            for (std::size_t c = 0; light && c < 3; ++c) {
                means[k][c] = math::linear_to_srgb(std::clamp(means[k][c], 0.0, 1.0));
            }
            sum += means[k];
        }
        const math::Vec3d mean = sum / n;
        double squares = 0;
        for (std::uint32_t k = 0; k < scrambles; ++k) {
            squares += math::dot(means[k] - mean, means[k] - mean);
        }
        result.mean_square += squares / (n - 1);
        for (std::uint32_t k = 0; k < scrambles; ++k) {
            // Leaving one out takes its square away, and the mean moves.
            const math::Vec3d off = means[k] - mean;
            result.left_out[k] += (squares - math::dot(off, off) * (n / (n - 1))) / (n - 2);
        }
    }
    const double values = 3 * static_cast<double>(std::max<std::size_t>(sums.pixels(), 1));
    result.mean_square /= values;
    for (double& one : result.left_out) one = std::max(one / values, 0.0);
    return result;
}

ErrorCurve make_curve(const std::vector<Scatters>& points) {
    ErrorCurve curve;
    if (points.empty()) return curve;
    curve.replicates = static_cast<std::uint32_t>(points.front().left_out.size());
    for (const Scatters& point : points) {
        CurvePoint& to = curve.points.emplace_back();
        to.samples = point.samples;
        to.seconds = point.seconds;
        to.error = std::sqrt(point.mean_square);
        if (!(point.mean_square > 0)) {
            to.band = {0, 0};
            continue;
        }
        // In logarithms, where it is more nearly symmetrical and stays above 0.
        std::vector<double> logs;
        for (const double one : point.left_out) {
            logs.push_back(math::log(std::max(one, point.mean_square * 1e-6)) / 2);
        }
        const double reach = jackknife_reach(logs);
        to.band = {to.error * math::exp(-reach), to.error * math::exp(reach)};
    }
    if (points.size() < 3) return curve;
    curve.slope = slope_of(points, [](const Scatters& point) { return point.mean_square; });
    std::vector<double> slopes;
    for (std::uint32_t k = 0; k < curve.replicates; ++k) {
        slopes.push_back(
            slope_of(points, [k](const Scatters& point) { return point.left_out[k]; }));
    }
    const double reach = jackknife_reach(slopes);
    curve.slope_band = {curve.slope - reach, curve.slope + reach};
    return curve;
}

}  // namespace cobble::renderer
