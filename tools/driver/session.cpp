// SPDX-License-Identifier: MIT
#include "tools/driver/session.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <tuple>
#include <utility>

#include "frontend/check/verify_fixes.hpp"
#include "tools/driver/disk_file_source.hpp"

namespace cobble::driver {
namespace {

constexpr std::uint64_t kMaxScene = 0xfffffffeU;
constexpr std::string_view kTooLarge = "it is larger than 4 GiB";

}  // namespace

ReadText read_text(const std::string& path) {
    DiskFileSource disk;
    source::ReadResult file = disk.read(path, kMaxScene);
    if (file.status == source::ReadStatus::kOk) return {std::move(file.bytes), {}};
    const bool large = file.status == source::ReadStatus::kTooLarge;
    return {{},
            fmt::format("cannot read {}: {}", path.empty() ? "''" : path,
                        large ? kTooLarge : file.reason)};
}

ReadText read_standard_input() {
    ReadText result;
    std::size_t size = 0;
    for (;;) {
        if (result.text.size() - size < 65536) result.text.resize(result.text.size() * 2 + 65536);
        const ssize_t got =
            ::read(STDIN_FILENO, result.text.data() + size, result.text.size() - size);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) {
            result.problem = fmt::format("cannot read standard input: {}", std::strerror(errno));
            break;
        }
        if (got == 0) break;
        size += static_cast<std::size_t>(got);
        if (size > kMaxScene) {
            result.problem = fmt::format("cannot read standard input: {}", kTooLarge);
            break;
        }
    }
    result.text.resize(size);
    return result;
}

Session::Session(std::string path, std::string text, Fixes fixes)
    : scene(sources.add(std::move(path), std::move(text))),
      checked(fixes == Fixes::kVerified ? frontend::check(scene, sources.text(scene))
                                        : frontend::check_unverified(scene, sources.text(scene))) {}

void apply(const SeverityRules& rules, std::vector<source::Diagnostic>& diagnostics) {
    std::erase_if(diagnostics, [&rules](const source::Diagnostic& diagnostic) {
        return rules.allowed.contains(diagnostic.code->code);
    });
    for (source::Diagnostic& diagnostic : diagnostics) {
        if (rules.denied.contains(diagnostic.code->code)) {
            diagnostic.severity = source::Severity::kError;
        }
    }
}

void sort_by_place(std::vector<source::Diagnostic>& diagnostics, source::SourceId scene) {
    const auto key = [scene](const source::Diagnostic& diagnostic) {
        const source::Span span = diagnostic.span;
        const int rank = !span.valid() ? 2 : span.source == scene ? 0 : 1;
        return std::tuple(rank, span.source.value, span.begin);
    };
    std::stable_sort(diagnostics.begin(), diagnostics.end(),
                     [&key](const auto& a, const auto& b) { return key(a) < key(b); });
}

std::vector<source::Diagnostic> lint(Session& session, source::FileSource& files,
                                     const SeverityRules& rules) {
    std::vector<source::Diagnostic> diagnostics = session.checked.diagnostics;
    for (source::Diagnostic& diagnostic :
         ir::check_assets(session.checked, session.sources, files)) {
        diagnostics.push_back(std::move(diagnostic));
    }
    apply(rules, diagnostics);
    sort_by_place(diagnostics, session.scene);
    return diagnostics;
}

bool has_errors(const std::vector<source::Diagnostic>& diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(), [](const auto& diagnostic) {
        return diagnostic.severity == source::Severity::kError;
    });
}

}  // namespace cobble::driver
