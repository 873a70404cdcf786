// SPDX-License-Identifier: MIT
#include "tools/bench/timing.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace cobble::bench {

std::optional<ProcessTime> run_process(const std::vector<std::string>& command) {
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
        posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_WRONLY, 0);
    }
    const Clock::time_point begin = Clock::now();
    pid_t child = 0;
    const int error =
        posix_spawn(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    int status = 0;
    struct rusage usage {};
    if (error != 0 || wait4(child, &status, 0, &usage) != child) return std::nullopt;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) * 1e-6;
    };
    return ProcessTime{seconds_since(begin), seconds(usage.ru_utime) + seconds(usage.ru_stime)};
}

TemporaryFile::TemporaryFile(const std::string& contents, const std::string& ending)
    : path_((std::filesystem::temp_directory_path() / ("cobble-bench-XXXXXX" + ending)).string()) {
    const int file = mkstemps(path_.data(), static_cast<int>(ending.size()));
    if (file < 0) {
        std::perror(path_.c_str());
        std::exit(1);
    }
    close(file);
    std::ofstream(path_, std::ios::binary) << contents;
}

TemporaryFile::~TemporaryFile() { unlink(path_.c_str()); }

}  // namespace cobble::bench
