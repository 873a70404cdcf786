// SPDX-License-Identifier: MIT
#include "tools/driver/write_file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <utility>
#include <vector>

#include "tools/driver/output.hpp"

namespace cobble::driver {
namespace {

// As many symbolic links in a row as Linux itself follows.
constexpr int kMaxLinks = 40;

// Beside the system's own: opening a named pipe would wait for a reader, for ever if none comes.
constexpr int kNotAFile = -1;

std::string failure(const std::string& path, int error) {
    return fmt::format("cannot write {}: {}", path,
                       error == kNotAFile ? "it is not a regular file" : std::strerror(error));
}

std::string folder_of(const std::string& path) {
    const auto slash = path.rfind('/');
    return slash == std::string::npos ? std::string() : path.substr(0, slash + 1);
}

// /dev/stdout and its like name an open descriptor: what is behind it is to be written to, not to
// be replaced. Gives the number, or -1.
int descriptor_of(const std::string& path) {
    if (path == "/dev/stdout") return STDOUT_FILENO;
    if (path == "/dev/stderr") return STDERR_FILENO;
    for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
        if (!path.starts_with(folder)) continue;
        int number = -1;
        const char* end = path.data() + path.size();
        const auto read = std::from_chars(path.data() + folder.size(), end, number);
        if (read.ec == std::errc() && read.ptr == end) return number;
    }
    return -1;
}

// Gives a file that has no name one that is not taken; 0, or the errno that spoke against it.
int name_file(int descriptor, const std::string& pattern, std::string& name) {
    const std::string open_file = "/proc/self/fd/" + std::to_string(descriptor);
    constexpr int kMostTries = 1000;
    int error = EEXIST;
    for (int i = 0; error == EEXIST && i < kMostTries; ++i) {
        name = pattern + std::to_string(getpid()) + "-" + std::to_string(i);
        const bool named =
            linkat(AT_FDCWD, open_file.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
        error = named ? 0 : errno;
    }
    if (error != 0) name.clear();
    return error;
}

// A new file beside its later place, removed again unless it is kept. Where the file system can, it
// has no name until then, so that not even a killed process leaves it behind.
class Temporary {
  public:
    explicit Temporary(const std::string& beside) {
        const auto slash = beside.rfind('/');
        const std::string folder = folder_of(beside);
        // 200 bytes of the name leave room for the rest within the 255 that file systems allow.
        const std::string base =
            beside.substr(slash == std::string::npos ? 0 : slash + 1).substr(0, 200);
        pattern_ = folder + "." + base + ".";
        if (access("/proc/self/fd", X_OK) == 0) {
            descriptor_ = open(folder.empty() ? "." : folder.c_str(),
                               O_TMPFILE | O_RDWR | O_CLOEXEC, S_IRUSR | S_IWUSR);
        }
        if (descriptor_ >= 0) return;
        path_ = pattern_ + "XXXXXX";
        descriptor_ = mkstemp(path_.data());
        error_ = descriptor_ < 0 ? errno : 0;
    }
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;
    ~Temporary() {
        if (descriptor_ < 0) return;
        close(descriptor_);
        if (!path_.empty()) unlink(path_.c_str());
    }

    [[nodiscard]] int descriptor() const { return descriptor_; }
    [[nodiscard]] int error() const { return error_; }

    int rename_to(const std::string& target) {
        if (path_.empty()) {
            if (const int error = name_file(descriptor_, pattern_, path_)) return error;
        }
        if (rename(path_.c_str(), target.c_str()) != 0) return errno;
        path_.clear();
        return 0;
    }

  private:
    std::string pattern_;
    std::string path_;  ///< empty while it has no name
    int descriptor_ = -1;
    int error_ = 0;
};

// The mode that a new file would get.
mode_t default_mode() {
    const mode_t mask = umask(0);
    umask(mask);
    return static_cast<mode_t>(0666U & ~mask);
}

int write_in_place(const std::string& path, std::string_view bytes) {
    const int descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) return errno;
    const int error = write_all(descriptor, bytes);
    return close(descriptor) != 0 && error == 0 ? errno : error;
}

// The new name must survive a crash too. Not every file system can do this: no failure if not.
void sync_folder(const std::string& folder) {
    const int descriptor = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return;
    fsync(descriptor);
    close(descriptor);
}

// What can be said against writing to `target` before trying: it is a folder, a pipe, or
// read-only.
int objection(const std::string& target, const struct stat& status) {
    if (S_ISDIR(status.st_mode)) return EISDIR;
    if (!S_ISREG(status.st_mode) && !S_ISCHR(status.st_mode)) return kNotAFile;
    return access(target.c_str(), W_OK) == 0 ? 0 : errno;
}

int replace(const std::string& target, std::string_view bytes) {
    struct stat old {};
    const bool exists = stat(target.c_str(), &old) == 0;
    if (exists) {
        if (const int error = objection(target, old)) return error;
        if (!S_ISREG(old.st_mode)) return write_in_place(target, bytes);
    }
    Temporary temporary(target);
    if (temporary.error() != 0) return temporary.error();
    if (const int error = write_all(temporary.descriptor(), bytes)) return error;
    if (exists) {
        // Only root may give a file away; for others the file becomes theirs.
        if (fchown(temporary.descriptor(), old.st_uid, old.st_gid) != 0) errno = 0;
    }
    const mode_t mode = exists ? old.st_mode & 07777U : default_mode();
    if (fchmod(temporary.descriptor(), mode) != 0) return errno;
    if (fsync(temporary.descriptor()) != 0 && errno != EINVAL) return errno;
    if (const int error = temporary.rename_to(target)) return error;
    sync_folder(folder_of(target));
    return 0;
}

}  // namespace

std::string follow_links(std::string path) {
    // What a descriptor stands for need not have a name.
    for (int i = 0; i < kMaxLinks && descriptor_of(path) < 0; ++i) {
        struct stat status {};
        if (lstat(path.c_str(), &status) != 0 || !S_ISLNK(status.st_mode)) break;
        std::vector<char> target(4096);
        const ssize_t length = readlink(path.c_str(), target.data(), target.size());
        if (length <= 0) break;
        const std::string_view next(target.data(), static_cast<std::size_t>(length));
        path = next.starts_with('/') ? std::string() : folder_of(path);
        path += next;
    }
    return path;
}

std::string write_file(const std::string& path, std::string_view bytes) {
    const std::string target = follow_links(path);
    if (const int descriptor = descriptor_of(target); descriptor >= 0) {
        const int failed = write_all(descriptor, bytes);
        return failed == 0 || failed == EPIPE ? std::string() : failure(path, failed);
    }
    const int error = replace(target, bytes);
    return error == 0 ? std::string() : failure(path, error);
}

namespace {

// check_writable() of so many bytes, of none without asking for room.
std::string check(const std::string& path, std::uint64_t bytes) {
    const std::string target = follow_links(path);
    if (const int descriptor = descriptor_of(target); descriptor >= 0) {
        return fcntl(descriptor, F_GETFD) >= 0 ? std::string() : failure(path, errno);
    }
    struct stat status {};
    if (stat(target.c_str(), &status) == 0) {
        if (const int error = objection(target, status)) return failure(path, error);
        if (!S_ISREG(status.st_mode)) return {};
    } else if (target.empty() || target.ends_with('/')) {
        return failure(path, target.empty() ? ENOENT : EISDIR);
    }
    const Temporary temporary(target);
    if (temporary.error() != 0) return failure(path, temporary.error());
    if (bytes == 0) return {};
    const auto size = static_cast<off_t>(std::min<std::uint64_t>(bytes, 1ULL << 40U));
    if (fallocate(temporary.descriptor(), 0, 0, size) != 0 && (errno == ENOSPC || errno == EFBIG)) {
        return failure(path, errno);
    }
    return {};
}

}  // namespace

std::string check_writable(const std::string& path, std::uint64_t bytes) {
    // One block at least: a full disk takes the name of a file but none of its bytes.
    return check(path, std::max<std::uint64_t>(bytes, 4096));
}

std::string check_place(const std::string& path) { return check(path, 0); }

}  // namespace cobble::driver
