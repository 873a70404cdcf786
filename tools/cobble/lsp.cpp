// SPDX-License-Identifier: MIT
#include "tools/lsp/stdio.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <string>

#include "tools/cobble/command.hpp"
#include "tools/driver/text.hpp"

namespace cobble {

void add_lsp(CLI::App& app, Context& context) {
    CLI::App* sub = app.add_subcommand("lsp", "Serve an editor: the language server");
    sub->add_flag("--stdio")->description(
        "On standard input and output, as always: some editors say it");
    sub->footer(
        "It speaks the Language Server Protocol: an editor starts it, not a person.\n"
        "Exit status 0 after 'shutdown' and 'exit', else 1.");
    sub->callback([&context] {
        context.run = [] {
            if (isatty(STDIN_FILENO) == 1) {
                driver::complain(
                    "the language server is started by an editor, which speaks to it: waiting for "
                    "its messages on standard input");
            }
            return lsp::serve(STDIN_FILENO, STDOUT_FILENO);
        };
    });
}

}  // namespace cobble
