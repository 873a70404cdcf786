// SPDX-License-Identifier: MIT
// What must not change unnoticed, written down beside its test.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace cobble::test {

/// FNV-1a, 64 bits, over the floats' bytes from the lowest.
class BitsHash {
  public:
    void add(std::span<const float> values);
    /// 16 hexadecimal digits.
    [[nodiscard]] std::string text() const;

  private:
    std::uint64_t state_ = 0xcbf29ce484222325U;
};

/// Fails, line by line, if `now` is not what the file says; `file` is a path from the project's
/// root. With COBBLE_UPDATE=1 in the environment it is written anew instead.
void check_golden(std::string_view file, const std::string& now);

}  // namespace cobble::test
