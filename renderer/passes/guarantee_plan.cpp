// SPDX-License-Identifier: MIT
#include <algorithm>

#include "renderer/estimate/bernstein.hpp"
#include "renderer/estimate/pixel_error.hpp"
#include "renderer/passes/guarantee.hpp"
#include "renderer/passes/looks.hpp"
#include "renderer/passes/pass_plan.hpp"
#include "renderer/passes/plan_bytes.hpp"

namespace cobble::renderer {
namespace {

/// Of a look, for each of three channels.
double channel_miss(std::uint32_t look) { return miss_probability(look) / 3; }

/// One independent sample of each pixel that is not done, again and again; looks at doublings.
class GuaranteePlan final : public PassPlan {
  public:
    GuaranteePlan(const Settings& settings, const std::vector<Tile>& tiles)
        : seed_(settings.seed),
          salts_(settings.salts),
          goal_(*settings.goal),
          light_(settings.shown_as_srgb),
          tiles_(tiles),
          active_(window_of(settings), false),
          next_look_(std::min(guarantee_fewest_samples(goal_.error), goal_.most_samples)) {
        for (const Tile& tile : tiles_) {
            pixels_ += tile.pixels();
            for (std::uint32_t y = tile.y0; y < tile.y1; ++y) {
                for (std::uint32_t x = tile.x0; x < tile.x1; ++x) active_.set(x, y, true);
            }
        }
        expected_ = pixels_ * next_look_;
    }

    std::optional<Pass> next(Film& film, double /*seconds*/) override {
        if (film.sums() == nullptr) film.begin_sums(1, true);
        if (samples_ == next_look_ && !look(*film.sums())) return std::nullopt;
        Pass pass;
        pass.samples.seed = seed_;
        pass.samples.salts = salts_;
        pass.samples.first = samples_++;
        pass.samples.scatter = Scatter::kRandom;
        pass.samples.active = &active_;
        return pass;
    }

    [[nodiscard]] std::uint64_t expected_samples() const override { return expected_; }
    [[nodiscard]] std::optional<Achieved> achieved() const override { return achieved_; }

    [[nodiscard]] std::vector<std::uint8_t> bytes() const override {
        PlanWriter writer;
        writer.put(samples_ - 1);
        writer.put(next_look_);
        writer.put(look_);
        writer.put(expected_);
        writer.put(widest_);
        writer.put(beyond_goal_);
        writer.put_all(active_.bytes().data(), active_.bytes().size());
        return writer.take();
    }
    [[nodiscard]] bool restore(const std::vector<std::uint8_t>& bytes) override {
        PlanReader reader(bytes);
        const bool read =
            reader.get(samples_) && reader.get(next_look_) && reader.get(look_) &&
            reader.get(expected_) && reader.get(widest_) && reader.get(beyond_goal_) &&
            reader.get_all(active_.bytes().data(), active_.bytes().size()) && reader.at_end();
        return read && samples_ < next_look_ && next_look_ <= goal_.most_samples;
    }

  private:
    [[nodiscard]] double half_width(const ScrambleSums& sums, std::size_t pixel,
                                    std::uint32_t look) const {
        const double n = sums.samples_of(pixel, 0);
        // Samples that were no numbers are missing: nothing is known of their pixel.
        if (n < 2) return 1;
        const math::Vec3d mean = sums.mean_of(pixel, 0);
        const math::Vec3d square = sums.mean_square(pixel);
        double widest = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double variance = std::max(square[c] - mean[c] * mean[c], 0.0) * (n / (n - 1));
            const double reach =
                bernstein_half_width(variance, static_cast<std::uint32_t>(n), channel_miss(look));
            widest = std::max(widest, displayed_reach(mean[c], reach, light_));
        }
        return widest;
    }

    /// False if no pixel needs more.
    bool look(const ScrambleSums& sums) {
        ++look_;
        const bool more = next_look_ < goal_.most_samples;
        for (std::size_t i = 0; i < sums.pixels(); ++i) {
            if (active_.bytes()[i] == 0) continue;
            const double width = half_width(sums, i, look_);
            if (more && width > goal_.error) continue;
            active_.bytes()[i] = 0;
            if (width > goal_.error) ++beyond_goal_;
            widest_ = std::max(widest_, width);
        }
        const std::uint64_t left = active_.count();
        if (left == 0) {
            conclude(sums);
            return false;
        }
        const std::uint32_t before = next_look_;
        next_look_ = before > goal_.most_samples / 2 ? goal_.most_samples : 2 * before;
        expected_ += left * (next_look_ - before);
        return true;
    }

    void conclude(const ScrambleSums& sums) {
        Achieved result;
        result.beyond_goal = beyond_goal_;
        double samples = 0;
        for (std::size_t i = 0; i < sums.pixels(); ++i) {
            const std::uint32_t n = sums.samples_of(i, 0);
            if (n == 0) continue;
            samples += n;
            result.fewest = result.pixels == 0 ? n : std::min(result.fewest, n);
            result.most = std::max(result.most, n);
            ++result.pixels;
        }
        result.largest = widest_;
        result.percentile_99 = widest_;
        if (result.pixels > 0) result.samples = samples / static_cast<double>(result.pixels);
        achieved_ = result;
    }

    std::uint64_t seed_, salts_;
    ErrorGoal goal_;
    bool light_;
    std::vector<Tile> tiles_;
    PixelMask active_;
    std::uint64_t pixels_ = 0;
    std::uint32_t samples_ = 0;
    std::uint32_t next_look_;
    std::uint32_t look_ = 0;
    std::uint64_t expected_ = 0;
    double widest_ = 0;
    std::uint64_t beyond_goal_ = 0;
    std::optional<Achieved> achieved_;
};

}  // namespace

std::uint32_t guarantee_fewest_samples(double error) {
    return bernstein_fewest(error, channel_miss(1));
}

std::unique_ptr<PassPlan> make_guarantee_plan(const Settings& settings,
                                              const std::vector<Tile>& tiles) {
    return std::make_unique<GuaranteePlan>(settings, tiles);
}

}  // namespace cobble::renderer
