// SPDX-License-Identifier: MIT
// Standard output for results, standard error for messages, and what both are connected to.
#pragma once

#include <string>
#include <string_view>

namespace cobble::driver {

/// Buffered standard output that remembers how writing went. A reader that has gone away (a closed
/// pipe) is no failure: what is written after that is dropped, and the work goes on, as an exit
/// status or files may depend on it. Needs SIGPIPE ignored (see prepare_streams).
class Output {
  public:
    Output() = default;
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;
    ~Output() { flush(); }

    void write(std::string_view text);
    void flush();

    /// The system's words for a failed write (a full disk); empty if none failed.
    [[nodiscard]] const std::string& error() const { return error_; }

  private:
    std::string buffer_;
    std::string error_;
    bool closed_ = false;
};

/// Writes all of `bytes`, however many calls that takes; 0, or the errno that stopped it.
int write_all(int descriptor, std::string_view bytes);

/// Opens /dev/null on those of the three standard descriptors that are closed, so that no file
/// opened later is taken for one of them, though reading and writing results fail as before; and
/// ignores SIGPIPE and SIGXFSZ: a reader that has gone and a limit on file sizes are then errors of
/// writing.
void prepare_streams();

/// Writes "cobble: MESSAGE" or "cobble COMMAND: MESSAGE" and a line end to standard error, control
/// characters made visible.
void complain(std::string_view message, std::string_view command = {});

/// Writes to standard error as it is.
void write_error(std::string_view text);

/// True if the descriptor is a terminal.
bool is_terminal(int descriptor);

/// True if colour is wanted on this descriptor: a terminal that is not "dumb", and no NO_COLOR.
bool wants_color(int descriptor);

/// Columns of the terminal behind the descriptor, or `fallback`.
unsigned terminal_width(int descriptor, unsigned fallback);

}  // namespace cobble::driver
