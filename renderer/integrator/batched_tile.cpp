// SPDX-License-Identifier: MIT
#include "renderer/integrator/batched_tile.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace cobble::renderer {
namespace {

/// Samples on their way at once, at most: so many that two batches are full, and that what they
/// need stays in the second cache. Measured from 128 to 1024, it made no difference.
constexpr std::uint32_t kFlights = 256;

/// A sample may run ahead of one that takes long by this many times all flights. A tree of 2^8 rays
/// beside pixels of one ray then still finds company, and what waits stays small.
constexpr std::size_t kAhead = 8;

/// Fewer rays that went the same way are no packet.
constexpr std::size_t kFewestCoherent = 16;

std::uint32_t flights_for(const Tile& tile, std::uint32_t samples) {
    if (tile.pixels() >= kFlights) return kFlights;
    return static_cast<std::uint32_t>(
        std::clamp<std::uint64_t>(tile.pixels() * samples, 1, kFlights));
}

}  // namespace

template <typename T>
BatchedTile<T>::BatchedTile(const ShadingScene<T>& scene, const Settings& settings,
                            const Tile& tile)
    : scene_(&scene),
      settings_(&settings),
      only_color_(color_tells_all(scene, settings)),
      samples_(std::max(settings.samples, 1U)),
      flights_(flights_for(tile, samples_)),
      camera_(scene, settings, tile),
      batch_(scene),
      landed_(kAhead * std::bit_ceil(flights_.size())),
      next_to_land_(tile) {
    const std::size_t count = flights_.size();
    for (Flight& flight : flights_) flight.trace.stack.reserve(deepest_stack(scene));
    for (auto* list : {&idle_, &next_, &round_}) list->reserve(count);
    for (std::size_t i = count; i > 0; --i) idle_.push_back(static_cast<std::uint32_t>(i - 1));
}

template <typename T>
bool BatchedTile<T>::run(TileWork& work, Film& film, StopCheck& stop) {
    const auto draw = [this](std::size_t lane, std::uint32_t light) {
        const Flight& of = flight(lane);
        return of.sampler.draw(Draw::kLight, of.trace.stack.back().path, light);
    };
    while (!work.done()) {
        if (stop.between_stages(work.counters.tests())) return false;
        if (!on_its_way_) {
            gather(work);
        } else if (batch_.step(work.counters, draw)) {
            scatter_all();
            land(work, film);
        }
    }
    return true;
}

template <typename T>
void BatchedTile<T>::begin_samples(const Tile& tile) {
    while (!idle_.empty()) {
        const std::uint64_t ahead = camera_.next().number - next_to_land_.number;
        camera_.begin(
            tile, std::min(idle_.size(), landed_.size() - static_cast<std::size_t>(ahead)), begun_);
        if (begun_.empty()) return;
        std::uint64_t number = camera_.next().number - begun_.size();
        for (std::size_t i = 0; i < begun_.size(); ++i) {
            const std::uint32_t index = idle_.back();
            idle_.pop_back();
            next_.push_back(index);
            Flight& flight = flights_[index];
            flight.sampler = camera_.sampler(i);
            flight.number = number++;
            flight.trace.sample = {};
            flight.trace.first_object = {};
            flight.trace.stack.emplace_back().ray = begun_.rays[i];
        }
    }
}

/// By the turns of their rays, those of a few turns one by one; else as they were.
template <typename T>
void BatchedTile<T>::sort_round() {
    constexpr std::size_t kPaths = 256;  // all of up to seven turns
    const auto path_of = [this](std::uint32_t index) {
        return std::min<std::uint64_t>(flights_[index].trace.stack.back().path.value(), kPaths - 1);
    };
    std::array<std::uint32_t, kPaths + 1> begins{};
    for (const std::uint32_t index : next_) ++begins[path_of(index) + 1];
    for (std::size_t i = 0; i < kPaths; ++i) begins[i + 1] += begins[i];
    round_.resize(next_.size());
    for (const std::uint32_t index : next_) round_[begins[path_of(index)]++] = index;
    next_.clear();
}

/// The next batch of the round, or the first of a new one. New samples are begun only when half of
/// the flights are idle, so that their rays are many: those from the camera are the most coherent.
template <typename T>
void BatchedTile<T>::gather(TileWork& work) {
    RayBatch<T>& rays = batch_.rays();
    first_ += rays.size();
    if (first_ == round_.size()) {
        if (2 * idle_.size() >= flights_.size()) begin_samples(work.tile);
        sort_round();
        first_ = 0;
    }
    rays.clear();
    const std::size_t count = std::min(kBatchSize, round_.size() - first_);
    PathAddress path;
    std::size_t alike = 0;
    const auto end_stretch = [&] {
        rays.end_stretch(alike >= kFewestCoherent ? Coherence::kCoherent : Coherence::kNone);
        alike = 0;
    };
    for (std::size_t lane = 0; lane < count; ++lane) {
        const TracedRay<T>& ray = flight(lane).trace.stack.back();
        if (ray.path.value() != path.value()) {
            end_stretch();
            path = ray.path;
        }
        ++alike;
        rays.add(ray.ray, ray.exclude);
        renderer::count(work.counters, ray.kind);
    }
    end_stretch();
    batch_.begin();
    on_its_way_ = true;
}

template <typename T>
void BatchedTile<T>::scatter_all() {
    const std::size_t count = batch_.rays().size();
    BatchShading<T>& shading = batch_.shading();
    shading.scatter([this](std::size_t lane) -> const TracedRay<T>& {
        return flight(lane).trace.stack.back();
    });
    for (std::size_t lane = 0; lane < count; ++lane) {
        Flight& flight = this->flight(lane);
        SampleTrace<T>& trace = flight.trace;
        const TracedRay<T> ray = trace.stack.back();
        trace.stack.pop_back();
        trace.sample.color += (ray.weight * batch_.colors().at(lane)).template to<double>();
        if (ray.kind == RayKind::kCamera) {
            trace.first_object = batch_.hit(lane).object;
            if (!only_color_) see_first(trace.sample, shading.encounter(lane));
        }
        shading.push_children(lane, ray, trace.stack);
        const std::uint32_t index = round_[first_ + lane];
        if (!trace.done()) {
            next_.push_back(index);
            continue;
        }
        landed_[flight.number % landed_.size()] = {trace.sample, trace.first_object, true};
        idle_.push_back(index);
    }
    on_its_way_ = false;
}

/// Into the pixel, in the order of samples, whatever has landed without a gap.
template <typename T>
void BatchedTile<T>::land(TileWork& work, Film& film) {
    while (!work.done()) {
        Landed& landed = landed_[next_to_land_.number % landed_.size()];
        if (!landed.there) return;
        landed.there = false;
        const PixelPlace at = next_to_land_.place;
        const std::uint32_t sample = next_to_land_.sample;
        const bool sound =
            only_color_ ? sums_.add_color(landed.sample.color) : sums_.add(landed.sample);
        if (!sound) {
            work.report(bad_sample(*scene_->source, at.x, at.y, sample, landed.first_object));
        }
        ++work.samples_done;
        next_to_land_.advance(work.tile, samples_);
        if (next_to_land_.sample != 0) continue;
        film.set_pixel(at.x, at.y, sums_.pixel());
        sums_ = {};
        ++work.pixels_done;
    }
}

template class BatchedTile<float>;
template class BatchedTile<double>;

}  // namespace cobble::renderer
