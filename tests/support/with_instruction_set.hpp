// SPDX-License-Identifier: MIT
// One of the processor's instruction sets for the fast core, for as long as this lives.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "renderer/intersect/instruction_set.hpp"

namespace cobble::test {

/// The processor's own choice comes back whatever happens.
struct WithInstructionSet {
    explicit WithInstructionSet(const std::string& name) {
        REQUIRE(renderer::use_instruction_set(name));
    }
    WithInstructionSet(const WithInstructionSet&) = delete;
    WithInstructionSet& operator=(const WithInstructionSet&) = delete;
    ~WithInstructionSet() { renderer::use_instruction_set(""); }
};

}  // namespace cobble::test
