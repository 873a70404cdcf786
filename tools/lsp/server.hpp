// SPDX-License-Identifier: MIT
// The language server as one value: messages in, messages out. It has no thread, terminal or clock
// of its own; a program on standard input and output drives it, and so can a browser.
//
//   for (const Json& answer : server.handle(message)) send(answer);
//   while (server.has_work() && nothing_has_arrived) for (... : server.work(deadline)) send(...);
//   if (server.over()) return server.exit_code();
#pragma once

#include <chrono>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tools/lsp/documents/workspace.hpp"

namespace cobble::lsp {

using Deadline = std::chrono::steady_clock::time_point;

class Server {
  public:
    /// `disk` must outlive it.
    explicit Server(source::FileSource& disk) : workspace_(disk) {}

    /// One message. Answers come in their order; findings wait for work(). Never throws for what a
    /// client sends: what cannot be answered gets an error of the protocol.
    std::vector<Json> handle(const Json& message);
    /// The same of a message's bytes, which may be no JSON at all.
    std::vector<Json> handle_text(std::string_view body);

    /// Whether there is something to do that nobody waits for.
    [[nodiscard]] bool has_work() const;
    /// A piece of it: the findings of one document, some 4 ms for 10,000 lines. `deadline` is for
    /// work that can be put down.
    std::vector<Json> work(Deadline deadline);

    /// The client said `exit`.
    [[nodiscard]] bool over() const { return state_ == State::kOver; }
    /// 0, or 1 if `exit` came without `shutdown` before it.
    [[nodiscard]] int exit_code() const { return exit_code_; }

  private:
    enum class State : unsigned char { kNew, kReady, kShutDown, kOver };

    Json answer(const std::string& method, const Json& id, const Json& params);
    Json initialize(const Json& params);
    void notice(const std::string& method, const Json& params);
    void open(const Json& params);
    void close(const Json& params);
    std::vector<Json> publish(Document& document);
    void tell(const std::string& uri, const std::string& of, Json items, const Json& version,
              std::vector<Json>& messages);

    Workspace workspace_;
    State state_ = State::kNew;
    int exit_code_ = 1;
    std::deque<Json> waiting_;  ///< messages for the client that work() sends
    /// What was last told of a file: by file, by the document that it was found through.
    std::map<std::string, std::map<std::string, Json>> told_;
};

}  // namespace cobble::lsp
