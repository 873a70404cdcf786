// SPDX-License-Identifier: MIT
// SHA-256 (FIPS 180-4) of a stream of bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace cobble::ir {

class Sha256 {
  public:
    using Digest = std::array<std::uint8_t, 32>;

    void add(const void* data, std::size_t size);
    /// The digest of everything added; the object is used up.
    Digest finish();

  private:
    void block(const std::uint8_t* bytes);

    // The fractional parts of the square roots of the first eight primes.
    std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                        0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    std::array<std::uint8_t, 64> buffer_{};
    std::size_t buffered_ = 0;
    std::uint64_t total_ = 0;
};

/// 64 lower-case hex digits.
std::string to_hex(const Sha256::Digest& digest);

}  // namespace cobble::ir
