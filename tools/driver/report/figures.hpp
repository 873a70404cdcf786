// SPDX-License-Identifier: MIT
// Measured numbers as people read them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cobble::driver {

/// Three significant digits, without an exponent from 0.0001 on up to a million: "0.0500", "12.3",
/// "1234". What is not finite was not measured: "-".
std::string figure(double value);

/// A share as "12.3 %"; "-" if it is not finite.
std::string percent(double share);

/// "0.0790 to 0.0835"; "-" if an end is not finite.
std::string interval(double low, double high);
std::string percent_interval(double low, double high);

/// "1 ray", "12 rays".
std::string counted(std::uint64_t count, std::string_view what);

/// "872", "1.23 M", "-12.0 k".
std::string count_figure(std::int64_t count);

}  // namespace cobble::driver
