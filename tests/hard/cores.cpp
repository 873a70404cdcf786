// SPDX-License-Identifier: MIT
#include "tests/hard/cores.hpp"

#include <cstdint>
#include <span>

#include "renderer/intersect/batch.hpp"
#include "renderer/intersect/instruction_set.hpp"
#include "tests/support/with_instruction_set.hpp"

namespace cobble::test {

namespace {

template <typename T>
renderer::PreparedScene<T> prepared_for(const ir::Scene& scene, renderer::Acceleration core) {
    renderer::PrepareOptions options;
    options.acceleration = core;
    return renderer::prepare<T>(scene, options);
}

template <typename T>
std::size_t wrong_singles(const renderer::PreparedScene<T>& scene, const Questions<T>& q) {
    renderer::Counters counters;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < q.rays.size(); ++i) {
        const auto hit = closest_hit(scene, q.rays[i], q.excludes[i], counters);
        const bool any = any_hit(scene, q.rays[i], q.excludes[i], counters);
        wrong += same(hit, q.answers[i]) ? 0 : 1;
        wrong += any == q.answers[i].object.valid() ? 0 : 1;
    }
    return wrong;
}

template <typename T>
std::size_t wrong_batches(const Questions<T>& q, renderer::Coherence coherence) {
    renderer::Counters counters;
    std::vector<renderer::Hit<T>> hits(q.rays.size());
    std::vector<std::uint8_t> any(q.rays.size());
    const auto rays = std::span<const renderer::Ray<T>>(q.rays);
    const auto excludes = std::span<const renderer::Exclude>(q.excludes);
    closest_hits(q.fast, rays, excludes, std::span(hits), counters, coherence);
    any_hits(q.fast, rays, excludes, std::span(any), counters, coherence);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        wrong += same(hits[i], q.answers[i]) ? 0 : 1;
        wrong += (any[i] != 0) == q.answers[i].object.valid() ? 0 : 1;
    }
    return wrong;
}

}  // namespace

template <typename T>
Questions<T>::Questions(const ir::Scene& scene)
    : reference(prepared_for<T>(scene, renderer::Acceleration::kBvh)),
      fast(prepared_for<T>(scene, renderer::Acceleration::kFast)) {}

template <typename T>
renderer::Hit<T> Questions<T>::ask(const renderer::Ray<T>& ray, const renderer::Exclude& exclude) {
    renderer::Counters counters;
    rays.push_back(ray);
    excludes.push_back(exclude);
    answers.push_back(closest_hit_brute_force(reference, ray, exclude, counters));
    return answers.back();
}

template <typename T>
std::string Questions<T>::differences() const {
    std::string text;
    const auto add = [&](const std::string& core, std::size_t wrong) {
        if (wrong == 0) return;
        text += core + ": " + std::to_string(wrong) + " of " + std::to_string(rays.size()) + "; ";
    };
    add("tree", wrong_singles(reference, *this));
    for (const std::string& name : renderer::instruction_sets()) {
        const WithInstructionSet with(name);
        add(name, wrong_singles(fast, *this));
        add(name + " in batches", wrong_batches(*this, renderer::Coherence::kNone));
        add(name + " in packets", wrong_batches(*this, renderer::Coherence::kCoherent));
    }
    return text;
}

template struct Questions<float>;
template struct Questions<double>;

}  // namespace cobble::test
