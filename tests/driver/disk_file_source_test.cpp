// SPDX-License-Identifier: MIT
#include "tools/driver/disk_file_source.hpp"

#include <doctest/doctest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <string>

namespace cobble::driver {

using source::ReadStatus;

TEST_CASE("files are read to their end, whatever their size is said to be") {
    DiskFileSource disk;
    // Made up by the kernel, with a size of 0; longer than one page of memory.
    const std::string path = "/proc/self/smaps";
    if (access(path.c_str(), R_OK) == 0) {
        const auto read = disk.read(path, 1U << 30U);
        CHECK(read.status == ReadStatus::kOk);
        CHECK(read.bytes.size() > 4096);
        CHECK(read.bytes.ends_with('\n'));
        CHECK(disk.read(path, 100).status == ReadStatus::kTooLarge);
    }
    std::string name = "/tmp/cobble-disk-XXXXXX";
    const int descriptor = mkstemp(name.data());
    REQUIRE(descriptor >= 0);
    close(descriptor);
    std::ofstream(name) << std::string(10000, 'x');
    CHECK(disk.read(name, 10000).bytes == std::string(10000, 'x'));
    CHECK(disk.read(name, 9999).status == ReadStatus::kTooLarge);
    unlink(name.c_str());
    CHECK(disk.read(name, 10000).status == ReadStatus::kMissing);
}

}  // namespace cobble::driver
