// SPDX-License-Identifier: MIT
#include "tools/driver/disk_file_source.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <string>

namespace cobble::driver {
namespace {

struct Descriptor {
    int value;
    explicit Descriptor(int descriptor) : value(descriptor) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (value >= 0) close(value);
    }
};

source::ReadResult failure(int error) {
    const bool missing = error == ENOENT || error == ENOTDIR || error == ENAMETOOLONG;
    return {missing ? source::ReadStatus::kMissing : source::ReadStatus::kUnreadable,
            {},
            std::strerror(error)};
}

}  // namespace

source::ReadResult DiskFileSource::read(std::string_view path, std::uint64_t max_bytes) {
    read_paths_.emplace_back(path);
    // Not blocking, so that opening a named pipe without a writer does not hang.
    const Descriptor file(open(std::string(path).c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file.value < 0) return failure(errno);
    struct stat status {};
    if (fstat(file.value, &status) != 0) return failure(errno);
    if (!S_ISREG(status.st_mode)) {
        return {source::ReadStatus::kNotAFile,
                {},
                S_ISDIR(status.st_mode) ? "it is a folder" : "it is not a regular file"};
    }
    if (static_cast<std::uint64_t>(status.st_size) > max_bytes) {
        return {source::ReadStatus::kTooLarge, {}, "it is too large"};
    }
    // The size is a guess: that of files which the kernel makes up (/proc) is 0, and others grow.
    // So reading goes on to the end, with room for one byte more than is known to come.
    constexpr std::size_t kLeastRoom = 4096;
    source::ReadResult result{source::ReadStatus::kOk, {}, {}};
    result.bytes.resize(static_cast<std::size_t>(status.st_size) + 1);
    std::size_t done = 0;
    for (;;) {
        if (done == result.bytes.size()) result.bytes.resize(done + std::max(done, kLeastRoom));
        const ssize_t got =
            ::read(file.value, result.bytes.data() + done, result.bytes.size() - done);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return failure(errno);
        if (got == 0) break;
        done += static_cast<std::size_t>(got);
        if (done > max_bytes) return {source::ReadStatus::kTooLarge, {}, "it is too large"};
    }
    result.bytes.resize(done);
    return result;
}

bool DiskFileSource::exists(std::string_view path) {
    struct stat status {};
    return stat(std::string(path).c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

}  // namespace cobble::driver
