// SPDX-License-Identifier: MIT
#include "tools/lsp/stdio.hpp"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>
#include <vector>

#include "tools/driver/disk_file_source.hpp"
#include "tools/lsp/protocol/message_reader.hpp"
#include "tools/lsp/server.hpp"

namespace cobble::lsp {
namespace {

/// A piece of work ends so soon that a message is not kept waiting.
constexpr std::chrono::milliseconds kPiece{10};

class Pipe {
  public:
    Pipe(int input, int output) : input_(input), output_(output) {}

    /// Reads what has arrived, and waits for it if `wait`. False at the end.
    bool read(bool wait) {
        while (true) {
            struct pollfd ready = {input_, POLLIN, 0};
            const int found = poll(&ready, 1, wait ? -1 : 0);
            if (found < 0 && errno == EINTR) continue;
            if (found < 0) return false;
            if (found == 0) return true;
            const ssize_t count = ::read(input_, bytes_.data(), bytes_.size());
            if (count < 0 && errno == EINTR) continue;
            if (count <= 0) return false;
            reader.feed({bytes_.data(), static_cast<std::size_t>(count)});
            wait = false;
        }
    }

    /// False if nobody reads it any more.
    bool send(const Json& message) {
        // Bytes of a document that are no UTF-8 would be no JSON.
        const std::string text =
            framed(message.dump(-1, ' ', false, Json::error_handler_t::replace));
        std::size_t sent = 0;
        while (sent < text.size()) {
            const ssize_t count = ::write(output_, text.data() + sent, text.size() - sent);
            if (count < 0 && errno == EINTR) continue;
            if (count <= 0) return false;
            sent += static_cast<std::size_t>(count);
        }
        return true;
    }

    MessageReader reader;

  private:
    int input_, output_;
    std::array<char, 65536> bytes_{};
};

bool send_all(Pipe& pipe, const std::vector<Json>& messages) {
    for (const Json& message : messages) {
        if (!pipe.send(message)) return false;
    }
    return true;
}

}  // namespace

int serve(int input, int output) {
    driver::DiskFileSource disk;
    Server server(disk);
    Pipe pipe(input, output);
    bool open = true;
    while (open) {
        open = pipe.read(!server.has_work());
        while (true) {
            const MessageReader::Next next = pipe.reader.next();
            using Status = MessageReader::Status;
            if (next.status == Status::kNone) break;
            if (next.status == Status::kMessage) {
                if (!send_all(pipe, server.handle_text(next.body))) return 1;
                if (server.over()) return server.exit_code();
                continue;
            }
            const Json problem = error_response(nullptr, ErrorCode::kParseError, next.problem);
            if (!pipe.send(problem) || next.status == Status::kLost) return 1;
        }
        if (open && server.has_work()) {
            const auto deadline = std::chrono::steady_clock::now() + kPiece;
            if (!send_all(pipe, server.work(deadline))) return 1;
        }
    }
    return 1;
}

}  // namespace cobble::lsp
