// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "tools/cobble/command.hpp"
#include "tools/driver/outputs.hpp"
#include "tools/driver/pictures.hpp"
#include "tools/driver/shards.hpp"

namespace cobble {
namespace {

struct Options {
    std::vector<std::string> shards;
    std::string output;
};

int run(const Options& options) {
    std::string problem = driver::check_distinct({options.output}, options.shards);
    if (problem.empty()) problem = driver::check_picture_path(options.output, 1, 1, 3);
    if (!problem.empty()) {
        driver::complain(problem);
        return kFailure;
    }
    driver::Merged merged = driver::merge_shards(options.shards, options.output);
    // What was encoded already is written as it is.
    if (merged.problem.empty()) {
        merged.problem = driver::write_picture(options.output, merged.plane, {});
    }
    if (merged.problem.empty()) return kDone;
    driver::complain(merged.problem);
    return kFailure;
}

}  // namespace

void add_merge(CLI::App& app, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* sub = app.add_subcommand("merge", "Join the pictures of `render --shard`");
    sub->add_option("PICTURE", options->shards, "One picture of each shard")->required();
    sub->add_option("-o", options->output, "The picture file to write")
        ->type_name("FILE")
        ->required();
    sub->callback([options, &context] { context.run = [options] { return run(*options); }; });
}

}  // namespace cobble
