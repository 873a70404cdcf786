// SPDX-License-Identifier: MIT
// The published scenes, meshes and pictures, which are no part of the project: tests that want them
// do without where they are not at hand.
#pragma once

#include <filesystem>

namespace cobble::test {

/// $COBBLE_CORPUS, else shared/corpus beside the project; empty if that is not there. Throws
/// std::runtime_error if COBBLE_CORPUS names no folder: a misspelt one shall not pass for none.
std::filesystem::path corpus();

/// The same for a test case that can do nothing without it, which belongs to the test suite
/// "corpus": where there is none, says so in the words by which ctest tells skipped from passed.
std::filesystem::path corpus_or_skip();

}  // namespace cobble::test
