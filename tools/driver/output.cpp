// SPDX-License-Identifier: MIT
#include "tools/driver/output.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "tools/driver/text.hpp"

namespace cobble::driver {
namespace {

// Large enough that a system call costs nothing beside what was written.
constexpr std::size_t kBufferBytes = std::size_t{1} << 16;

}  // namespace

int write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        // Linux writes at most 0x7ffff000 bytes at a time.
        const ssize_t done = ::write(descriptor, bytes.data(), bytes.size());
        if (done < 0 && errno == EINTR) continue;
        if (done < 0) return errno;
        bytes.remove_prefix(static_cast<std::size_t>(done));
    }
    return 0;
}

void Output::write(std::string_view text) {
    if (closed_ || !error_.empty()) return;
    buffer_ += text;
    if (buffer_.size() >= kBufferBytes) flush();
}

void Output::flush() {
    if (buffer_.empty()) return;
    const int failure = write_all(STDOUT_FILENO, buffer_);
    buffer_.clear();
    if (failure == EPIPE) {
        closed_ = true;
    } else if (failure != 0 && error_.empty()) {
        error_ = std::strerror(failure);
    }
}

void prepare_streams() {
    for (int descriptor = 0; descriptor < 3; ++descriptor) {
        if (fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) continue;
        // The lowest free number is the closed one, as those below it are open. Input and output
        // are opened the wrong way round: reading and writing fail as on the closed ones.
        if (open("/dev/null", descriptor == STDOUT_FILENO ? O_RDONLY : O_WRONLY) < 0) std::_Exit(2);
    }
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

void write_error(std::string_view text) { write_all(STDERR_FILENO, text); }

void complain(std::string_view message, std::string_view command) {
    std::string line = "cobble";
    if (!command.empty()) line += ' ';
    line += command;
    line += ": ";
    // Paths come from anywhere, and so does what stands in them.
    line += printable(message);
    line += '\n';
    write_error(line);
}

bool is_terminal(int descriptor) { return isatty(descriptor) == 1; }

bool wants_color(int descriptor) {
    const char* no_color = std::getenv("NO_COLOR");
    if (no_color != nullptr && *no_color != '\0') return false;
    const char* terminal = std::getenv("TERM");
    const bool dumb = terminal == nullptr || std::strcmp(terminal, "dumb") == 0;
    return !dumb && is_terminal(descriptor);
}

unsigned terminal_width(int descriptor, unsigned fallback) {
    struct winsize size {};
    if (ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return fallback;
    return size.ws_col;
}

}  // namespace cobble::driver
