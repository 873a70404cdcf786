// SPDX-License-Identifier: MIT
// Small damage to scene texts, the same on every machine: what people do to a file while they type,
// and what happens to it on the way.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/split_mix.hpp"

namespace cobble::frontend::testing {

using Random = test::SplitMix64;

/// One change at a random place; `other` is a text to take a piece from.
void mutate(std::string& text, std::string_view other, Random& random);

/// The generator of one run: any numbers, but the same ones, so that a failure can be repeated.
inline Random random_of(int run) { return Random(20120401U + static_cast<std::uint64_t>(run)); }

/// One of `texts`, damaged: half of all results have one flaw, few have many.
std::string damaged(const std::vector<std::string>& texts, Random& random);

/// How many damaged scenes to try: COBBLE_MUTATIONS of the environment, else `usual`.
int wanted_runs(int usual);

/// All scene texts to hand: this project's own, and the published ones where they are. In order of
/// their paths.
std::vector<std::string> scene_texts();

}  // namespace cobble::frontend::testing
