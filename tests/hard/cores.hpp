// SPDX-License-Identifier: MIT
// Every core that answers rays, held against brute force to the last bit.
#pragma once

#include <string>
#include <vector>

#include "tests/hard/scenes.hpp"

namespace cobble::test {

/// The reference's tree, as one way to cast a ray: what tests of wrong ways put in its place.
inline constexpr auto kByTree = [](const auto& scene, const auto& ray) {
    renderer::Counters counters;
    return closest_hit(scene, ray, {}, counters);
};

/// Rays into one scene, what each must leave out, and what brute force answers.
template <typename T>
struct Questions {
    explicit Questions(const ir::Scene& scene);

    /// Keeps the question; gives brute force's answer. Coordinates are local to `reference`.
    renderer::Hit<T> ask(const renderer::Ray<T>& ray, const renderer::Exclude& exclude = {});

    /// Asks the reference's tree and, by each instruction set of this processor, the fast core: ray
    /// by ray, in batches, and in batches said to be coherent; closest hits and any hits. Names
    /// each that differs from brute force in t, object, face, u or v, and how often; empty if none
    /// does.
    [[nodiscard]] std::string differences() const;

    renderer::PreparedScene<T> reference;
    renderer::PreparedScene<T> fast;
    std::vector<renderer::Ray<T>> rays;
    std::vector<renderer::Exclude> excludes;
    std::vector<renderer::Hit<T>> answers;
};

}  // namespace cobble::test
