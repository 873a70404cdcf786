// SPDX-License-Identifier: MIT
#include "renderer/integrator/batched_tile.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "renderer/wide/wide.hpp"

namespace cobble::renderer {
namespace {

/// Samples of a run: so many that of a deep turn's rays, which head everywhere, those that are
/// alike are enough for packets, and so few that what one turn hands the next stays in the second
/// cache.
constexpr std::size_t kMostSamples = 1024;
constexpr std::size_t kFewestSamples = 64;
/// Rays that a tree is meant to have, and that it may have before it is put aside.
constexpr std::uint64_t kUsualRays = 3U << 13U;
constexpr std::size_t kMostRays = 1U << 15U;

}  // namespace

template <typename T>
BatchedTile<T>::BatchedTile(const ShadingScene<T>& scene, const Settings& settings,
                            const TileWork& work)
    : scene_(&scene),
      only_color_(color_tells_all(scene, settings)),
      left_(work.pixels * work.pass.count),
      run_size_(kMostSamples),
      camera_(scene, settings, work.pass, work.tile),
      batch_(scene),
      next_to_land_(work.pass, work.tile) {
    begin_run();
}

template <typename T>
bool BatchedTile<T>::run(TileWork& work, Film& film, StopCheck& stop) {
    const auto draw = [this](std::size_t lane, std::uint32_t light, std::uint32_t number) {
        const Carried<T>& of = carried_[lane];
        return flights_[of.sample].sampler.draw(Draw::kLight, tree_.group_of(of.number).path, light,
                                                number, scene_->lights[light].samples);
    };
    while (!work.done()) {
        if (stop.between_stages(work.counters.tests())) return false;
        if (!on_its_way_) {
            begin_batch(work);
        } else if (batch_.step(work, draw)) {
            work.clock.enter(TimedStage::kOnward);
            scatter();
            end_batch(work, film);
        }
    }
    return true;
}

template <typename T>
void BatchedTile<T>::begin_run() {
    flights_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(run_size_, left_)));
    left_ -= flights_.size();
    run_rays_ = 0;
    begun_ = 0;
    depth_ = 0;
    first_ray_ = first_group_ = 0;
    tree_.begin(PathAddress{}, flights_.size());
}

template <typename T>
void BatchedTile<T>::begin_batch(TileWork& work) {
    if (depth_ == 0) {
        begin_camera_batch(work);
    } else {
        begin_turn_batch(work);
    }
    run_rays_ += batch_.rays().size();
    batch_.begin();
    on_its_way_ = true;
}

template <typename T>
void BatchedTile<T>::begin_camera_batch(TileWork& work) {
    work.clock.enter(TimedStage::kCamera);
    camera_.begin(flights_.size() - begun_, from_camera_, work.counters);
    RayBatch<T>& rays = batch_.rays();
    rays = from_camera_;
    work.counters.camera_rays += rays.size();
    for (std::size_t i = 0; i < rays.size(); ++i) {
        Flight& flight = flights_[begun_ + i];
        flight = {};
        flight.sampler = camera_.sampler(i);
        carried_[i] = {};
        carried_[i].sample = carried_[i].number = static_cast<std::uint32_t>(begun_ + i);
    }
    begun_ += rays.size();
}

/// The order of the turn's rays of one kind: those that go the same way side by side.
template <typename T>
void BatchedTile<T>::sort() {
    PendingRays<T>& rays = now_[turn_];
    const Likeness* const likenesses = rays.likenesses(0);
    const std::size_t count = rays.size();
    order_.resize(count);
    ends_.fill(0);
    if (count < kFewestTogether) {
        std::iota(order_.begin(), order_.end(), 0U);
        ends_.back() = static_cast<std::uint32_t>(count);
        return;
    }
    for (std::size_t i = 0; i < count; ++i) ++ends_[likenesses[i]];
    std::uint32_t begin = 0;
    for (std::uint32_t& end : ends_) begin += std::exchange(end, begin);
    for (std::size_t i = 0; i < count; ++i) {
        order_[ends_[likenesses[i]]++] = static_cast<std::uint32_t>(i);
    }
}

/// The next rays of the turn, all of one kind.
template <typename T>
void BatchedTile<T>::begin_turn_batch(TileWork& work) {
    work.clock.enter(TimedStage::kOnward);
    RayBatch<T>& rays = batch_.rays();
    if (at_ == now_[turn_].size()) {
        ++turn_;
        at_ = 0;
    }
    if (at_ == 0) sort();
    PendingRays<T>& from = now_[turn_];
    const std::size_t count = std::min(kBatchSize, from.size() - at_);
    (turn_ == 0 ? work.counters.reflected_rays : work.counters.refracted_rays) += count;
    rays.begin(count);
    const std::uint32_t* const order = order_.data() + at_;
    for (std::size_t lane = 0; lane < count; ++lane) {
        rays.rays[lane] = *from.rays(order[lane]);
        rays.excludes[lane] = *from.excludes(order[lane]);
        carried_[lane] = *from.carried(order[lane]);
    }
    std::size_t begin = 0;
    for (std::size_t h = 0; h < kHeadings; ++h) {
        const std::uint32_t end = ends_[(h + 1) * kLikePlaces - 1];
        if (end <= at_ + begin) continue;
        const std::size_t to = std::min(count, end - at_);
        const bool alike = to - begin >= kFewestTogether;
        rays.end_stretch_at(to, alike ? Coherence::kCoherent : Coherence::kNone);
        begin = to;
        if (begin == count) break;
    }
    at_ += count;
}

/// From the batch's colours to the tree, and from its rays to the next turn.
template <typename T>
void BatchedTile<T>::scatter() {
    const std::size_t count = batch_.rays().size();
    BatchShading<T>& shading = batch_.shading();
    tree_.bring(batch_.colors(), carried_.data(), count);
    if (depth_ == 0) {
        for (std::size_t lane = 0; lane < count; ++lane) {
            Flight& flight = flights_[carried_[lane].sample];
            flight.first_object = batch_.hit(lane).object;
            if (!only_color_) see_first(flight.sample, shading.encounter(lane));
        }
    }
    if (depth_ >= scene_->bounces || !shading.scatter(carried_.data())) return;
    for (std::size_t turn = 0; turn < kTurns; ++turn) {
        next_[turn].make_room(count + 1);
        shading.append_children(kTurn[turn], carried_.data(), next_[turn]);
    }
}

template <typename T>
void BatchedTile<T>::end_batch(TileWork& work, Film& film) {
    on_its_way_ = false;
    const bool turn_ends =
        depth_ == 0 ? begun_ == flights_.size()
                    : at_ == now_[turn_].size() && (turn_ + 1 == kTurns || now_[turn_ + 1].empty());
    if (!turn_ends) return;
    if (next_turn()) {
        if (tree_.ray_count() <= kMostRays) return;
        put_aside();
    } else {
        tree_.visit_all([this](std::uint32_t index) { add_all(tree_.groups()[index]); });
    }
    if (take_up()) return;
    land(work, film);
    const std::uint64_t of_one = run_rays_ / flights_.size() + 1;
    run_size_ = std::clamp<std::size_t>(kUsualRays / of_one, kFewestSamples, kMostSamples);
    begin_run();
}

/// False if there is none.
template <typename T>
bool BatchedTile<T>::next_turn() {
    const std::uint32_t first_parent = first_ray_;
    const std::uint32_t first_group = first_group_;
    first_ray_ = static_cast<std::uint32_t>(tree_.ray_count());
    first_group_ = static_cast<std::uint32_t>(tree_.groups().size());
    for (std::size_t turn = 0; turn < kTurns; ++turn) {
        std::swap(now_[turn], next_[turn]);
        next_[turn].clear();
        number(turn, first_parent, first_group);
    }
    ++depth_;
    turn_ = 0;
    at_ = 0;
    return !now_[0].empty() || !now_[1].empty();
}

/// Numbers the rays of one kind in the order of their parents, and makes groups of them.
template <typename T>
void BatchedTile<T>::number(std::size_t turn, std::uint32_t first_parent,
                            std::uint32_t first_group) {
    PendingRays<T>& rays = now_[turn];
    numbers_.assign(first_ray_ - first_parent, 0);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        numbers_[rays.carried(i)->number - first_parent] = 1;
    }
    auto next = static_cast<std::uint32_t>(tree_.ray_count());
    for (std::uint32_t g = first_group; g < first_group_; ++g) {
        const RayGroup group = tree_.groups()[g];
        const std::uint32_t begin = next;
        for (std::size_t i = group.begin; i < group.end; ++i) {
            std::uint32_t& of = numbers_[i - first_parent];
            next += std::exchange(of, next);
        }
        if (next > begin) tree_.add(g, turn, next - begin);
    }
    for (std::size_t i = 0; i < rays.size(); ++i) {
        std::uint32_t& of = rays.carried(i)->number;
        of = numbers_[of - first_parent];
    }
}

/// Adds what comes before the groups of the turn that has not been, and puts those and what comes
/// behind them aside.
template <typename T>
void BatchedTile<T>::put_aside() {
    Pile& pile = piles_.emplace_back();
    pile.depth = depth_;
    std::vector<Aside>& parts = pile.parts;
    std::vector<std::uint32_t> part_of(tree_.groups().size() - first_group_);
    bool open = false;  ///< what is added comes behind the last part
    const auto brought_count = [&] { return static_cast<std::uint32_t>(pile.brought.size()); };
    tree_.visit_all([&](std::uint32_t index) {
        const RayGroup& group = tree_.groups()[index];
        const bool leaf = index >= first_group_;
        if (!leaf && parts.empty()) return add_all(group);
        if (!open) parts.emplace_back().brought_begin = brought_count();
        open = !leaf;
        if (leaf) {
            part_of[index - first_group_] = static_cast<std::uint32_t>(parts.size() - 1);
            parts.back().path = group.path;
            parts.back().rays_end = group.end - group.begin;
        } else {
            tree_.each_brought(group,
                               [&](const Brought<T>& brought) { pile.brought.push_back(brought); });
        }
        parts.back().brought_end = brought_count();
    });
    std::uint32_t begin = 0;
    for (Aside& part : parts) {
        part.rays_begin = begin;
        part.rays_end = begin += part.rays_end;
    }
    pile.rays.make_room(begin);
    pile.rays.take_in(begin);
    // Each in the place that its group's rays are numbered by.
    for (std::size_t turn = 0; turn < kTurns; ++turn) {
        PendingRays<T>& from = now_[turn];
        for (std::size_t i = 0; i < from.size(); ++i) {
            const std::uint32_t number = from.carried(i)->number;
            const RayGroup& group = tree_.group_of(number);
            const auto index = static_cast<std::size_t>(&group - tree_.groups().data());
            Aside& part = parts[part_of[index - first_group_]];
            part.turn = static_cast<std::uint8_t>(turn);
            const std::uint32_t in_group = number - group.begin;
            const std::size_t to = part.rays_begin + in_group;
            *pile.rays.rays(to) = *from.rays(i);
            *pile.rays.excludes(to) = *from.excludes(i);
            *pile.rays.likenesses(to) = *from.likenesses(i);
            Carried<T>& carried = *pile.rays.carried(to);
            carried = *from.carried(i);
            carried.number = in_group;
        }
    }
    std::reverse(parts.begin(), parts.end());
}

/// The next of what was put aside; false if nothing is.
template <typename T>
bool BatchedTile<T>::take_up() {
    while (!piles_.empty()) {
        Pile& pile = piles_.back();
        if (pile.parts.empty()) {
            piles_.pop_back();
            continue;
        }
        const Aside part = pile.parts.back();
        pile.parts.pop_back();
        for (std::uint32_t i = part.brought_begin; i < part.brought_end; ++i) add(pile.brought[i]);
        if (part.rays_begin == part.rays_end) continue;
        const std::size_t count = part.rays_end - part.rays_begin;
        tree_.begin(part.path, count);
        for (PendingRays<T>& rays : now_) rays.clear();
        now_[part.turn].append(pile.rays, part.rays_begin, count);
        depth_ = pile.depth;
        turn_ = at_ = 0;
        first_ray_ = first_group_ = 0;
        return true;
    }
    return false;
}

/// Into the pixels.
template <typename T>
void BatchedTile<T>::land(TileWork& work, Film& film) {
    work.clock.enter(TimedStage::kPixels);
    for (const Flight& flight : flights_) {
        const PixelPlace at = next_to_land_.place();
        const bool sound =
            only_color_ ? sums_.add_color(flight.sample.color) : sums_.add(flight.sample);
        if (!sound) {
            work.report(bad_sample(*scene_->source, at.x, at.y, next_to_land_.sample(),
                                   flight.first_object));
        }
        ++work.samples_done;
        if (!next_to_land_.advance()) continue;
        film.set_pixel(at.x, at.y, sums_.pixel());
        sums_ = {};
        work.end_pixels();
    }
}

template class BatchedTile<float>;
template class BatchedTile<double>;

}  // namespace cobble::renderer
