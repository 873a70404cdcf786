// SPDX-License-Identifier: MIT
// Time of a piece of work, and of a whole program.
#pragma once

#include <chrono>
#include <ctime>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace cobble::bench {

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Of this process, in which other work on the machine does not count.
inline double processor_seconds() {
    return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

/// Processor time of the fastest of at least `least_runs` runs and of `budget` seconds of runs.
/// What `run` returns is destroyed outside the measured time.
template <typename Run>
double best_seconds(double budget, int least_runs, Run&& run) {
    double best = std::numeric_limits<double>::infinity();
    const Clock::time_point start = Clock::now();
    for (int i = 0; i < least_runs || seconds_since(start) < budget; ++i) {
        const double begin = processor_seconds();
        [[maybe_unused]] const auto built = run();
        const double took = processor_seconds() - begin;
        best = took < best ? took : best;
    }
    return best;
}

struct ProcessTime {
    double wall_seconds = 0;
    double processor_seconds = 0;
};

/// One run of a program from start to exit, what it prints thrown away; nothing if it cannot run or
/// its exit status is not 0.
std::optional<ProcessTime> run_process(const std::vector<std::string>& command);

/// A file of its own in the folder for temporary files, gone with the object.
class TemporaryFile {
  public:
    /// `ending` with its dot.
    TemporaryFile(const std::string& contents, const std::string& ending);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    [[nodiscard]] const std::string& path() const { return path_; }

  private:
    std::string path_;
};

}  // namespace cobble::bench
