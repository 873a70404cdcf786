// SPDX-License-Identifier: MIT
// What a shard says of itself fits every format, and comes back.
#include "tools/driver/shards.hpp"

#include <doctest/doctest.h>

#include "renderer/picture/comment.hpp"
#include "tools/driver/pictures.hpp"

namespace cobble::driver {
namespace {

ShardNote largest() {
    ShardNote note;
    note.index = note.count = 0xffffffff;
    note.width = note.height = 65535;
    note.window = {65533, 65533, 65535, 65535};
    note.tile_size = 32;
    note.picture = "sample-count";
    note.scene = note.settings = "0123456789abcdef";
    note.samples = 1048576;
    note.seed = ~std::uint64_t{0};
    note.version = "10.10.10";
    return note;
}

TEST_CASE("a note comes back from its text, and the longest one fits a comment") {
    const ShardNote note = largest();
    const std::string text = to_text(note);
    CHECK(text.size() <= renderer::kMaxComment);
    const auto back = parse_shard_note(text);
    REQUIRE(back);
    CHECK(to_text(*back) == text);
    CHECK(back->index == note.index);
    CHECK(back->window.x0 == note.window.x0);
    CHECK(back->seed == note.seed);
    CHECK(back->picture == note.picture);
    CHECK_FALSE(back->complete);
}

TEST_CASE("words of a later version are passed over") {
    CHECK(parse_shard_note(to_text(largest()) + " moon full"));
}

TEST_CASE("other texts are no notes") {
    const std::string good = to_text(largest());
    CHECK_FALSE(parse_shard_note(""));
    CHECK_FALSE(parse_shard_note("hello"));
    CHECK_FALSE(parse_shard_note("cobble shard "));
    // Cut within the last number that it needs, it is another number: the cuts end before it.
    const std::size_t last_number = good.find(" seed ") + 6;
    for (std::size_t size = 0; size <= last_number; ++size) {
        CAPTURE(size);
        CHECK_FALSE(parse_shard_note(good.substr(0, size)));
    }
    const auto changed = [&good](std::string_view from, std::string_view to) {
        std::string text = good;
        text.replace(text.find(from), from.size(), to);
        return text;
    };
    CHECK(parse_shard_note(changed("4294967295/", "1/")));
    CHECK_FALSE(parse_shard_note(changed("4294967295/", "0/")));
    CHECK_FALSE(parse_shard_note(changed("/4294967295", "/7")));
    CHECK_FALSE(parse_shard_note(changed("at 65533", "at 65535")));
    CHECK_FALSE(parse_shard_note(changed("of 65535", "of 65534")));
}

TEST_CASE("a count of samples has one grey, whatever else is in the picture") {
    const renderer::Plane32 counts{2, 1, 1, {1, 2}};
    CHECK(counts_as_grey(counts, 4).values == std::vector<float>{0.25F, 0.5F});
}

}  // namespace
}  // namespace cobble::driver
