// SPDX-License-Identifier: MIT
#include "tests/support/corpus.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <stdexcept>

namespace cobble::test {

std::filesystem::path corpus() {
    const char* named = std::getenv("COBBLE_CORPUS");
    const std::filesystem::path folder = named != nullptr ? named : COBBLE_ROOT "/../shared/corpus";
    std::error_code error;
    if (std::filesystem::is_directory(folder, error)) return folder;
    if (named == nullptr) return {};
    throw std::runtime_error("COBBLE_CORPUS names no folder: " + folder.string());
}

std::filesystem::path corpus_or_skip() {
    std::filesystem::path folder = corpus();
    // tests/CMakeLists.txt looks for the first three words.
    if (folder.empty()) {
        MESSAGE("skipped: no corpus here; set COBBLE_CORPUS to the folder of published scenes");
    }
    return folder;
}

}  // namespace cobble::test
