// SPDX-License-Identifier: MIT
// Files on the disk.
#pragma once

#include <string>
#include <vector>

#include "frontend/source/file_source.hpp"

namespace cobble::driver {

/// Reads regular files of the machine it runs on.
class DiskFileSource : public source::FileSource {
  public:
    source::ReadResult read(std::string_view path, std::uint64_t max_bytes) override;
    bool exists(std::string_view path) override;

    /// Every path that was to be read so far.
    [[nodiscard]] const std::vector<std::string>& read_paths() const { return read_paths_; }

  private:
    std::vector<std::string> read_paths_;
};

}  // namespace cobble::driver
