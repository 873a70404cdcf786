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

}  // namespace cobble::bench
