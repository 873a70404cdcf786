// SPDX-License-Identifier: MIT
#include "tools/driver/disk_file_source.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
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
    source::ReadResult result{source::ReadStatus::kOk, {}, {}};
    result.bytes.resize(static_cast<std::size_t>(status.st_size));
    std::size_t done = 0;
    while (done < result.bytes.size()) {
        const ssize_t got =
            ::read(file.value, result.bytes.data() + done, result.bytes.size() - done);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return failure(errno);
        if (got == 0) break;
        done += static_cast<std::size_t>(got);
    }
    result.bytes.resize(done);
    return result;
}

bool DiskFileSource::exists(std::string_view path) {
    struct stat status {};
    return stat(std::string(path).c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

}  // namespace cobble::driver
