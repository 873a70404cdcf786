// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "renderer/estimate/summary.hpp"
#include "renderer/passes/pass_plan.hpp"
#include "renderer/passes/plan_bytes.hpp"

namespace cobble::renderer {
namespace {

std::uint64_t pixels_of(const std::vector<Tile>& tiles) {
    std::uint64_t pixels = 0;
    for (const Tile& tile : tiles) pixels += tile.pixels();
    return pixels;
}

/// As many samples for each pixel: one pass, or one a scramble.
class FixedPlan final : public PassPlan {
  public:
    FixedPlan(const Settings& settings, const std::vector<Tile>& tiles)
        : seed_(settings.seed),
          salts_(settings.salts),
          samples_(std::max(settings.samples, 1U)),
          scrambles_(std::clamp(settings.scrambles, 1U, samples_)),
          light_(settings.shown_as_srgb),
          pixels_(pixels_of(tiles)) {}

    std::optional<Pass> next(Film& film, double /*seconds*/) override {
        if (scrambles_ > 1 && film.sums() == nullptr) film.begin_sums(scrambles_);
        if (next_ == scrambles_) {
            if (scrambles_ > 1) achieved_ = summarise(*film.sums(), {}, light_);
            return std::nullopt;
        }
        Pass pass;
        pass.scramble = next_++;
        if (scrambles_ == 1) {
            pass.samples = whole_pass(seed_, samples_);
            pass.samples.salts = salts_;
            return pass;
        }
        pass.samples.seed = scramble_seed(seed_, pass.scramble);
        pass.samples.salts = salts_;
        const std::uint32_t of = std::max(scrambles_, 1U);
        pass.samples.count = samples_ / of + (pass.scramble < samples_ % of ? 1 : 0);
        return pass;
    }

    [[nodiscard]] std::uint64_t expected_samples() const override { return pixels_ * samples_; }
    [[nodiscard]] std::optional<Achieved> achieved() const override { return achieved_; }

    [[nodiscard]] std::vector<std::uint8_t> bytes() const override {
        PlanWriter writer;
        writer.put(next_ - 1);
        return writer.take();
    }
    [[nodiscard]] bool restore(const std::vector<std::uint8_t>& bytes) override {
        PlanReader reader(bytes);
        return reader.get(next_) && reader.at_end() && next_ < scrambles_;
    }

  private:
    std::uint64_t seed_, salts_;
    std::uint32_t samples_;
    std::uint32_t scrambles_;
    bool light_;
    std::uint64_t pixels_;
    std::uint32_t next_ = 0;
    std::optional<Achieved> achieved_;
};

}  // namespace

std::unique_ptr<PassPlan> make_fixed_plan(const Settings& settings,
                                          const std::vector<Tile>& tiles) {
    return std::make_unique<FixedPlan>(settings, tiles);
}

std::unique_ptr<PassPlan> make_plan(const Settings& settings, const std::vector<Tile>& tiles) {
    if (!settings.goal) return make_fixed_plan(settings, tiles);
    return settings.goal->method == ErrorGoal::Method::kGuarantee
               ? make_guarantee_plan(settings, tiles)
               : make_adaptive_plan(settings, tiles);
}

}  // namespace cobble::renderer
