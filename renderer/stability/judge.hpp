// SPDX-License-Identifier: MIT
// Whether what float sees along a ray is explained by rounding. Private to this folder.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ir/scene/scene.hpp"
#include "renderer/scene/prepared_scene.hpp"
#include "renderer/stability/seen.hpp"
#include "renderer/tile/stats.hpp"

namespace cobble::renderer {

enum class FloatVerdict : std::uint8_t {
    kRight,
    kCrack,    ///< it sees through, to something behind or to nothing
    kChanged,  ///< it sees what is not there
    kUnknown,  ///< beyond the numbers that can be compared
};

/// What exact arithmetic says where float and double name different primitives.
enum class ExactVerdict : std::uint8_t {
    kOpen,    ///< too close to call
    kDouble,  ///< double's is met first
    kFloat,   ///< float's is
    kBoth,    ///< they are met at one place
};

/// What double sees around a ray, looked at only where float and double differ.
struct Surroundings {
    Seen<double> middle;
    double bound = 0;                ///< world units: how far off a float hit may be
    std::vector<Seen<double>> seen;  ///< empty until asked for
};

class FloatJudge {
  public:
    /// The scene and what was prepared of it in double must outlive this.
    FloatJudge(const ir::Scene& source, const PreparedScene<double>& wide)
        : source_(source), wide_(wide) {}

    /// `around.middle` is what double sees along the same ray; fills in the bound.
    FloatVerdict judge(const Seen<float>& narrow, Surroundings& around);

    /// A ray that left the float hit in `around`, on the side `side` of its surface, met something
    /// at `again`: true if that is the surface that it started on, within the bounds, and no ray
    /// that leaves what double sees meets anything so near.
    bool is_self_hit(const Seen<float>& narrow, math::Vec3d side, const Seen<float>& again,
                     Surroundings& around);

    /// Who is right about which primitive is met first.
    [[nodiscard]] ExactVerdict settle(const Seen<float>& narrow, const Seen<double>& wide) const;

  private:
    template <typename T>
    [[nodiscard]] double bound_of(const Seen<T>& seen) const;
    const std::vector<Seen<double>>& seen_around(Surroundings& around);
    std::optional<Seen<double>> surface_behind(const Seen<float>& narrow,
                                               const Surroundings& around);
    void look(Seen<double>& seen);

    const ir::Scene& source_;
    const PreparedScene<double>& wide_;
    Counters counters_;
};

}  // namespace cobble::renderer
