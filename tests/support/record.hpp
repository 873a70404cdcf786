// SPDX-License-Identifier: MIT
// What the tests of hard cases measured, for the page that shows it.
#pragma once

#include <cstdint>
#include <string>

namespace cobble::test {

/// Appends "ROW<tab>TEXT" to the file that COBBLE_HARD_RESULTS names; without it nothing happens.
/// The text is part of a table: "0 of 1,000 rays lost, float".
void record(int row, const std::string& text);

/// With commas between thousands.
std::string counted(std::int64_t n);
/// Two digits: "0.43", "7.1e-12".
std::string brief(double x);

template <typename T>
constexpr const char* name_of_type() {
    return sizeof(T) == sizeof(float) ? "float" : "double";
}

}  // namespace cobble::test
