// SPDX-License-Identifier: MIT
// Which passes a render takes over its picture, one after the other: a fixed number of samples is
// one pass, or one for each scramble; a picture with an error to reach decides after each round of
// passes which pixels need another.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "renderer/estimate/achieved.hpp"
#include "renderer/film/film.hpp"
#include "renderer/sampling/sample_pass.hpp"
#include "renderer/settings.hpp"
#include "renderer/tile/pixel_mask.hpp"
#include "renderer/tile/tile_renderer.hpp"

namespace cobble::renderer {

struct Pass {
    SamplePass samples;
    std::uint32_t scramble = 0;
};

class PassPlan {
  public:
    PassPlan() = default;
    PassPlan(const PassPlan&) = delete;
    PassPlan& operator=(const PassPlan&) = delete;
    virtual ~PassPlan() = default;

    /// What there is to be worked out of the passes before next() can be asked: a number of parts,
    /// which threads may work out at once. To be asked again once they are, until it gives 0.
    virtual std::uint32_t due(const Film& /*film*/) { return 0; }
    virtual void work_out(std::uint32_t /*part*/) {}
    /// The pass after all those before it, whose samples are in `film`; nothing at the end. What it
    /// points to stays until the next call. Depends on the samples alone, never on `seconds`, which
    /// the passes so far took: that is for predictions. Cost: at the end some 0.3 us a pixel.
    virtual std::optional<Pass> next(Film& film, double seconds) = 0;
    /// Samples over all pixels and passes, as far as it can be told: grows more true.
    [[nodiscard]] virtual std::uint64_t expected_samples() const = 0;
    [[nodiscard]] virtual std::optional<Forecast> forecast() const { return std::nullopt; }
    /// How exact the picture is; after the end. Nothing if the plan cannot tell.
    [[nodiscard]] virtual std::optional<Achieved> achieved() const = 0;

    /// To go on in another program from bytes() of a plan of the same settings, asked for when its
    /// last pass was not over: the next next() gives that pass again. False: they are of no such.
    [[nodiscard]] virtual std::vector<std::uint8_t> bytes() const = 0;
    [[nodiscard]] virtual bool restore(const std::vector<std::uint8_t>& bytes) = 0;
};

/// For settings of a scene without compat; `tiles` are the render's.
std::unique_ptr<PassPlan> make_plan(const Settings& settings, const std::vector<Tile>& tiles);

// By Settings::goal.
std::unique_ptr<PassPlan> make_fixed_plan(const Settings& settings, const std::vector<Tile>& tiles);
std::unique_ptr<PassPlan> make_adaptive_plan(const Settings& settings,
                                             const std::vector<Tile>& tiles);
std::unique_ptr<PassPlan> make_guarantee_plan(const Settings& settings,
                                              const std::vector<Tile>& tiles);

}  // namespace cobble::renderer
