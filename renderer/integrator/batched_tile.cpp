// SPDX-License-Identifier: MIT
#include "renderer/integrator/batched_tile.hpp"

#include <algorithm>
#include <bit>

namespace cobble::renderer {
namespace {

/// A sample may run ahead of one that takes long by this many batches. A tree of 2^8 rays beside
/// pixels of one ray then still finds company, and what waits stays small.
constexpr std::size_t kBatchesAhead = 8;

/// What the core may do between two looks at the clock: 2 ms at 10 ns a test, far below the 10 ms
/// by which a step may overrun. One batch of an ordinary scene is a tenth of it.
constexpr std::uint64_t kTestsAtOnce = 200000;
/// A packet or two, so that they are worth their name; 10 ms if each ray takes 60,000 tests.
constexpr std::size_t kFewestAtOnce = 16;

std::uint32_t flights_for(const Tile& tile, std::uint32_t samples) {
    if (tile.pixels() >= kBatchSize) return kBatchSize;
    return static_cast<std::uint32_t>(
        std::clamp<std::uint64_t>(tile.pixels() * samples, 1, kBatchSize));
}

std::uint64_t tests(const Counters& counters) {
    return counters.box_tests + counters.primitive_tests;
}

}  // namespace

template <typename T>
void BatchedTile<T>::Cursor::advance(const Tile& tile, std::uint32_t samples_per_pixel) {
    ++number;
    if (++sample < samples_per_pixel) return;
    sample = 0;
    if (++pixel < tile.pixels()) place = pixel_in_blocks(tile, pixel);
}

template <typename T>
void BatchedTile<T>::Rays::clear() {
    rays.clear();
    excludes.clear();
    coherent = asked = 0;
}

template <typename T>
void BatchedTile<T>::Rays::add(const Ray<T>& ray, const Exclude& exclude) {
    rays.push_back(ray);
    excludes.push_back(exclude);
}

template <typename T>
BatchedTile<T>::BatchedTile(const ShadingScene<T>& scene, const Settings& settings,
                            const Tile& tile)
    : scene_(&scene),
      settings_(&settings),
      samples_(std::max(settings.samples, 1U)),
      flights_(flights_for(tile, samples_)),
      next_to_begin_(tile),
      hits_(flights_.size()),
      met_(flights_.size()),
      hidden_(flights_.size()),
      at_once_(kFewestAtOnce),
      landed_(kBatchesAhead * std::bit_ceil(flights_.size())),
      next_to_land_(tile) {
    const std::size_t count = flights_.size();
    for (Flight& flight : flights_) flight.trace.stack.reserve(deepest_stack(scene));
    for (auto* list : {&idle_, &order_, &older_, &asker_}) list->reserve(count);
    for (Rays* rays : {&rays_, &shadow_}) {
        rays->rays.reserve(count);
        rays->excludes.reserve(count);
    }
    contribution_.reserve(count);
    for (std::size_t i = count; i > 0; --i) idle_.push_back(static_cast<std::uint32_t>(i - 1));
}

template <typename T>
bool BatchedTile<T>::run(TileWork& work, Film& film, StopCheck& stop) {
    while (!work.done()) {
        if (stop.now()) return false;
        do_stage(work, film);
    }
    return true;
}

template <typename T>
void BatchedTile<T>::do_stage(TileWork& work, Film& film) {
    Counters& counters = work.counters;
    switch (stage_) {
        case Stage::kGather:
            gather(work);
            stage_ = Stage::kMeet;
            break;
        case Stage::kMeet:
            if (ask_core(rays_, counters, [&](std::size_t at, std::size_t n, Coherence coherence) {
                    closest_hits<T>(scene_->geometry, std::span(rays_.rays).subspan(at, n),
                                    std::span(rays_.excludes).subspan(at, n),
                                    std::span(hits_).subspan(at, n), counters, coherence);
                })) {
                stage_ = Stage::kLook;
            }
            break;
        case Stage::kLook:
            look();
            light_ = 0;
            stage_ = any_lit_ && !scene_->lights.empty() ? Stage::kAsk : Stage::kScatter;
            break;
        case Stage::kAsk:
            ask_all(counters);
            if (shadow_.rays.empty()) {
                next_light();
            } else {
                stage_ = Stage::kShadow;
            }
            break;
        case Stage::kShadow:
            if (ask_core(shadow_, counters,
                         [&](std::size_t at, std::size_t n, Coherence coherence) {
                             any_hits<T>(scene_->geometry, std::span(shadow_.rays).subspan(at, n),
                                         std::span(shadow_.excludes).subspan(at, n),
                                         std::span(hidden_).subspan(at, n), counters, coherence);
                         })) {
                sum_light();
                next_light();
            }
            break;
        case Stage::kScatter:
            scatter_all();
            land(work, film);
            stage_ = Stage::kGather;
            break;
    }
}

template <typename T>
template <typename Core>
bool BatchedTile<T>::ask_core(Rays& rays, const Counters& counters, const Core& core) {
    const bool coherent = rays.asked < rays.coherent;
    const std::size_t end = coherent ? rays.coherent : rays.rays.size();
    const std::size_t count = std::min(end - rays.asked, at_once_);
    const std::uint64_t before = tests(counters);
    core(rays.asked, count, coherent ? Coherence::kCoherent : Coherence::kNone);
    rays.asked += count;
    const std::uint64_t of_one = (tests(counters) - before) / count + 1;
    at_once_ = std::clamp<std::size_t>(kTestsAtOnce / of_one, kFewestAtOnce, kBatchSize);
    return rays.asked == rays.rays.size();
}

template <typename T>
void BatchedTile<T>::begin_samples(const Tile& tile) {
    while (!idle_.empty() && next_to_begin_.pixel < tile.pixels() &&
           next_to_begin_.number - next_to_land_.number < landed_.size()) {
        const PixelPlace at = next_to_begin_.place;
        Flight& flight = flights_[idle_.back()];
        flight.sampler = Sampler(settings_->seed, at.x, at.y, next_to_begin_.sample);
        flight.number = next_to_begin_.number;
        begin_sample(*scene_, *settings_, flight.sampler, at.x, at.y, flight.trace);
        order_.push_back(idle_.back());
        idle_.pop_back();
        next_to_begin_.advance(tile, samples_);
    }
}

/// The top ray of every stack. New samples are begun only when half of the flights are idle, so
/// that their rays are many: those from the camera are the coherent ones.
template <typename T>
void BatchedTile<T>::gather(TileWork& work) {
    rays_.clear();
    if (2 * idle_.size() >= flights_.size()) {
        older_.swap(order_);
        order_.clear();
        begin_samples(work.tile);
        rays_.coherent = order_.size();
        order_.insert(order_.end(), older_.begin(), older_.end());
    }
    for (const std::uint32_t index : order_) {
        const TracedRay<T>& ray = flights_[index].trace.stack.back();
        rays_.add(ray.ray, ray.exclude);
        count(work.counters, ray.kind);
    }
}

template <typename T>
void BatchedTile<T>::look() {
    any_lit_ = false;
    for (std::size_t i = 0; i < order_.size(); ++i) {
        met_[i].hit = hits_[i];
        meet(*scene_, flights_[order_[i]].trace.stack.back(), met_[i]);
        any_lit_ = any_lit_ || met_[i].lit();
    }
}

/// What the light adds where nothing can be in its way is added at once.
template <typename T>
void BatchedTile<T>::ask_all(Counters& counters) {
    shadow_.clear();
    asker_.clear();
    contribution_.clear();
    for (std::uint32_t i = 0; i < order_.size(); ++i) {
        if (!met_[i].lit()) continue;
        const Flight& flight = flights_[order_[i]];
        const LightQuestion<T> light =
            ask_light(*scene_, flight.sampler, flight.trace.stack.back(), met_[i], light_);
        if (!light.matters) continue;
        if (!scene_->effects.shadows) {
            met_[i].light += light.contribution;
            continue;
        }
        shadow_.add(light.shadow.ray, light.shadow.exclude);
        asker_.push_back(i);
        contribution_.push_back(light.contribution);
        if (i < rays_.coherent) ++shadow_.coherent;
    }
    counters.shadow_rays += shadow_.rays.size();
}

template <typename T>
void BatchedTile<T>::sum_light() {
    for (std::size_t i = 0; i < asker_.size(); ++i) {
        if (hidden_[i] == 0) met_[asker_[i]].light += contribution_[i];
    }
}

template <typename T>
void BatchedTile<T>::next_light() {
    ++light_;
    stage_ = light_ < scene_->lights.size() ? Stage::kAsk : Stage::kScatter;
}

template <typename T>
void BatchedTile<T>::scatter_all() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < order_.size(); ++i) {
        Flight& flight = flights_[order_[i]];
        SampleTrace<T>& trace = flight.trace;
        const TracedRay<T> ray = trace.stack.back();
        trace.stack.pop_back();
        scatter(*scene_, ray, met_[i], children_);
        bring_back(trace, ray, met_[i], color_of(*scene_, ray, met_[i]), children_);
        if (!trace.done()) {
            order_[kept++] = order_[i];
            continue;
        }
        landed_[flight.number % landed_.size()] = {trace.sample, trace.first_object, true};
        idle_.push_back(order_[i]);
    }
    order_.resize(kept);
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
        if (!sums_.add(landed.sample)) {
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
