// SPDX-License-Identifier: MIT
#include "renderer/cost/noise.hpp"

#include <algorithm>

#include "renderer/estimate/jackknife.hpp"

namespace cobble::renderer {
namespace {

using Values = std::vector<double>;

/// What one pair of sets of seeds, A and B, adds to the sums that indices are made of.
struct PairSums {
    double variance = 0;         ///< (a - b)^2 / 2
    std::vector<double> alone;   ///< by source i: (b - c)^2 / 2 with c all of A but i of B
    std::vector<double> in_all;  ///< by source i: (a - c)^2 / 2
};

double half_mean_square(const Values& a, const Values& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum / (2 * static_cast<double>(std::max<std::size_t>(a.size(), 1)));
}

/// Over all pairs but one (none if `without` is not a pair).
double mean_without(const std::vector<PairSums>& pairs, std::size_t without,
                    const std::function<double(const PairSums&)>& of) {
    double sum = 0;
    double count = 0;
    for (std::size_t j = 0; j < pairs.size(); ++j) {
        if (j == without) continue;
        sum += of(pairs[j]);
        count += 1;
    }
    return sum / count;
}

/// A figure over all pairs, and its interval.
struct Figure {
    double value = 0;
    Interval band;
};

template <typename Of>
Figure figure(const std::vector<PairSums>& pairs, const Of& of) {
    Figure result;
    result.value = of(pairs.size());
    std::vector<double> left_out;
    for (std::size_t j = 0; j < pairs.size(); ++j) left_out.push_back(of(j));
    const double reach = jackknife_reach(left_out);
    result.band = {result.value - reach, result.value + reach};
    return result;
}

}  // namespace

NoiseBill measure_noise(const std::vector<std::string>& sources, std::uint32_t pairs,
                        const Estimator& estimator) {
    std::vector<PairSums> sums;
    for (std::uint32_t j = 0; j < pairs; ++j) {
        const std::vector<std::uint16_t> first(sources.size(),
                                               static_cast<std::uint16_t>(2 * j + 1));
        const std::vector<std::uint16_t> second(sources.size(),
                                                static_cast<std::uint16_t>(2 * j + 2));
        Values a;
        Values b;
        if (!estimator(first, a) || !estimator(second, b)) return {};
        PairSums& pair = sums.emplace_back();
        pair.variance = half_mean_square(a, b);
        for (std::size_t i = 0; i < sources.size(); ++i) {
            std::vector<std::uint16_t> mixed = first;
            mixed[i] = second[i];
            Values c;
            if (!estimator(mixed, c)) return {};
            pair.alone.push_back(half_mean_square(b, c));
            pair.in_all.push_back(half_mean_square(a, c));
        }
    }
    const auto variance = [&](std::size_t without) {
        return mean_without(sums, without, [](const PairSums& pair) { return pair.variance; });
    };
    if (!(variance(sums.size()) > 0)) return {};
    // What changing all but one source leaves of the variance is that source's alone.
    const auto first_order = [&](std::size_t i, std::size_t without) {
        const double rest =
            mean_without(sums, without, [i](const PairSums& pair) { return pair.alone[i]; });
        return 1 - rest / variance(without);
    };
    NoiseBill bill;
    bill.seeds = pairs;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        NoiseShare& share = bill.shares.emplace_back();
        share.name = sources[i];
        const Figure first =
            figure(sums, [&](std::size_t without) { return first_order(i, without); });
        const Figure total = figure(sums, [&](std::size_t without) {
            return mean_without(sums, without,
                                [i](const PairSums& pair) { return pair.in_all[i]; }) /
                   variance(without);
        });
        share.first = first.value;
        share.first_band = first.band;
        share.total = total.value;
        share.total_band = total.band;
    }
    const Figure together = figure(sums, [&](std::size_t without) {
        double rest = 1;
        for (std::size_t i = 0; i < sources.size(); ++i) rest -= first_order(i, without);
        return rest;
    });
    bill.together = together.value;
    bill.together_band = together.band;
    return bill;
}

}  // namespace cobble::renderer
