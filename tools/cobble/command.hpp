// SPDX-License-Identifier: MIT
// What every subcommand is made of. Each has a file of its own that declares its options and holds
// a thin run(); the work is done in the libraries.
#pragma once

#include <functional>

#include "tools/driver/output.hpp"

namespace CLI {
class App;
}

namespace cobble {

/// What the process ends with. Scripts depend on these.
enum Status : int {
    kDone = 0,
    kFindings = 1,      ///< lint errors, differences, a broken scene
    kFailure = 2,       ///< usage, a missing file, reading or writing
    kInternal = 3,      ///< a bug
    kInterrupted = 130  ///< as shells report an interrupt
};

/// What a subcommand is given, and what it leaves: parsing the command line sets `run`.
struct Context {
    driver::Output out;
    std::function<int()> run;
};

void add_lint(CLI::App& app, Context& context);
void add_fmt(CLI::App& app, Context& context);
void add_render(CLI::App& app, Context& context);
void add_explain(CLI::App& app, Context& context);
void add_diff(CLI::App& app, Context& context);
void add_merge(CLI::App& app, Context& context);
void add_pick(CLI::App& app, Context& context);
void add_stability(CLI::App& app, Context& context);
void add_cost(CLI::App& app, Context& context);
void add_ir(CLI::App& app, Context& context);
void add_lsp(CLI::App& app, Context& context);
void add_dump(CLI::App& app, Context& context);

}  // namespace cobble
