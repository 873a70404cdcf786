// SPDX-License-Identifier: MIT
#include "renderer/tile/counters.hpp"

namespace cobble::renderer {

Counters& Counters::operator+=(const Counters& other) {
    for (const auto counter : kCounters) this->*counter += other.*counter;
    return *this;
}

}  // namespace cobble::renderer
