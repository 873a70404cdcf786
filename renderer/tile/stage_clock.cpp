// SPDX-License-Identifier: MIT
#include "renderer/tile/stage_clock.hpp"

#include <numeric>

namespace cobble::renderer {

std::string_view name_of(TimedStage stage) {
    static constexpr std::string_view kNames[] = {
#define COBBLE_STAGE(id, name, what) name,
        COBBLE_TIMED_STAGES(COBBLE_STAGE)
#undef COBBLE_STAGE
    };
    return kNames[static_cast<std::size_t>(stage)];
}

std::string_view words_for(TimedStage stage) {
    static constexpr std::string_view kWords[] = {
#define COBBLE_STAGE(id, name, what) what,
        COBBLE_TIMED_STAGES(COBBLE_STAGE)
#undef COBBLE_STAGE
    };
    return kWords[static_cast<std::size_t>(stage)];
}

double StageTimes::sum() const { return std::accumulate(seconds.begin(), seconds.end(), 0.0); }

StageTimes& StageTimes::operator+=(const StageTimes& other) {
    for (std::size_t i = 0; i < kTimedStages; ++i) seconds[i] += other.seconds[i];
    return *this;
}

}  // namespace cobble::renderer
