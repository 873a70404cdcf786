// SPDX-License-Identifier: MIT
// Rays that go for the weak places of scenes: no core loses one of those that cannot miss.
#include <doctest/doctest.h>

#include <map>
#include <set>

#include "tests/hard/aims.hpp"
#include "tests/hard/cores.hpp"
#include "tests/hard/wrong_shapes.hpp"
#include "tests/support/record.hpp"

namespace cobble::test {

namespace {

template <typename T>
void check_aims(int rays) {
    std::map<int, int> asked;
    for (const Aim& aim : aims()) {
        CAPTURE(aim.name);
        Questions<T> cores(aim.scene);
        Random random(1);
        int lost = 0;
        for (int i = 0; i < rays; ++i) {
            const auto r = local_ray(cores.reference, aim.next(random));
            if (!cores.ask(r) && aim.closed) ++lost;
        }
        CHECK(lost == 0);
        CHECK(cores.differences() == "");
        asked[aim.row] += rays;
    }
    for (const auto& [row, count] : asked) {
        record(row, counted(count) + " aimed rays alike by all cores, " + name_of_type<T>());
    }
}

}  // namespace

TEST_CASE("rows 1 to 41: no core loses a ray that cannot miss, and all agree, float") {
    check_aims<float>(250);
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
