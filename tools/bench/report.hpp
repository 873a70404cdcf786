// SPDX-License-Identifier: MIT
// How the benchmarks say whether a figure is what it must be.
#pragma once

#include <fmt/format.h>

#include <string>

namespace cobble::bench {

/// What a figure must reach; an empty text if nothing is asked of it.
struct Limit {
    enum class Kind { kNone, kAtLeast, kAtMost };
    Kind kind = Kind::kNone;
    double value = 0;

    /// "must be >= 200: yes", or "... : NO" so that it catches the eye.
    [[nodiscard]] std::string verdict(double measured) const {
        if (kind == Kind::kNone) return {};
        const bool at_least = kind == Kind::kAtLeast;
        const bool holds = at_least ? measured >= value : measured <= value;
        return fmt::format("must be {} {:g}: {}", at_least ? ">=" : "<=", value,
                           holds ? "yes" : "NO");
    }
};

constexpr Limit at_least(double value) { return {Limit::Kind::kAtLeast, value}; }
constexpr Limit at_most(double value) { return {Limit::Kind::kAtMost, value}; }

}  // namespace cobble::bench
