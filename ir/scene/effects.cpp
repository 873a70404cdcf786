// SPDX-License-Identifier: MIT
#include "ir/scene/effects.hpp"

namespace cobble::ir {
namespace {

struct Row {
    std::string_view name;
    std::string_view doc;
};
constexpr std::array<Row, kEffectCount> kRows{{
#define COBBLE_EFFECT(id, name, doc) {name, doc},
    COBBLE_EFFECTS(COBBLE_EFFECT)
#undef COBBLE_EFFECT
}};

}  // namespace

std::string_view name_of(Effect effect) { return kRows[static_cast<std::size_t>(effect)].name; }

std::string_view description_of(Effect effect) {
    return kRows[static_cast<std::size_t>(effect)].doc;
}

}  // namespace cobble::ir
