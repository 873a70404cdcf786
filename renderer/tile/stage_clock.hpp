// SPDX-License-Identifier: MIT
// Where the time of a render goes, stage by stage.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace cobble::renderer {

/// COBBLE_STAGE(id, name, what): in the order of a ray's life.
#define COBBLE_TIMED_STAGES(COBBLE_STAGE)                                                \
    COBBLE_STAGE(kCamera, "camera", "where rays start, and when")                        \
    COBBLE_STAGE(kHits, "hits", "what rays meet")                                        \
    COBBLE_STAGE(kSurfaces, "surfaces", "what it looks like: places, normals, textures") \
    COBBLE_STAGE(kLights, "lights", "what arrives there if nothing is in the way")       \
    COBBLE_STAGE(kShadows, "shadows", "whether something is")                            \
    COBBLE_STAGE(kColors, "colours", "what is seen of both, and where nothing is met")   \
    COBBLE_STAGE(kOnward, "onward", "reflected and refracted rays, sorted")              \
    COBBLE_STAGE(kPixels, "pixels", "sums of samples")                                   \
    COBBLE_STAGE(kErrors, "errors", "between rounds: which pixels need more samples")    \
    COBBLE_STAGE(kRayByRay, "ray by ray", "all of it, of the reference and old programs")

enum class TimedStage : std::uint8_t {
#define COBBLE_STAGE(id, name, what) id,
    COBBLE_TIMED_STAGES(COBBLE_STAGE)
#undef COBBLE_STAGE
        kCount_
};
inline constexpr std::size_t kTimedStages = static_cast<std::size_t>(TimedStage::kCount_);

std::string_view name_of(TimedStage stage);
/// What is done in it, a few words.
std::string_view words_for(TimedStage stage);

/// Seconds of each stage, of all workers together: nothing of it is counted twice or left out, so
/// that they add up to the time of the workers less what they waited.
struct StageTimes {
    std::array<double, kTimedStages> seconds{};

    [[nodiscard]] double sum() const;
    StageTimes& operator+=(const StageTimes& other);
};

/// Of one tile on its way. Off, it costs a branch a stage; on, a look at the clock, some 25 ns for
/// a stage of a batch, which takes microseconds.
class StageClock {
  public:
    explicit StageClock(bool on) : on_(on) {}

    /// Time counts for `stage` from here on.
    void enter(TimedStage stage) {
        if (!on_) return;
        const Clock::time_point now = Clock::now();
        credit(now);
        stage_ = stage;
    }
    /// A worker takes the tile up, in the stage in which it was put down, or puts it down.
    void go_on() {
        if (on_) since_ = Clock::now();
    }
    void pause() {
        if (on_) credit(Clock::now());
    }

    [[nodiscard]] const StageTimes& times() const { return times_; }

  private:
    using Clock = std::chrono::steady_clock;

    void credit(Clock::time_point now) {
        times_.seconds[static_cast<std::size_t>(stage_)] +=
            std::chrono::duration<double>(now - since_).count();
        since_ = now;
    }

    bool on_;
    TimedStage stage_ = TimedStage::kCamera;
    Clock::time_point since_;
    StageTimes times_;
};

}  // namespace cobble::renderer
