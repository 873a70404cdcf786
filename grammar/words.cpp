// SPDX-License-Identifier: MIT
// Words to rows. The table of distinct words, their perfect hash and the table of what each means
// in each block are all computed by the compiler from vocabulary.def.
#include <algorithm>
#include <array>

#include "grammar/vocabulary.hpp"

namespace cobble::grammar {
namespace {

constexpr std::uint8_t kNone = 0xff;

struct NamedField {
    BlockId block;
    std::string_view name;
    bool written;  ///< false for the "value" of inline and positional blocks
};

struct NamedBlock {
    std::string_view name;
    Layout layout;
};

constexpr NamedBlock kBlockNames[] = {
#define COBBLE_BLOCK(id, role, layout, parents, labelled, doc) {#id, Layout::layout},
#include "grammar/vocabulary.def"
};

constexpr bool has_named_fields(BlockId block) {
    const Layout layout = kBlockNames[static_cast<std::size_t>(block)].layout;
    return layout == Layout::kFields || layout == Layout::kList;
}

constexpr NamedField kFieldNames[] = {
#define COBBLE_FIELD(block, id, type, range, unit, fallback, presence, repeat, doc) \
    {BlockId::k##block, #id, has_named_fields(BlockId::k##block)},
#include "grammar/vocabulary.def"
};

struct WordList {
    std::array<std::string_view, kBlockCount + kFieldCount> names;
    std::size_t count = 0;

    [[nodiscard]] constexpr std::size_t find(std::string_view name) const {
        for (std::size_t i = 0; i < count; ++i) {
            if (names[i] == name) return i;
        }
        return count;
    }
    constexpr void add(std::string_view name) {
        if (find(name) == count) names[count++] = name;
    }
};

constexpr WordList kWords = [] {
    WordList words{};
    for (const NamedBlock& block : kBlockNames) words.add(block.name);
    for (const NamedField& field : kFieldNames) {
        if (field.written) words.add(field.name);
    }
    return words;
}();
static_assert(kWords.count < kNone);

// Length and three bytes tell all words apart; the multiplier that also puts them into different
// slots is looked for at compile time. Four slots a word make a hit on the first tries likely.
constexpr std::size_t kSlotBits = 10;
constexpr std::size_t kSlotCount = std::size_t{1} << kSlotBits;

constexpr std::uint32_t key_of(std::string_view name) {
    const auto byte = [name](std::size_t i) {
        return static_cast<std::uint32_t>(static_cast<unsigned char>(name[i]));
    };
    return byte(0) | byte(name.size() / 2) << 8U | byte(name.size() - 1) << 16U |
           (static_cast<std::uint32_t>(name.size()) & 0xffU) << 24U;
}

constexpr std::size_t slot_of(std::uint32_t key, std::uint32_t multiplier) {
    return (key * multiplier) >> (32 - kSlotBits);
}

using Slots = std::array<std::uint8_t, kSlotCount>;

constexpr bool fill_slots(Slots& slots, std::uint32_t multiplier) {
    slots.fill(kNone);
    for (std::size_t i = 0; i < kWords.count; ++i) {
        std::uint8_t& slot = slots[slot_of(key_of(kWords.names[i]), multiplier)];
        if (slot != kNone) return false;
        slot = static_cast<std::uint8_t>(i);
    }
    return true;
}

constexpr std::uint32_t kMultiplier = [] {
    // Odd numbers spread out by the golden ratio; the search is a few hundred tries at most, and a
    // vocabulary for which it fails does not compile.
    std::uint32_t multiplier = 0x9e3779b1U;
    for (int tries = 0; tries < 2000; ++tries, multiplier += 2U * 0x9e3779b1U) {
        Slots slots{};
        if (fill_slots(slots, multiplier)) return multiplier;
    }
    return 0U;
}();
static_assert(kMultiplier != 0, "no multiplier found: widen kSlotBits or take other key bytes");

constexpr Slots kSlots = [] {
    Slots slots{};
    fill_slots(slots, kMultiplier);
    return slots;
}();

constexpr std::size_t kMaxLength = [] {
    std::size_t longest = 0;
    for (std::size_t i = 0; i < kWords.count; ++i) {
        longest = std::max(longest, kWords.names[i].size());
    }
    return longest;
}();

constexpr auto kBlockOfWord = [] {
    std::array<std::uint8_t, kWords.count> rows{};
    rows.fill(kNone);
    for (std::size_t i = 0; i < kBlockCount; ++i) {
        rows[kWords.find(kBlockNames[i].name)] = static_cast<std::uint8_t>(i);
    }
    return rows;
}();

struct FieldTable {
    std::array<std::array<std::uint8_t, kWords.count>, kBlockCount> rows;
    std::array<bool, kWords.count> any;
};

constexpr FieldTable kFieldTable = [] {
    FieldTable table{};
    for (auto& row : table.rows) row.fill(kNone);
    for (std::size_t i = 0; i < kFieldCount; ++i) {
        if (!kFieldNames[i].written) continue;
        const std::size_t word = kWords.find(kFieldNames[i].name);
        table.rows[static_cast<std::size_t>(kFieldNames[i].block)][word] =
            static_cast<std::uint8_t>(i);
        table.any[word] = true;
    }
    return table;
}();

}  // namespace

WordId find_word(std::string_view name) {
    if (name.empty() || name.size() > kMaxLength) return {};
    const std::uint8_t word = kSlots[slot_of(key_of(name), kMultiplier)];
    return word != kNone && kWords.names[word] == name ? WordId{word} : WordId{};
}

const BlockRow* block_named(WordId word) {
    if (!word.valid() || kBlockOfWord[word.value] == kNone) return nullptr;
    return &row(static_cast<BlockId>(kBlockOfWord[word.value]));
}

const FieldRow* field_named(BlockId block, WordId word) {
    if (!word.valid()) return nullptr;
    const std::uint8_t found = kFieldTable.rows[static_cast<std::size_t>(block)][word.value];
    return found == kNone ? nullptr : &row(static_cast<FieldId>(found));
}

bool names_a_field(WordId word) { return word.valid() && kFieldTable.any[word.value]; }

}  // namespace cobble::grammar
