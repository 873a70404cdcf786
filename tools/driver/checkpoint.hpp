// SPDX-License-Identifier: MIT
// Checkpoints: what a render has done so far, kept in a file from which it can be gone on with.
//
// A file is one line of text that says which render it is of (`head -1` shows it), then the job's
// state as RenderJob::state() gives it, then the SHA-256 of all that. So damage is found before
// anything of the state is believed, and a file of another render is refused with what differs.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "ir/scene/scene.hpp"
#include "renderer/settings.hpp"
#include "tools/driver/render_identity.hpp"

namespace cobble::driver {

/// Which render a state is of. How it is made (threads, acceleration) is no part of it, nor are
/// tiles, but where they say which pixels are a shard's.
struct CheckpointNote : RenderIdentity {
    std::uint32_t index = 1, count = 1;  ///< shard I of N, from 1
    std::uint32_t tile_size = 0;         ///< 0 if the whole picture is rendered
    std::string pictures;                ///< that are kept: "color,depth"
};

/// Costs one hash of the scene.
CheckpointNote checkpoint_note(const ir::Scene& scene, const renderer::Settings& settings);

/// The bytes of a file. Cost: some 10 ns a byte, nearly all of it for the checksum.
std::string encode_checkpoint(const CheckpointNote& note, std::string_view state);

struct Checkpoint {
    std::string state;
    std::string problem;   ///< why it cannot be used; empty if it can, or if there is none
    bool missing = false;  ///< there is no such file
};

/// The state in `bytes`, any bytes at all. The problem says what is wrong with them, or what
/// differs between their render and `note`: "it is damaged: ...", "its seed is 2, not 1".
Checkpoint decode_checkpoint(std::string_view bytes, const CheckpointNote& note);

/// The same of a file; the problem is then "cannot resume from PATH: ...".
Checkpoint read_checkpoint(const std::string& path, const CheckpointNote& note);

}  // namespace cobble::driver
