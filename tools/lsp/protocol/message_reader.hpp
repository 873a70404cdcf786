// SPDX-License-Identifier: MIT
// Bytes from a client as messages: "Content-Length: N", an empty line, N bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cobble::lsp {

class MessageReader {
  public:
    enum class Status : unsigned char {
        kNone,     ///< more bytes are needed
        kMessage,  ///< `body` is one
        kBad,      ///< a header without a length: what follows it is read as the next message
        kLost,     ///< where the next message begins cannot be told any more
    };
    struct Next {
        Status status = Status::kNone;
        std::string body;
        std::string_view problem;  ///< of kBad and kLost
    };

    void feed(std::string_view bytes) { buffer_ += bytes; }
    /// To be called until it gives kNone. Cost: each byte is looked at once.
    Next next();

  private:
    Next read_header();
    void drop(std::size_t bytes);

    std::string buffer_;
    std::size_t at_ = 0;        ///< of it, bytes that are done
    std::size_t searched_ = 0;  ///< behind them, bytes in which no header ends
    bool in_body_ = false;
    std::size_t length_ = 0;  ///< of the body
};

/// The message as it goes out.
std::string framed(std::string_view body);

}  // namespace cobble::lsp
