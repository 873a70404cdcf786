// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include "grammar/vocabulary.hpp"

using namespace cobble::grammar;

TEST_CASE("every row is found by its name, and only there") {
    for (const BlockRow& block : blocks()) {
        REQUIRE(find_block(block.name) != nullptr);
        CHECK(find_block(block.name)->id == block.id);
        CHECK(!block.doc.empty());
        for (const FieldRow& field : fields_of(block.id)) {
            CHECK(field.block == block.id);
            CHECK(!field.doc.empty());
            const bool named = block.layout == Layout::kFields || block.layout == Layout::kList;
            CHECK((find_field(block.id, field.name) == &field) == named);
        }
    }
    CHECK(find_block("sphere") == nullptr);
    CHECK(find_field(BlockId::kSphere, "normal") == nullptr);
}

TEST_CASE("a field of the same name differs by its block") {
    CHECK(find_field(BlockId::kPlane, "normal")->type == ValueType::kVector3);
    CHECK(find_field(BlockId::kMaterial, "normal")->type == ValueType::kImagePath);
    CHECK(may_stand_in(BlockId::kNoise, BlockId::kPhongMaterial));
    CHECK(!may_stand_in(BlockId::kNoise, BlockId::kLights));
    CHECK(may_stand_at_top(BlockId::kGroup));
    CHECK(!may_stand_at_top(BlockId::kSphere));
}
