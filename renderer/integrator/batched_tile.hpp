// SPDX-License-Identifier: MIT
// The fast way through a tile: many samples on their way at once, each with its own stack, and one
// stage after the other for the top rays of them all.
//
// A round: samples that ended make room for new ones; the top ray of every stack goes into one
// batch; the core finds their hits; each is looked at; light by light, the shadow rays of all are
// asked about at once and the light summed; each ray brings back its colour and puts its children
// on its own stack. Within a sample everything is added in the order of the reference, and samples
// are added to their pixels in the order of the samples, so that the pictures are the same bits.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/film/film.hpp"
#include "renderer/integrator/trace.hpp"
#include "renderer/intersect/batch.hpp"
#include "renderer/tile/pixel_order.hpp"
#include "renderer/tile/tile_renderer.hpp"

namespace cobble::renderer {

/// Samples on their way at once, at most.
inline constexpr std::uint32_t kBatchSize = 128;

/// Memory: about 1 kB for each sample on its way, 80 bytes more a bounce, and eight times 104 bytes
/// for those that wait for it; in single precision.
template <typename T>
class BatchedTile final : public PausedWork {
  public:
    /// Both must outlive this.
    BatchedTile(const ShadingScene<T>& scene, const Settings& settings, const Tile& tile);

    /// Goes on with `work`, whose tile is this one; true once it is done, false if stopped.
    bool run(TileWork& work, Film& film, StopCheck& stop);

  private:
    /// What is to be done next. A tile can be put down between any two.
    enum class Stage : std::uint8_t { kGather, kMeet, kLook, kAsk, kShadow, kScatter };

    /// A sample on its way.
    struct Flight {
        SampleTrace<T> trace;
        Sampler sampler{0, 0, 0, 0};
        std::uint64_t number = 0;  ///< among the tile's samples
    };
    /// A sample at its end, which may have to wait for earlier ones.
    struct Landed {
        Sample sample;
        ir::ObjectId first_object;
        bool there = false;
    };
    /// Goes over the tile's samples: pixels by blocks, all samples of one, then the next.
    struct Cursor {
        std::uint64_t number = 0;
        std::uint64_t pixel = 0;
        std::uint32_t sample = 0;
        PixelPlace place;  ///< of the pixel

        explicit Cursor(const Tile& tile) : place(pixel_in_blocks(tile, 0)) {}
        void advance(const Tile& tile, std::uint32_t samples_per_pixel);
    };
    /// Rays for the core.
    struct Rays {
        std::vector<Ray<T>> rays;
        std::vector<Exclude> excludes;
        std::size_t coherent = 0;  ///< so many of the first are
        std::size_t asked = 0;     ///< so many of the first have their answers

        void clear();
        void add(const Ray<T>& ray, const Exclude& exclude);
    };

    void do_stage(TileWork& work, Film& film);
    void gather(TileWork& work);
    void begin_samples(const Tile& tile);
    void look();
    void ask_all(Counters& counters);
    void sum_light();
    void next_light();
    void scatter_all();
    void land(TileWork& work, Film& film);
    /// `core(first, count, coherence)` for the next rays, as many as may be asked about between two
    /// looks at the clock; true once all are.
    template <typename Core>
    bool ask_core(Rays& rays, const Counters& counters, const Core& core);

    const ShadingScene<T>* scene_;
    const Settings* settings_;
    std::uint32_t samples_;  ///< a pixel
    Stage stage_ = Stage::kGather;

    std::vector<Flight> flights_;
    std::vector<std::uint32_t> idle_;   ///< flights without a sample
    std::vector<std::uint32_t> order_;  ///< the others, by place in the batch: new samples first
    std::vector<std::uint32_t> older_;  ///< the others but for those
    Cursor next_to_begin_;

    // By place in the batch.
    Rays rays_;
    std::vector<Hit<T>> hits_;
    std::vector<Encounter<T>> met_;
    bool any_lit_ = false;

    // By shadow ray to light_.
    std::uint32_t light_ = 0;
    Rays shadow_;
    std::vector<std::uint32_t> asker_;  ///< place in the batch
    std::vector<math::Vec3<T>> contribution_;
    std::vector<std::uint8_t> hidden_;

    std::size_t at_once_;  ///< rays that the core is handed between two looks at the clock
    Offspring<T> children_;

    std::vector<Landed> landed_;  ///< by number, modulo their count
    Cursor next_to_land_;
    PixelAccumulator sums_;  ///< of the pixel that lands next
};

}  // namespace cobble::renderer
