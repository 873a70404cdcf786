// SPDX-License-Identifier: MIT
#include <algorithm>

#include "renderer/estimate/summary.hpp"
#include "renderer/passes/adaptive_forecast.hpp"
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
          light_(settings.shown_as_srgb),
          pilot_(settings.goal->method == ErrorGoal::Method::kUnbiased),
          window_(window_of(settings)),
          tiles_(tiles),
          active_(window_, false) {
        for (const Tile& tile : tiles_) {
            pixels_ += tile.pixels();
            each_pixel(tile, [this](std::size_t i) { active_.bytes()[i] = 1; });
        }
        level_.assign(active_.bytes().size(), 0);
        width_.assign(active_.bytes().size(), -1);
        expected_ = static_cast<double>(pixels_) * kFewestSamples;
    }

    std::uint32_t due(const Film& film) override {
        if (final_ || scramble_ < kScrambles || looked_ == Looked::kWhole) return 0;
        if (looked_ == Looked::kNot) {
            intervals_.emplace(*film.sums(), active_, window_.x1 - window_.x0, light_);
            looked_ = Looked::kEstimates;
            return intervals_->rows();
        }
        if (looked_ == Looked::kEstimates) {
            now_.assign(active_.bytes().size(), -1);
            looked_ = Looked::kWidths;
            return intervals_->rows();
        }
        looked_ = Looked::kWhole;
        return 0;
    }

    void work_out(std::uint32_t part) override {
        if (looked_ == Looked::kEstimates) return intervals_->estimate_row(part);
        const std::size_t width = window_.x1 - window_.x0;
        for (std::size_t i = part * width; i < (part + 1) * width; ++i) {
            if (active_.bytes()[i] == 0) continue;
            now_[i] = static_cast<float>(intervals_->half_width(i, std::max(round_, 1U)));
        }
    }

    std::optional<Pass> next(Film& film, double seconds) override {
        if (film.sums() == nullptr) film.begin_sums(kScrambles);
        look_at_the_clock(seconds);
        if (!final_ && scramble_ == kScrambles && !begin_round(*film.sums(), seconds)) {
            if (!pilot_) return std::nullopt;
            begin_final(film);
        }
        return final_ ? next_final() : next_of_round(seconds);
    }

    [[nodiscard]] std::uint64_t expected_samples() const override {
        return static_cast<std::uint64_t>(expected_ * (pilot_ ? 2 : 1));
    }
    [[nodiscard]] std::optional<Forecast> forecast() const override {
        std::optional<Forecast> forecast = forecast_.forecast();
        // All of a pilot's samples are taken again.
        if (forecast && pilot_) forecast->seconds *= 2;
        return forecast;
    }
    [[nodiscard]] std::optional<Achieved> achieved() const override { return achieved_; }

    [[nodiscard]] std::vector<std::uint8_t> bytes() const override {
        PlanWriter writer;
        writer.put(final_);
        writer.put(round_);
        writer.put(final_ ? final_level_ - 1 : scramble_ - 1);
        writer.put(expected_);
        writer.put(taken_ - pass_samples_);
        writer.put(forecast_);
        writer.put(achieved_.has_value());
        writer.put(achieved_.value_or(Achieved{}));
        writer.put_all(level_.data(), level_.size());
        writer.put_all(width_.data(), width_.size());
        return writer.take();
    }

    [[nodiscard]] bool restore(const std::vector<std::uint8_t>& bytes) override {
        PlanReader reader(bytes);
        bool has_achieved = false;
        std::uint32_t at = 0;
        Achieved achieved;
        const bool read = reader.get(final_) && reader.get(round_) && reader.get(at) &&
                          reader.get(expected_) && reader.get(taken_) && reader.get(forecast_) &&
                          reader.get(has_achieved) && reader.get(achieved) &&
                          reader.get_all(level_.data(), level_.size()) &&
                          reader.get_all(width_.data(), width_.size()) && reader.at_end();
        if (!read || round_ > kMostLooks || at > (final_ ? round_ : kScrambles - 1)) return false;
        (final_ ? final_level_ : scramble_) = at;
        begun_elsewhere_ = true;
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

    [[nodiscard]] Pass next_of_round(double seconds) {
        Pass pass;
        pass.scramble = scramble_++;
        pass.samples.seed = scramble_seed(seed_, pass.scramble);
        pass.samples.salts = salts_;
        pass.samples.first = round_ == 0 ? 0 : scramble_samples(round_ - 1, goal_.most_samples);
        pass.samples.count = scramble_samples(round_, goal_.most_samples) - pass.samples.first;
        pass.samples.active = &active_;
        pass_start_ = begun_elsewhere_ ? -1 : seconds;
        begun_elsewhere_ = false;
        pass_samples_ = static_cast<double>(active_.count()) * pass.samples.count;
        taken_ += pass_samples_;
        return pass;
    }

    /// Once the second pass over the pixels of round 2 is over: they are no easy ones, and before
    /// the first there was a look.
    void look_at_the_clock(double seconds) {
        if (round_ < 2 || scramble_ < 2 || final_ || pass_start_ < 0 || forecast_.forecast())
            return;
        forecast_.set_costs(seconds, taken_, seconds - pass_start_, pass_samples_);
    }

    /// After a round: false if no other is needed.
    bool begin_round(const ScrambleSums& sums, double seconds) {
        looked_ = Looked::kNot;
        intervals_.reset();
        scramble_ = 0;
        if (round_ == 0) {
            width_ = now_;
            round_ = 1;
            return true;
        }
        const bool more = round_ < kMostLooks && scramble_samples(round_ + 1, goal_.most_samples) >
                                                     scramble_samples(round_, goal_.most_samples);
        if (round_ == 1) {
            forecast_.set_widths(width_, now_, goal_);
            expected_ = forecast_.samples();
        }
        for (std::size_t i = 0; i < level_.size(); ++i) {
            if (active_.bytes()[i] == 0) continue;
            if (more && now_[i] > goal_.error) continue;
            level_[i] = static_cast<std::uint8_t>(round_);
            width_[i] = now_[i];
            active_.bytes()[i] = 0;
        }
        if (active_.count() == 0) {
            if (!forecast_.forecast()) forecast_.set_costs(seconds);
            conclude(sums);
            return false;
        }
        ++round_;
        return true;
    }

    void conclude(const ScrambleSums& sums) {
        const auto half_width = [this](std::size_t i) { return width_[i]; };
        achieved_ = summarise(sums, half_width, light_);
        for (const float width : width_) {
            if (width > goal_.error) ++achieved_->beyond_goal;
        }
        achieved_->forecast = forecast();
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
    bool light_;
    bool pilot_;
    Crop window_;
    std::vector<Tile> tiles_;
    PixelMask active_;
    std::uint64_t pixels_ = 0;
    std::vector<std::uint8_t> level_;  ///< the round after which a pixel was done; 0: it is not
    std::vector<float> width_;  ///< half of its interval's then; after round 0, of all pixels
    std::uint32_t round_ = 0;
    std::uint32_t scramble_ = 0;  ///< the next one of the round
    bool final_ = false;
    std::uint32_t final_level_ = 0;
    double expected_ = 0;  ///< samples of all rounds
    double taken_ = 0;     ///< of these, those of the passes that were begun
    // Of the pass that goes on.
    double pass_samples_ = 0;
    double pass_start_ = -1;  ///< seconds; below 0: another program began it
    bool begun_elsewhere_ = false;
    AdaptiveForecast forecast_;
    // The look after a round.
    enum class Looked : std::uint8_t { kNot, kEstimates, kWidths, kWhole };
    Looked looked_ = Looked::kNot;  ///< what is worked out, or is being worked out
    std::optional<Intervals> intervals_;
    std::vector<float> now_;  ///< half widths of the pixels that are not done; else below 0
    std::optional<Achieved> achieved_;
};

}  // namespace

std::unique_ptr<PassPlan> make_adaptive_plan(const Settings& settings,
                                             const std::vector<Tile>& tiles) {
    return std::make_unique<AdaptivePlan>(settings, tiles);
}

}  // namespace cobble::renderer
