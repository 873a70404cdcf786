// SPDX-License-Identifier: MIT
// A checkpoint gives back the state that it was made of, to the render that it was made of, and to
// no other; whatever else the bytes are, it says what is wrong with them.
#include "tools/driver/checkpoint.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <utility>

#include "tests/render/scene_builder.hpp"

namespace cobble::driver {
namespace {

test::SceneBuilder scene_with(double radius) {
    test::SceneBuilder b;
    b.sphere({0, 0, 0}, radius);
    return b;
}

CheckpointNote note_of(const renderer::Settings& settings, double radius = 1) {
    test::SceneBuilder b = scene_with(radius);
    return checkpoint_note(b.scene(), settings);
}

renderer::Settings plain() { return test::settings(64, 48, 16); }

// Of all bytes one, the line's end among them.
std::string some_state() {
    std::string state;
    for (int i = 0; i < 256; ++i) state += static_cast<char>(i);
    return state;
}

TEST_CASE("a state comes back to the render that it is of") {
    const CheckpointNote note = note_of(plain());
    for (const std::string& state : {some_state(), std::string()}) {
        const Checkpoint back = decode_checkpoint(encode_checkpoint(note, state), note);
        CHECK(back.problem.empty());
        CHECK(back.state == state);
    }
}

TEST_CASE("how a picture is made may change between a checkpoint and its use") {
    const std::string file = encode_checkpoint(note_of(plain()), some_state());
    renderer::Settings other = plain();
    other.tile_size = 8;
    other.acceleration = renderer::Acceleration::kBvh;
    CHECK(decode_checkpoint(file, note_of(other)).problem.empty());
}

TEST_CASE("another render is refused by what differs first") {
    const std::string file = encode_checkpoint(note_of(plain()), some_state());
    const auto problem_with = [&file](const std::function<void(renderer::Settings&)>& change) {
        renderer::Settings other = plain();
        change(other);
        const Checkpoint read = decode_checkpoint(file, note_of(other));
        CHECK(read.state.empty());
        return read.problem;
    };
    const std::string start = "it is of another render: ";
    using Settings = renderer::Settings;
    CHECK(problem_with([](Settings& s) { s.width = 65; }) ==
          start + "its size is 64x48, not 65x48");
    CHECK(problem_with([](Settings& s) {
              s.crop = {1, 2, 30, 40};
          }) == start + "its crop is 0,0,64,48, not 1,2,30,40");
    CHECK(problem_with([](Settings& s) { s.samples = 4; }) ==
          start + "its number of samples is 16, not 4");
    CHECK(problem_with([](Settings& s) { s.seed = 7; }) == start + "its seed is 0, not 7");
    CHECK(problem_with([](Settings& s) { s.bounces = 7; }) == start + "it has other options");
    CHECK(problem_with([](Settings& s) { s.precision = renderer::Precision::kDouble; }) ==
          start + "it has other options");
    CHECK(problem_with([](Settings& s) { s.want_depth = true; }) ==
          start + "its list of pictures is color, not color,depth");
    CHECK(problem_with([](Settings& s) {
              s.shard_index = 1;
              s.shard_count = 3;
          }) == start + "its part of the picture is all of it, not shard 2/3");
    CHECK(decode_checkpoint(file, note_of(plain(), 2)).problem == start + "it shows another scene");
    CheckpointNote later = note_of(plain());
    later.version = "9.9.9";
    const std::string old_version = note_of(plain()).version;
    CHECK(decode_checkpoint(file, later).problem ==
          start + "its version of cobble is " + old_version + ", not 9.9.9");
}

TEST_CASE("tiles matter where they say which pixels a shard has") {
    renderer::Settings shard = plain();
    shard.shard_count = 3;
    const std::string file = encode_checkpoint(note_of(shard), some_state());
    CHECK(decode_checkpoint(file, note_of(shard)).problem.empty());
    shard.tile_size = 8;
    CHECK(decode_checkpoint(file, note_of(shard)).problem ==
          "it is of another render: its tile size is 32, not 8");
}

TEST_CASE("a file cut off anywhere is refused") {
    const CheckpointNote note = note_of(plain());
    const std::string file = encode_checkpoint(note, some_state());
    for (std::size_t size = 0; size < file.size(); ++size) {
        CAPTURE(size);
        const Checkpoint read = decode_checkpoint(std::string_view(file).substr(0, size), note);
        CHECK(read.problem.starts_with("it is cut off"));
        CHECK(read.state.empty());
    }
    CHECK(decode_checkpoint(file + '\n', note).problem ==
          "it is damaged: its contents do not match its checksum");
}

TEST_CASE("a file with any byte changed is refused") {
    const CheckpointNote note = note_of(plain());
    const std::string file = encode_checkpoint(note, some_state());
    for (std::size_t at = 0; at < file.size(); ++at) {
        for (const int bit : {0, 5, 7}) {
            CAPTURE(at);
            CAPTURE(bit);
            std::string damaged = file;
            damaged[at] = static_cast<char>(damaged[at] ^ (1 << bit));
            const Checkpoint read = decode_checkpoint(damaged, note);
            CHECK_FALSE(read.problem.empty());
            CHECK(read.state.empty());
        }
    }
}

TEST_CASE("other files are no checkpoints") {
    const CheckpointNote note = note_of(plain());
    const auto problem_of = [&note](std::string_view bytes) {
        return decode_checkpoint(bytes, note).problem;
    };
    CHECK(problem_of("PF\n3 3\n") == "it is no checkpoint of a render");
    CHECK(problem_of("cobble shard 1/2") == "it is no checkpoint of a render");
    CHECK(problem_of(std::string("cobble checkpoint ") + std::string(5000, 'x')) ==
          "it is damaged in its first line");
    CHECK(problem_of("cobble checkpoint 2 moon full\n") ==
          "its format is 2, of a later version of cobble");
    // As large as it says it is, and no larger than there is room for.
    CHECK_FALSE(problem_of("cobble checkpoint 1" + words_of(note) +
                           " shard 1/1 tiles 0 pictures color state 18446744073709551615\n")
                    .empty());
}

TEST_CASE("a file that is not there is no problem") {
    const Checkpoint read = read_checkpoint("/nowhere/at/all", note_of(plain()));
    CHECK(read.missing);
    CHECK(read.problem.empty());
    CHECK(read_checkpoint("/", note_of(plain())).problem == "cannot resume from /: it is a folder");
}

}  // namespace
}  // namespace cobble::driver
