// SPDX-License-Identifier: MIT
// The words of the language as tables: what may stand where, what its values are, what it means.
//
// Input: grammar/vocabulary.def. Everything here is constant data; look-ups cost one hash probe.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

namespace cobble::grammar {

/// What a block is for.
enum class Role : std::uint8_t {
    kCamera,
    kSection,  ///< Lights, Background, Materials
    kLight,
    kMaterial,
    kNoise,
    kGroup,
    kMaterialIndex,
    kObject,     ///< Sphere, Plane, Triangle, TriangleMesh, Box
    kTransform,  ///< the Transform block
    kMove,       ///< Translate, Scale, ... inside it
    kMotion,
};

/// How a block's content is written.
enum class Layout : std::uint8_t {
    kFields,      ///< `Name { field values ... }`, any order
    kList,        ///< `Name { field values ... child child ... }`, the order of children is meaning
    kPositional,  ///< `Name { 1 2 3 ... }`, bare numbers
    kInline,      ///< `Name 1 2 3`, no braces
};

/// What is written after a field's name.
enum class ValueType : std::uint8_t {
    kNumber,
    kInteger,
    kCount,  ///< an integer that must equal the number of children
    kVector2,
    kVector3,
    kColor,  ///< three numbers, or #rrggbb
    kNumbers4,
    kNumbers16,
    kImagePath,
    kFolderPath,
    kMeshPath,
    kMaterialRef,    ///< number or label of a material
    kTextureFilter,  ///< nearest | bilinear
};

enum class Presence : std::uint8_t { kRequired, kExpected, kOptional };
enum class Repeat : std::uint8_t { kOnce, kLastWins, kTwice };

/// Allowed numbers, per component. `warn_above` is where a value is odd but meant (a light brighter
/// than 1).
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_open = false;
    bool high_open = false;
    bool zero_excluded = false;
    double warn_above = std::numeric_limits<double>::infinity();
};

enum class BlockId : std::uint8_t {
#define COBBLE_BLOCK(id, role, layout, parents, labelled, doc) k##id,
#include "grammar/vocabulary.def"
    kCount_,
};
inline constexpr std::size_t kBlockCount = static_cast<std::size_t>(BlockId::kCount_);

/// Index into fields(): one row per (block, field) pair.
enum class FieldId : std::uint8_t {
#define COBBLE_FIELD(block, id, type, range, unit, fallback, presence, repeat, doc) k##block##_##id,
#include "grammar/vocabulary.def"
    kCount_,
};
inline constexpr std::size_t kFieldCount = static_cast<std::size_t>(FieldId::kCount_);

/// A set of blocks; bit kBlockCount stands for the top level of the file.
using BlockMask = std::uint64_t;
static_assert(kBlockCount < 63);
constexpr BlockMask mask_of(BlockId id) { return BlockMask{1} << static_cast<unsigned>(id); }
inline constexpr BlockMask kFileMask = BlockMask{1} << kBlockCount;

struct FieldRow {
    FieldId id;
    BlockId block;
    std::string_view name;  ///< "value" for inline and positional blocks, where it is not written
    ValueType type;
    Range range;
    std::string_view unit;
    std::string_view fallback;  ///< the default as it would be written; empty: none
    Presence presence;
    Repeat repeat;
    std::string_view doc;
};

struct BlockRow {
    BlockId id;
    std::string_view name;
    Role role;
    Layout layout;
    BlockMask parents;
    bool labelled;
    std::string_view doc;
};

/// All rows, indexed by id.
std::span<const BlockRow> blocks();
std::span<const FieldRow> fields();

const BlockRow& row(BlockId id);
const FieldRow& row(FieldId id);

/// The rows of one block, in the order in which they are documented and written.
std::span<const FieldRow> fields_of(BlockId id);

/// How many numbers a value of this type has; 1 for words and paths.
int arity(ValueType type);

/// True for the types whose value is a word or a string.
bool is_word(ValueType type);

/// A word of the language: the name of a block, of fields, or of both. One probe finds it, and what
/// it means in a place is a table look-up from there.
struct WordId {
    std::uint8_t value = 0xff;
    [[nodiscard]] constexpr bool valid() const { return value != 0xff; }
    friend constexpr auto operator<=>(WordId, WordId) = default;
};

/// The word of exactly this spelling, or an invalid id. "value" finds nothing.
WordId find_word(std::string_view name);

/// The block of this name, or null.
const BlockRow* block_named(WordId word);

/// The field of this name in `block`, or null.
const FieldRow* field_named(BlockId block, WordId word);

/// True if any block has a field of this name.
bool names_a_field(WordId word);

/// The block of this exact name, or null.
inline const BlockRow* find_block(std::string_view name) { return block_named(find_word(name)); }

/// The field of this exact name in `block`, or null. "value" finds nothing.
inline const FieldRow* find_field(BlockId block, std::string_view name) {
    return field_named(block, find_word(name));
}

/// True if any block has a field of this name, or it is a block's name.
inline bool is_vocabulary_name(std::string_view name) { return find_word(name).valid(); }

/// True if `child` may stand directly in `parent`.
inline bool may_stand_in(BlockId child, BlockId parent) {
    return (row(child).parents & mask_of(parent)) != 0;
}
inline bool may_stand_at_top(BlockId child) { return (row(child).parents & kFileMask) != 0; }

}  // namespace cobble::grammar
