// SPDX-License-Identifier: MIT
// Files written whole or not at all.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cobble::driver {

/// Puts `bytes` in place of the file `path`: written to a temporary file in the same folder, synced
/// to the disk, given the old file's permissions and owner, then renamed over it. Symbolic links
/// are followed, so that the link stays and its target changes. On failure the old file is as it
/// was and nothing is left behind; where files can be without a name (Linux's O_TMPFILE), not even
/// by a kill, but for the instant between naming and renaming. Character devices and open
/// descriptors (/dev/null, /dev/stdout) are written to; whatever else is no regular file (a named
/// pipe) is a failure.
///
/// Gives "" or what went wrong, as "cannot write PATH: REASON".
std::string write_file(const std::string& path, std::string_view bytes);

/// Tries, leaving nothing behind, whether write_file(path) could work for a file of `bytes` bytes:
/// the folder is there and may be written to, and the disk has room. Gives "" or what is wrong.
std::string check_writable(const std::string& path, std::uint64_t bytes);

/// The same but for the room: the disk may be full for now.
std::string check_place(const std::string& path);

/// Where a chain of symbolic links leads, whether or not something is there.
std::string follow_links(std::string path);

}  // namespace cobble::driver
