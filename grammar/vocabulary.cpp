// SPDX-License-Identifier: MIT
#include "grammar/vocabulary.hpp"

#include <utility>

namespace cobble::grammar {
namespace {

// The small language of vocabulary.def.
constexpr BlockMask in_file() { return kFileMask; }
constexpr BlockMask in_lights() { return mask_of(BlockId::kLights); }
constexpr BlockMask in_materials() { return mask_of(BlockId::kMaterials); }
constexpr BlockMask in_material() {
    return mask_of(BlockId::kMaterial) | mask_of(BlockId::kPhongMaterial);
}
constexpr BlockMask in_group() { return mask_of(BlockId::kGroup); }
constexpr BlockMask in_transform() { return mask_of(BlockId::kTransform); }
constexpr BlockMask in_motion() { return mask_of(BlockId::kMotion); }

constexpr Range any() { return {}; }
constexpr Range at_least(double low) { return {.low = low}; }
constexpr Range above(double low) { return {.low = low, .low_open = true}; }
constexpr Range between(double low, double high) { return {.low = low, .high = high}; }
constexpr Range between_open(double low, double high) {
    return {.low = low, .high = high, .low_open = true, .high_open = true};
}
constexpr Range nonzero() { return {.zero_excluded = true}; }
constexpr Range unit_color() { return between(0, 1); }
constexpr Range light_color() { return {.low = 0, .warn_above = 1}; }

constexpr BlockRow kBlocks[] = {
#define COBBLE_BLOCK(id, role, layout, parents, labelled, doc) \
    {BlockId::k##id, #id, Role::role, Layout::layout, parents, labelled, doc},
#include "grammar/vocabulary.def"
};

constexpr FieldRow kFields[] = {
#define COBBLE_FIELD(block, id, type, range, unit, fallback, presence, repeat, doc)            \
    {FieldId::k##block##_##id, BlockId::k##block, #id, ValueType::type, range, unit, fallback, \
     Presence::presence,       Repeat::repeat,    doc},
#include "grammar/vocabulary.def"
};

static_assert(std::size(kBlocks) == kBlockCount);
static_assert(std::size(kFields) == kFieldCount);

// Fields of one block are neighbours in the table: {first, count} per block.
constexpr auto kFieldRanges = [] {
    std::array<std::pair<std::size_t, std::size_t>, kBlockCount> ranges{};
    for (std::size_t i = 0; i < kFieldCount; ++i) {
        auto& [first, count] = ranges[static_cast<std::size_t>(kFields[i].block)];
        if (count == 0) first = i;
        ++count;
    }
    return ranges;
}();

}  // namespace

std::span<const BlockRow> blocks() { return kBlocks; }
std::span<const FieldRow> fields() { return kFields; }

const BlockRow& row(BlockId id) { return kBlocks[static_cast<std::size_t>(id)]; }
const FieldRow& row(FieldId id) { return kFields[static_cast<std::size_t>(id)]; }

std::span<const FieldRow> fields_of(BlockId id) {
    const auto [first, count] = kFieldRanges[static_cast<std::size_t>(id)];
    return std::span<const FieldRow>(kFields).subspan(first, count);
}

int arity(ValueType type) {
    switch (type) {
        case ValueType::kVector2:
            return 2;
        case ValueType::kVector3:
        case ValueType::kColor:
            return 3;
        case ValueType::kNumbers4:
            return 4;
        case ValueType::kNumbers16:
            return 16;
        default:
            return 1;
    }
}

bool is_word(ValueType type) {
    return type == ValueType::kImagePath || type == ValueType::kFolderPath ||
           type == ValueType::kMeshPath || type == ValueType::kTextureFilter;
}

}  // namespace cobble::grammar
