// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "ir/effects.hpp"
#include "tools/cobble/arguments.hpp"
#include "tools/cobble/command.hpp"
#include "tools/cobble/usage.hpp"
#include "tools/cobble/view_options.hpp"
#include "tools/driver/load.hpp"
#include "tools/driver/report/positions.hpp"
#include "tools/driver/text.hpp"

namespace cobble {
namespace {

// The measure of a page for reading.
constexpr std::size_t kPageWidth = 80;

struct Options {
    bool listing = false;  ///< nothing is named
    std::string subject;
    std::string stdin_path;
};

// `text` in lines of at most kPageWidth bytes where words allow it, each line indented. Paragraphs
// are kept.
std::string wrapped(std::string_view text, std::string_view indent) {
    std::string result;
    std::string line(indent);
    const auto flush = [&] {
        if (line.size() > indent.size()) result += line + "\n";
        line = indent;
    };
    while (!text.empty()) {
        if (text.starts_with("\n\n")) {
            flush();
            result += "\n";
        }
        if (text.front() == ' ' || text.front() == '\n') {
            text.remove_prefix(1);
            continue;
        }
        const std::string_view word = text.substr(0, text.find_first_of(" \n"));
        if (line.size() > indent.size() && line.size() + 1 + word.size() > kPageWidth) flush();
        if (line.size() > indent.size()) line += ' ';
        line += word;
        text.remove_prefix(word.size());
    }
    flush();
    return result;
}

// A piece of scene text, each line indented.
std::string quoted(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        if (end > 0) result += "    " + std::string(text.substr(0, end));
        result += '\n';
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return result;
}

std::string_view article(source::Severity severity) {
    if (severity == source::Severity::kError) return "an error";
    return severity == source::Severity::kWarning ? "a warning" : "a remark";
}

int explain_code(const source::DiagnosticCode& code, Context& context) {
    std::string text =
        fmt::format("{}: {}\n\n{}\n{}\n", code.code, code.title, wrapped(code.why, ""),
                    wrapped(fmt::format("It is {}.", article(code.severity)), ""));
    if (!code.example.empty()) text += "For example:\n\n" + quoted(code.example) + "\n";
    if (!code.mend.empty()) text += wrapped(code.mend, "");
    context.out.write(text);
    return kDone;
}

int list_codes(Context& context) {
    for (const auto* code : source::all_codes()) {
        context.out.write(fmt::format("{:<32} {}\n", code->code, code->title));
    }
    return kDone;
}

std::string_view trimmed(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t");
    return first == std::string_view::npos ? std::string_view() : line.substr(first);
}

int explain_scene(const Options& options, Context& context) {
    const driver::LoadedScene loaded = driver::load_scene(options.subject, options.stdin_path, {});
    if (loaded.session == nullptr) {
        driver::complain(loaded.problem);
        return kFailure;
    }
    const bool broken = driver::has_errors(loaded.diagnostics);
    report_to_error(loaded, true);
    const ir::Effects effects = ir::derive_effects(loaded.lowered.scene);
    driver::Positions positions(loaded.session->sources);
    for (std::size_t i = 0; i < ir::kEffectCount; ++i) {
        const auto effect = static_cast<ir::Effect>(i);
        const ir::EffectState& state = effects.states[i];
        context.out.write(
            fmt::format("{:<16} {:<4} {}\n", ir::name_of(effect), state.on ? "on" : "off",
                        state.on ? ir::description_of(effect) : std::string_view(state.reason)));
        for (const source::Span cause : state.causes) {
            if (!cause.valid()) continue;
            const source::LineColumn at = positions.start(cause);
            constexpr std::size_t kEnough = 60;
            const std::string_view line =
                trimmed(positions.lines(cause.source).line_text(at.line)).substr(0, kEnough);
            context.out.write(fmt::format("    {}:{}:{}: {}\n",
                                          driver::printable(positions.path(cause)), at.line,
                                          at.column, driver::printable(line)));
        }
    }
    return broken ? kFindings : kDone;
}

int run(const Options& options, Context& context) {
    if (!stdin_path_is_used("explain", options.stdin_path, {options.subject})) return kFailure;
    if (options.listing) return list_codes(context);
    if (options.subject.empty()) {
        return usage_error("explain", "CODE|SCENE wants a code or a file, not ''");
    }
    if (const auto* code = source::find_code(options.subject)) return explain_code(*code, context);
    if (options.subject != "-" && access(options.subject.c_str(), F_OK) != 0) {
        const std::string similar = similar_code(options.subject);
        // With a slash or a dot it was meant as a file.
        const bool file = options.subject.find_first_of("/.") != std::string::npos;
        driver::complain(file && similar.empty()
                             ? fmt::format("cannot read {}: there is no such file", options.subject)
                             : fmt::format("there is neither a diagnostic nor a file '{}'{}",
                                           options.subject, similar));
        return kFailure;
    }
    return explain_scene(options, context);
}

}  // namespace

void add_explain(CLI::App& app, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* sub = app.add_subcommand(
        "explain", "Explain a diagnostic, or what a scene calls for from its renderer");
    const CLI::Option* subject =
        sub->add_option("CODE|SCENE", options->subject,
                        "A code such as unexpected-argument, or a scene file (./FILE is always a "
                        "file); nothing lists all codes");
    add_stdin_path(*sub, options->stdin_path);
    sub->callback([options, subject, &context] {
        options->listing = subject->count() == 0;
        context.run = [options, &context] { return run(*options, context); };
    });
}

}  // namespace cobble
