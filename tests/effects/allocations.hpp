// SPDX-License-Identifier: MIT
// What this program has asked of the heap: bytes, by operator new in all its forms.
#pragma once

#include <cstdint>

namespace cobble::test {

std::uint64_t bytes_asked_for();

}  // namespace cobble::test
