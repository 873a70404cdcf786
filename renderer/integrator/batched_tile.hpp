// SPDX-License-Identifier: MIT
// The fast way through a tile of a scene in which rays go on from surfaces: many samples on their
// way at once, turn by turn.
//
// All samples of a run send their first rays, then those that go on from there, and so on. Whatever
// path they took, the rays of a turn wait in one place, reflected ones apart from refracted ones,
// and are taken in an order in which those that leave the same object in much the same direction
// are neighbours: batches are full, and most of their rays go in packets. What each ray brings back
// is kept by its place in the tree of paths; in the end all of it is added to the samples in the
// order of the reference, and the samples to their pixels in their order, so that the pictures are
// the same bits. A tree that grows too big is put aside, and what is left of it followed path by
// path.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "renderer/film/film.hpp"
#include "renderer/integrator/batch_stages.hpp"
#include "renderer/integrator/camera_batch.hpp"
#include "renderer/integrator/pending_rays.hpp"
#include "renderer/integrator/ray_tree.hpp"
#include "renderer/integrator/trace.hpp"
#include "renderer/tile/tile_renderer.hpp"

namespace cobble::renderer {

/// Memory: some 150 bytes for each sample of a run, and in single precision 16 for each ray of its
/// trees and 82 for each ray of two turns. There are at most 33,000 rays of one, or twice that in
/// a turn; each six turns more, at the worst, may put as many aside.
template <typename T>
class BatchedTile final : public PausedWork {
  public:
    /// Scene and settings must outlive this.
    BatchedTile(const ShadingScene<T>& scene, const Settings& settings, const TileWork& work);

    /// Goes on with `work`, the one that this was made for; true once it is done, false if stopped.
    bool run(TileWork& work, Film& film, StopCheck& stop);

  private:
    /// A sample on its way.
    struct Flight {
        Sample sample;
        Sampler sampler{0, 0, 0, 0};
        ir::ObjectId first_object;
    };
    /// Part of what was put aside: what is added first, then rays of one path that are followed.
    struct Aside {
        PathAddress path;
        std::uint32_t brought_begin = 0, brought_end = 0;
        std::uint32_t rays_begin = 0, rays_end = 0;
        std::uint8_t turn = 0;
    };
    /// A tree put aside, all of it side by side: it may be of thousands of paths.
    struct Pile {
        std::vector<Brought<T>> brought;
        PendingRays<T> rays;
        std::uint32_t depth = 0;
        std::vector<Aside> parts;  ///< the next one last
    };

    void begin_run();
    void begin_batch(TileWork& work);
    void begin_camera_batch(TileWork& work);
    void begin_turn_batch(TileWork& work);
    void scatter();
    void end_batch(TileWork& work, Film& film);
    bool next_turn();
    void number(std::size_t turn, std::uint32_t first_parent, std::uint32_t first_group);
    void sort();
    void put_aside();
    bool take_up();
    void add(const Brought<T>& brought) {
        flights_[brought.sample].sample.color += brought.color.template to<double>();
    }
    void add_all(const RayGroup& group) {
        tree_.each_brought(group, [this](const Brought<T>& brought) { add(brought); });
    }
    void land(TileWork& work, Film& film);

    const ShadingScene<T>* scene_;
    bool only_color_;
    std::uint64_t left_;  ///< samples of the tile that are in no run yet

    // A run of samples.
    std::size_t run_size_;
    std::vector<Flight> flights_;
    std::size_t begun_ = 0;
    std::uint64_t run_rays_ = 0;
    CameraBatch<T> camera_;
    RayBatch<T> from_camera_;
    RayTree<T> tree_;
    std::vector<Pile> piles_;  ///< the next one last

    // A turn; the camera's rays are number 0.
    std::uint32_t depth_ = 0;
    std::array<PendingRays<T>, kTurns> now_, next_;
    std::uint32_t first_ray_ = 0, first_group_ = 0;  ///< of the tree's
    std::vector<std::uint32_t> numbers_;             ///< of children, by their parents
    // Where the next batch begins, of turns that are not the camera's.
    std::size_t turn_ = 0;  ///< kind of its rays
    std::size_t at_ = 0;    ///< among those of its kind, in this order:
    std::vector<std::uint32_t> order_;
    std::array<std::uint32_t, kLikenesses> ends_;  ///< of those of each likeness, in it

    bool on_its_way_ = false;  ///< a batch is
    BatchStages<T> batch_;
    std::array<Carried<T>, kBatchSize> carried_;

    SampleCursor next_to_land_;
    PixelAccumulator sums_;  ///< of the pixel that lands next
};

}  // namespace cobble::renderer
