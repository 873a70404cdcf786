// SPDX-License-Identifier: MIT
// Which of the processor's instruction sets the fast core uses. Answers do not depend on it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cobble::renderer {

/// Those that this build has kernels for and this processor can run, the best first, in lower case:
/// "avx3" (AVX-512), "avx2", "sse4", "scalar".
std::vector<std::string> instruction_sets();

/// From now on, in all threads, the one with this name; the best one if the name is empty. False,
/// and nothing changes, if there is none. For tests and benchmarks; not while rays are traced.
bool use_instruction_set(std::string_view name);

}  // namespace cobble::renderer
