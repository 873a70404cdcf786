// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "ir/math/elementary.hpp"
#include "renderer/estimate/summary.hpp"
#include "renderer/passes/adaptive_rounds.hpp"
#include "renderer/passes/pass_plan.hpp"
#include "renderer/passes/plan_bytes.hpp"

namespace cobble::renderer {
namespace {

/// Rounds of doubling samples over the pixels that are not done. For an unbiased picture the rounds
/// are a pilot: they say how many samples each pixel is to have, and then it is made of others.
class AdaptivePlan final : public PassPlan {
  public:
    AdaptivePlan(const Settings& settings, const std::vector<Tile>& tiles)
        : seed_(settings.seed),
          salts_(settings.salts),
          goal_(*settings.goal),
          pilot_(settings.goal->method == ErrorGoal::Method::kUnbiased),
          window_(window_of(settings)),
          tiles_(tiles),
          active_(window_, false) {
        for (const Tile& tile : tiles_) {
            pixels_ += tile.pixels();
            each_pixel(tile, [this](std::size_t i) { active_.bytes()[i] = 1; });
        }
        level_.assign(active_.bytes().size(), 0);
        width_.assign(active_.bytes().size(), 0);
        expected_ = static_cast<double>(pixels_) * kFewestSamples * (pilot_ ? 2 : 1);
    }

    std::optional<Pass> next(Film& film, const PassCosts& costs) override {
        if (film.sums() == nullptr) film.begin_sums(kScrambles);
        if (!final_ && scramble_ == kScrambles && !begin_round(film, costs)) {
            if (!pilot_) return std::nullopt;
            begin_final(film);
        }
        return final_ ? next_final() : next_of_round();
    }

    [[nodiscard]] std::uint64_t expected_samples() const override {
        return static_cast<std::uint64_t>(expected_);
    }
    [[nodiscard]] std::optional<Forecast> forecast() const override { return forecast_; }
    [[nodiscard]] std::optional<Achieved> achieved() const override { return achieved_; }

    [[nodiscard]] std::vector<std::uint8_t> bytes() const override {
        PlanWriter writer;
        writer.put(final_);
        writer.put(round_);
        writer.put(final_ ? final_level_ - 1 : scramble_ - 1);
        writer.put(first_mean_square_);
        writer.put(expected_);
        writer.put(forecast_.has_value());
        writer.put(forecast_.value_or(Forecast{}));
        writer.put(achieved_.has_value());
        writer.put(achieved_.value_or(Achieved{}));
        writer.put_all(level_.data(), level_.size());
        writer.put_all(width_.data(), width_.size());
        return writer.take();
    }

    [[nodiscard]] bool restore(const std::vector<std::uint8_t>& bytes) override {
        PlanReader reader(bytes);
        bool has_forecast = false;
        bool has_achieved = false;
        std::uint32_t at = 0;
        Forecast forecast;
        Achieved achieved;
        const bool read = reader.get(final_) && reader.get(round_) && reader.get(at) &&
                          reader.get(first_mean_square_) && reader.get(expected_) &&
                          reader.get(has_forecast) && reader.get(forecast) &&
                          reader.get(has_achieved) && reader.get(achieved) &&
                          reader.get_all(level_.data(), level_.size()) &&
                          reader.get_all(width_.data(), width_.size()) && reader.at_end();
        if (!read || at > kMostLooks || round_ > kMostLooks) return false;
        (final_ ? final_level_ : scramble_) = at;
        if (has_forecast) forecast_ = forecast;
        if (has_achieved) achieved_ = achieved;
        for (const Tile& tile : tiles_) {
            each_pixel(tile,
                       [this](std::size_t i) { active_.bytes()[i] = level_[i] == 0 ? 1 : 0; });
        }
        return true;
    }

  private:
    template <typename Visit>
    void each_pixel(const Tile& tile, const Visit& visit) const {
        for (std::uint32_t y = tile.y0; y < tile.y1; ++y) {
            for (std::uint32_t x = tile.x0; x < tile.x1; ++x) visit(active_.index_of(x, y));
        }
    }

    [[nodiscard]] Pass next_of_round() {
        Pass pass;
        pass.scramble = scramble_++;
        pass.samples.seed = scramble_seed(seed_, pass.scramble);
        pass.samples.salts = salts_;
        pass.samples.first = round_ == 0 ? 0 : scramble_samples(round_ - 1, goal_.most_samples);
        pass.samples.count = scramble_samples(round_, goal_.most_samples) - pass.samples.first;
        pass.samples.active = &active_;
        return pass;
    }

    /// After a round: false if no other is needed.
    bool begin_round(const Film& film, const PassCosts& costs) {
        scramble_ = 0;
        const Intervals intervals(*film.sums(), window_.x1 - window_.x0, goal_.shown_as_srgb);
        if (round_ == 0) {
            first_mean_square_ = intervals.mean_square();
            round_ = 1;
            return true;
        }
        const bool more = round_ < kMostLooks && scramble_samples(round_ + 1, goal_.most_samples) >
                                                     scramble_samples(round_, goal_.most_samples);
        if (round_ == 1) predict(intervals, costs);
        // Decided for all before any is taken out: neighbours are asked about each other.
        for (std::size_t i = 0; i < level_.size(); ++i) {
            if (active_.bytes()[i] == 0) continue;
            const double width = intervals.half_width(i, round_);
            if (more && width > goal_.error) continue;
            level_[i] = static_cast<std::uint8_t>(round_);
            width_[i] = static_cast<float>(width);
            active_.bytes()[i] = 0;
        }
        if (active_.count() == 0) {
            conclude(*film.sums());
            return false;
        }
        ++round_;
        return true;
    }

    void conclude(const ScrambleSums& sums) {
        const auto half_width = [this](std::size_t i) { return width_[i]; };
        achieved_ = summarise(sums, half_width, goal_.shown_as_srgb);
        for (const float width : width_) {
            if (width > goal_.error) ++achieved_->beyond_goal;
        }
        achieved_->forecast = forecast_;
    }

    /// What the rest will take if errors go on falling as they fell from round 0 to round 1.
    void predict(const Intervals& intervals, const PassCosts& costs) {
        const double now = intervals.mean_square();
        // Of the error, in powers of the samples: 1/2 is plain chance, 3/2 the best of smooth ones.
        const double slope =
            now > 0 && first_mean_square_ > 0
                ? std::clamp(math::log(first_mean_square_ / now) / math::log(2) / 2, 0.5, 1.5)
                : 0.5;
        const double factor = math::exp(-slope * math::log(2));
        double samples = 0;
        double tile_seconds = 0;
        double expected_seconds = 0;
        for (std::size_t t = 0; t < tiles_.size(); ++t) {
            double of_tile = 0;
            each_pixel(tiles_[t],
                       [&](std::size_t i) { of_tile += expected_of(intervals, i, factor); });
            samples += of_tile;
            const double seconds = costs.tile_seconds[t];
            tile_seconds += seconds;
            const auto taken = static_cast<double>(tiles_[t].pixels() * kFewestSamples);
            expected_seconds += seconds * ((pilot_ ? 2 : 1) * of_tile / taken);
        }
        expected_ = samples * (pilot_ ? 2 : 1);
        Forecast forecast;
        forecast.samples = samples / static_cast<double>(std::max<std::uint64_t>(pixels_, 1));
        if (tile_seconds > 0) {
            forecast.seconds = costs.wall_seconds * expected_seconds / tile_seconds;
        }
        forecast_ = forecast;
    }

    /// Samples of a pixel, at the first look, if its error falls by `factor` from look to look.
    [[nodiscard]] double expected_of(const Intervals& intervals, std::size_t pixel,
                                     double factor) const {
        double width = intervals.half_width(pixel, 1);
        std::uint32_t round = 1;
        while (width > goal_.error && round < kMostLooks &&
               scramble_samples(round + 1, goal_.most_samples) >
                   scramble_samples(round, goal_.most_samples)) {
            width *=
                factor * intervals.standard_errors(round + 1) / intervals.standard_errors(round);
            ++round;
        }
        return static_cast<double>(scramble_samples(round, goal_.most_samples)) * kScrambles;
    }

    void begin_final(Film& film) {
        final_ = true;
        film.begin_sums(1);
        final_level_ = 1;
    }

    /// The pixels of the next level, with all their samples in one scramble.
    std::optional<Pass> next_final() {
        for (; final_level_ <= round_; ++final_level_) {
            bool any = false;
            for (std::size_t i = 0; i < level_.size(); ++i) {
                active_.bytes()[i] = level_[i] == final_level_ ? 1 : 0;
                any = any || level_[i] == final_level_;
            }
            if (!any) continue;
            Pass pass;
            pass.samples.seed = seed_;
            pass.samples.salts = salts_;
            pass.samples.count = scramble_samples(final_level_++, goal_.most_samples) * kScrambles;
            pass.samples.active = &active_;
            return pass;
        }
        return std::nullopt;
    }

    std::uint64_t seed_, salts_;
    ErrorGoal goal_;
    bool pilot_;
    Crop window_;
    std::vector<Tile> tiles_;
    PixelMask active_;
    std::uint64_t pixels_ = 0;
    std::vector<std::uint8_t> level_;  ///< the round after which a pixel was done; 0: it is not
    std::vector<float> width_;         ///< half of its interval's then
    std::uint32_t round_ = 0;
    std::uint32_t scramble_ = 0;  ///< the next one of the round
    bool final_ = false;
    std::uint32_t final_level_ = 0;
    double first_mean_square_ = 0;
    double expected_ = 0;
    std::optional<Forecast> forecast_;
    std::optional<Achieved> achieved_;
};

}  // namespace

std::unique_ptr<PassPlan> make_adaptive_plan(const Settings& settings,
                                             const std::vector<Tile>& tiles) {
    return std::make_unique<AdaptivePlan>(settings, tiles);
}

}  // namespace cobble::renderer
