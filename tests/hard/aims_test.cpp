// SPDX-License-Identifier: MIT
// Rays that go for the weak places of scenes: no core loses one of those that cannot miss.
#include <doctest/doctest.h>

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "renderer/intersect/batch.hpp"
#include "renderer/intersect/instruction_set.hpp"
#include "tests/hard/aims.hpp"
#include "tests/hard/cores.hpp"
#include "tests/hard/wrong_shapes.hpp"
#include "tests/support/record.hpp"

namespace cobble::test {

namespace {

template <typename T>
void check_aims(std::size_t rays) {
    std::map<int, std::int64_t> asked;
    for (const Aim& aim : aims()) {
        CAPTURE(aim.name);
        Questions<T> cores(aim.scene);
        Random random(1);
        int lost = 0;
        aim_rays(aim, rays, rays / 2, random, [&](const AimedRay& aimed) {
            const auto r = local_ray(cores.reference, aimed);
            if (!cores.ask(r) && aim.closed) ++lost;
        });
        CHECK(lost == 0);
        CHECK(cores.differences() == "");
        asked[aim.row] += static_cast<std::int64_t>(rays);
    }
    for (const auto& [row, count] : asked) {
        record(row, counted(count) + " aimed rays alike by all cores, " + name_of_type<T>());
    }
}

/// The share of the rays of bundles that the fast core searches in packets.
double in_packets(const Aim& aim, std::size_t count) {
    renderer::PrepareOptions options;
    options.acceleration = renderer::Acceleration::kFast;
    const auto scene = renderer::prepare<float>(aim.scene, options);
    std::vector<renderer::Ray<float>> rays;
    Random random(1);
    aim_rays(aim, count, count, random,
             [&](const AimedRay& aimed) { rays.push_back(local_ray(scene, aimed)); });
    const std::vector<renderer::Exclude> excludes(count);
    std::vector<renderer::Hit<float>> hits(count);
    renderer::Counters counters;
    closest_hits(scene, std::span<const renderer::Ray<float>>(rays),
                 std::span<const renderer::Exclude>(excludes), std::span(hits), counters,
                 renderer::Coherence::kCoherent);
    return static_cast<double>(counters.packet_rays) / static_cast<double>(count);
}

}  // namespace

TEST_CASE("bundles of aimed rays form packets, but where rays go along an axis") {
    const std::string fastest = renderer::instruction_sets().front();
    if (fastest == "scalar") return;  // one lane: there are no packets
    double sum = 0;
    for (const Aim& aim : aims()) {
        CAPTURE(aim.name);
        const double share = in_packets(aim, 20 * kBundle);
        // A ray along an axis is searched alone.
        if (aim.row != 4) CHECK(share > 0.3);
        sum += share;
    }
    CHECK(sum > 0.7 * static_cast<double>(aims().size()));
}

TEST_CASE("rows 1 to 41: no core loses a ray that cannot miss, and all agree, float") {
    check_aims<float>(256);
}
TEST_CASE("rows 1 to 41: no core loses a ray that cannot miss, and all agree, double") {
    check_aims<double>(60);
}

TEST_CASE("the aimed rays of each row slip through kernels that leak") {
    // What each row's closed scenes lose at all, by some kernel that is known to be wrong.
    std::map<int, int> lost;
    for (const Aim& aim : aims()) {
        const bool at_rest = aim.row != 14 && aim.row != 41;
        if (!aim.closed || !at_rest) continue;
        const auto scene = renderer::prepare<float>(aim.scene);
        Kernels kernels[3];
        kernels[0].triangle = contracted_edges;
        kernels[0].box = nan_slabs;
        kernels[1].triangle = moller_trumbore;
        kernels[2].triangle = absolute_epsilon;
        for (const Kernels& wrong : kernels) {
            Random random(1);
            for (int i = 0; i < 1000; ++i) {
                lost[aim.row] += wrong(scene, local_ray(scene, aim.next(random))) ? 0 : 1;
            }
        }
    }
    for (const int row : {1, 3, 4, 7, 9, 10, 11, 23}) {
        CAPTURE(row);
        CHECK(lost[row] > 0);
    }
}

}  // namespace cobble::test
