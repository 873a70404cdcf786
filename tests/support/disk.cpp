// SPDX-License-Identifier: MIT
#include "tests/support/disk.hpp"

#include <fstream>
#include <iterator>

namespace cobble::test {

namespace fs = std::filesystem;

std::string file_text(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

source::ReadResult Disk::read(std::string_view path, std::uint64_t max_bytes) {
    const fs::path file(path);
    if (!exists(path)) return {source::ReadStatus::kMissing, {}, {}};
    std::error_code error;
    if (fs::file_size(file, error) > max_bytes) return {source::ReadStatus::kTooLarge, {}, {}};
    return {source::ReadStatus::kOk, file_text(file), {}};
}

bool Disk::exists(std::string_view path) {
    std::error_code error;
    return fs::is_regular_file(fs::path(path), error);
}

}  // namespace cobble::test
