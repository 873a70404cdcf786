// SPDX-License-Identifier: MIT
// What was measured, as a table while it comes in, or as JSON at the end.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cobble::bench {

/// One core's figures for one set of rays; rates are in millions of rays a second.
struct CoreResult {
    std::string core;
    unsigned threads = 1;
    std::size_t passes = 0;
    double rate = 0;            ///< median
    double slow = 0, fast = 0;  ///< quartiles
    /// How many times as fast as another core with as many threads (median of passes), by its name.
    std::vector<std::pair<std::string, double>> ratios;
    /// Wall time of one thread over this, where both were measured.
    std::optional<double> scaling;
};

struct PeerCheck {
    std::uint64_t hits = 0, distances = 0;
};

struct KindResult {
    std::string kind;
    std::size_t rays = 0;
    double hit_share = 0;
    std::uint64_t differences = 0;           ///< fast core against reference
    std::optional<PeerCheck> disagreements;  ///< Embree against reference
    std::vector<CoreResult> cores;
};

struct BuildResult {
    std::string core;
    unsigned threads = 1;
    double seconds = 0;  ///< median
    std::size_t primitives = 0;
    std::uint64_t bytes = 0;
    std::optional<double> ratio;  ///< Embree's robust time with as many threads over this
};

class Report {
  public:
    explicit Report(bool json) : json_(json) {}

    void begin();
    void begin_input(const std::string& name, const std::string& title, const std::string& scalar);
    void add(const KindResult& result);
    void add(const std::vector<BuildResult>& builds);
    void end();

  private:
    bool json_;
    nlohmann::json all_;
};

}  // namespace cobble::bench
