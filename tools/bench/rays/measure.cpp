// SPDX-License-Identifier: MIT
#include "tools/bench/rays/measure.hpp"

#include <algorithm>
#include <thread>

#include "tools/bench/clock.hpp"

namespace cobble::bench {

namespace {

/// Whole packets of 16, and some milliseconds at most.
constexpr std::size_t kStretch = 4096;

std::uint64_t trace_every(const Contestant& contestant, std::size_t rays, unsigned which) {
    std::uint64_t hits = 0;
    for (std::size_t begin = which * kStretch; begin < rays;
         begin += contestant.threads * kStretch) {
        hits += contestant.trace(begin, std::min(begin + kStretch, rays));
    }
    return hits;
}

void run_pass(const Contestant& contestant, std::size_t rays, Timing& timing) {
    if (contestant.before) contestant.before();
    std::vector<std::uint64_t> hits(contestant.threads, 0);
    std::vector<std::thread> others;
    const Stopwatch watch;
    for (unsigned i = 1; i < contestant.threads; ++i) {
        others.emplace_back([&, i] { hits[i] = trace_every(contestant, rays, i); });
    }
    hits[0] = trace_every(contestant, rays, 0);
    for (std::thread& other : others) other.join();
    if (contestant.threads == 1) timing.cpu.push_back(watch.thread_seconds());
    timing.wall.push_back(watch.wall_seconds());
    timing.hits = 0;
    for (const std::uint64_t n : hits) timing.hits += n;
}

}  // namespace

std::vector<Timing> measure(const std::vector<Contestant>& contestants, std::size_t rays,
                            Effort effort) {
    std::vector<Timing> timings(contestants.size());
    for (const Contestant& contestant : contestants) {
        Timing warming;
        run_pass(contestant, rays, warming);
    }
    const Stopwatch watch;
    const double seconds = effort.seconds * static_cast<double>(contestants.size());
    for (std::size_t pass = 0; pass < effort.passes || watch.wall_seconds() < seconds; ++pass) {
        for (std::size_t i = 0; i < contestants.size(); ++i) {
            run_pass(contestants[i], rays, timings[i]);
        }
    }
    return timings;
}

double quantile(std::vector<double> values, double part) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const double at = part * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    const double f = at - static_cast<double>(below);
    return values[below] + f * (values[above] - values[below]);
}

double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

double speed_ratio(const std::vector<double>& seconds, const std::vector<double>& other) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(seconds.size(), other.size()); ++i) {
        ratios.push_back(other[i] / seconds[i]);
    }
    return median(std::move(ratios));
}

}  // namespace cobble::bench
