// SPDX-License-Identifier: MIT
#include "tools/driver/load.hpp"

#include <chrono>
#include <utility>

#include "tools/driver/disk_file_source.hpp"

namespace cobble::driver {
namespace {

class StopWatch {
  public:
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const double seconds = std::chrono::duration<double>(now - start_).count();
        start_ = now;
        return seconds;
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

LoadedScene check_scene(const std::string& path, const std::string& stdin_path) {
    LoadedScene result;
    StopWatch watch;
    const bool standard_input = path == "-";
    ReadText file = standard_input ? read_standard_input() : read_text(path);
    result.read_seconds = watch.lap();
    result.problem = std::move(file.problem);
    if (!result.problem.empty()) return result;
    result.files.push_back(standard_input ? "/dev/stdin" : path);
    if (standard_input && !stdin_path.empty()) result.files.push_back(stdin_path);
    const std::string input_path = stdin_path.empty() ? "<stdin>" : stdin_path;
    result.session =
        std::make_unique<Session>(standard_input ? input_path : path, std::move(file.text));
    result.diagnostics = result.session->checked.diagnostics;
    result.check_seconds = watch.lap();
    sort_by_place(result.diagnostics, result.session->scene);
    return result;
}

LoadedScene load_scene(const std::string& path, const std::string& stdin_path,
                       const ir::LowerOptions& options) {
    LoadedScene result = check_scene(path, stdin_path);
    if (result.session == nullptr) return result;
    StopWatch watch;
    DiskFileSource disk;
    result.lowered = ir::lower(result.session->checked, result.session->sources, disk, options);
    for (const source::Diagnostic& diagnostic : result.lowered.diagnostics) {
        result.diagnostics.push_back(diagnostic);
    }
    result.files.insert(result.files.end(), disk.read_paths().begin(), disk.read_paths().end());
    result.lower_seconds = watch.lap();
    sort_by_place(result.diagnostics, result.session->scene);
    return result;
}

}  // namespace cobble::driver
