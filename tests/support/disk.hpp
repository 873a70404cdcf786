// SPDX-License-Identifier: MIT
// Files for tests: whole ones as texts, and the disk as the file source of lowering.
#pragma once

#include <filesystem>
#include <string>

#include "frontend/source/file_source.hpp"

namespace cobble::test {

/// The whole file, or an empty text if there is none.
std::string file_text(const std::filesystem::path& path);

class Disk final : public source::FileSource {
  public:
    source::ReadResult read(std::string_view path, std::uint64_t max_bytes) override;
    bool exists(std::string_view path) override;
};

}  // namespace cobble::test
