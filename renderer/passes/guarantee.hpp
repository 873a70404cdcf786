// SPDX-License-Identifier: MIT
// What a guaranteed error costs before anything is known of the picture.
#pragma once

#include <cstdint>

namespace cobble::renderer {

/// Samples that each pixel takes at least for ErrorGoal::Method::kGuarantee, a power of two.
std::uint32_t guarantee_fewest_samples(double error);

}  // namespace cobble::renderer
