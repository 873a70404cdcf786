// SPDX-License-Identifier: MIT
#include "renderer/intersect/instruction_set.hpp"

#include <hwy/highway.h>

#include <cstdint>

namespace cobble::renderer {

namespace {

std::string name_of(std::int64_t target) {
    std::string name = hwy::TargetName(target);
    for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return name;
}

void choose(std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

/// Whatever was chosen before.
std::vector<std::int64_t> all_targets() {
    hwy::SetSupportedTargetsForTest(0);
    return hwy::SupportedAndGeneratedTargets();
}

}  // namespace

std::vector<std::string> instruction_sets() {
    const std::int64_t chosen = hwy::SupportedTargets();
    std::vector<std::string> names;
    for (const std::int64_t target : all_targets()) names.push_back(name_of(target));
    choose(chosen);
    return names;
}

bool use_instruction_set(std::string_view name) {
    const std::int64_t before = hwy::SupportedTargets();
    for (const std::int64_t target : all_targets()) {
        if (name == name_of(target)) {
            choose(target);
            return true;
        }
    }
    choose(name.empty() ? 0 : before);
    return name.empty();
}

}  // namespace cobble::renderer
