// SPDX-License-Identifier: MIT
// Where the bytes of scenes, textures and meshes come from. The disk stands behind this interface
// on the command line, a map of uploaded files in a browser, unsaved buffers in an editor.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cobble::source {

enum class ReadStatus : unsigned char {
    kOk,
    kMissing,     ///< no such file
    kNotAFile,    ///< a folder, a device, a socket
    kUnreadable,  ///< permission or I/O error; `reason` says which
    kTooLarge,    ///< larger than `max_bytes`; nothing was read
};

struct ReadResult {
    ReadStatus status = ReadStatus::kMissing;
    std::string bytes;
    std::string reason;  ///< the system's words for a failure, for people
};

class FileSource {
  public:
    FileSource() = default;
    FileSource(const FileSource&) = delete;
    FileSource& operator=(const FileSource&) = delete;
    virtual ~FileSource() = default;

    /// Reads a whole file. `path` uses '/' and is absolute or relative to the source's own base.
    /// Never takes more than `max_bytes` (plus a constant) of memory.
    virtual ReadResult read(std::string_view path, std::uint64_t max_bytes) = 0;

    /// True if `path` names a readable regular file.
    virtual bool exists(std::string_view path) = 0;
};

/// The folder of `path` with its final '/', or "" if it has none.
std::string_view folder_of(std::string_view path);

/// `path` as seen from the file `from`: absolute paths stay, others are joined to its folder.
std::string resolve(std::string_view from, std::string_view path);

}  // namespace cobble::source
