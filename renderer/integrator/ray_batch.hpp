// SPDX-License-Identifier: MIT
// Rays for the core, and how many of them it is handed between two looks at the clock.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/integrator/columns.hpp"
#include "renderer/intersect/batch.hpp"
#include "renderer/wide/wide.hpp"

namespace cobble::renderer {

/// At most kBatchSize rays, in stretches that go nearly alike or do not.
template <typename T>
struct RayBatch {
    struct Stretch {
        std::size_t end = 0;
        Coherence coherence = Coherence::kNone;
    };

    std::array<Ray<T>, kBatchSize>
        rays;  ///< and what they start on; those beyond `count` mean nothing
    std::array<Exclude, kBatchSize> excludes;
    /// If `in_columns` the rays are here, and maybe in `rays` too.
    Columns3<T> origin, direction;
    alignas(kColumnAlignment) T time[kBatchSize];
    bool in_columns = false;
    /// Rays in columns end, and start on something: then this counts. Else all have one origin.
    bool bounded = false;
    alignas(kColumnAlignment) T t_max[kBatchSize];
    alignas(kColumnAlignment) std::uint32_t object[kBatchSize];
    alignas(kColumnAlignment) std::uint32_t face[kBatchSize];
    alignas(kColumnAlignment) std::int32_t outward[kBatchSize];  ///< 0: goes inside
    std::size_t count = 0;
    std::vector<Stretch> stretches;  ///< one after the other; the last one ends with the rays
    std::size_t asked = 0;           ///< so many of the first have their answers

    RayBatch() { stretches.reserve(kBatchSize); }
    [[nodiscard]] std::size_t size() const { return count; }
    /// Those in columns.
    [[nodiscard]] RayColumns<T> columns() const {
        RayColumns<T> all{{origin.x, origin.y, origin.z},
                          {direction.x, direction.y, direction.z},
                          !bounded,
                          nullptr,
                          time,
                          nullptr,
                          nullptr,
                          nullptr};
        if (!bounded) return all;
        all.t_max = t_max;
        all.object = object;
        all.face = face;
        all.outward = outward;
        return all;
    }
    [[nodiscard]] Ray<T> ray(std::size_t i) const {
        return in_columns ? columns().ray(i) : rays[i];
    }
    void clear() { begin(0); }
    /// Of so many rays, which are written then.
    void begin(std::size_t of) {
        count = of;
        asked = 0;
        in_columns = false;
        stretches.clear();
    }
    /// What is left since the last stretch is one.
    void end_stretch(Coherence coherence) { end_stretch_at(size(), coherence); }
    /// The next stretch ends with ray `end` - 1; none if it is empty.
    void end_stretch_at(std::size_t end, Coherence coherence) {
        if (end == (stretches.empty() ? 0 : stretches.back().end)) return;
        const bool joins = !stretches.empty() && coherence == Coherence::kNone &&
                           stretches.back().coherence == coherence;
        if (joins) {
            stretches.back().end = end;
        } else {
            stretches.push_back({end, coherence});
        }
    }
};

/// Keeps the core's share of work between two looks at the clock short, by what rays took so far.
class Pace {
  public:
    /// closest_hits() and any_hits() of the next rays, as many as may be asked about at once, by
    /// their place in the batch; true once all are.
    template <typename T>
    bool closest(const PreparedScene<T>& scene, RayBatch<T>& batch, std::span<Hit<T>> hits,
                 Counters& counters) {
        return ask(batch, counters, [&](std::size_t at, std::size_t n, Coherence coherence) {
            if (batch.in_columns) {
                return closest_hits<T>(scene, batch.columns().from(at), hits.subspan(at, n),
                                       counters, coherence);
            }
            closest_hits<T>(scene, std::span<const Ray<T>>(batch.rays).subspan(at, n),
                            std::span<const Exclude>(batch.excludes).subspan(at, n),
                            hits.subspan(at, n), counters, coherence);
        });
    }
    template <typename T>
    bool any(const PreparedScene<T>& scene, RayBatch<T>& batch, std::span<Hit<T>> hits,
             Counters& counters) {
        return ask(batch, counters, [&](std::size_t at, std::size_t n, Coherence coherence) {
            if (batch.in_columns) {
                return any_hits<T>(scene, batch.columns().from(at), hits.subspan(at, n), counters,
                                   coherence);
            }
            any_hits<T>(scene, std::span<const Ray<T>>(batch.rays).subspan(at, n),
                        std::span<const Exclude>(batch.excludes).subspan(at, n),
                        hits.subspan(at, n), counters, coherence);
        });
    }

  private:
    template <typename T, typename Core>
    bool ask(RayBatch<T>& batch, const Counters& counters, const Core& core) {
        std::size_t stretch = 0;
        std::size_t left = at_once_;
        while (left > 0 && batch.asked < batch.size()) {
            while (batch.stretches[stretch].end <= batch.asked) ++stretch;
            const std::size_t count = std::min(batch.stretches[stretch].end - batch.asked, left);
            const std::uint64_t before = counters.tests();
            core(batch.asked, count, batch.stretches[stretch].coherence);
            batch.asked += count;
            const std::uint64_t of_one = (counters.tests() - before) / count + 1;
            at_once_ = std::clamp<std::size_t>(kTestsAtOnce / of_one, kFewestAtOnce, kBatchSize);
            left = std::min(left - count, at_once_);
        }
        return batch.asked == batch.size();
    }

    /// What the core may do between two looks: 2 ms at 10 ns a test, far below the 10 ms by which a
    /// step may overrun. One batch of an ordinary scene is a tenth of it.
    static constexpr std::uint64_t kTestsAtOnce = 200000;
    /// So many that packets are worth their name; 10 ms if each ray takes 60,000 tests.
    static constexpr std::size_t kFewestAtOnce = kFewestTogether;

    std::size_t at_once_ = kFewestAtOnce;
};

}  // namespace cobble::renderer
