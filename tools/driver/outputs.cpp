// SPDX-License-Identifier: MIT
#include "tools/driver/outputs.hpp"

#include <fmt/core.h>
#include <sys/stat.h>

#include <optional>
#include <tuple>

#include "tools/driver/write_file.hpp"

namespace cobble::driver {
namespace {

// Device, inode, name: of the file itself and no name, or of the folder it would be in.
using Identity = std::tuple<dev_t, ino_t, std::string>;

std::optional<Identity> identity_of(const std::string& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) == 0) {
        if (!S_ISREG(status.st_mode)) return std::nullopt;
        return Identity(status.st_dev, status.st_ino, "");
    }
    const std::string target = follow_links(path);
    const auto slash = target.rfind('/');
    const bool here = slash == std::string::npos;
    const std::string folder = here ? "." : target.substr(0, slash + 1);
    if (stat(folder.c_str(), &status) != 0) return std::nullopt;
    return Identity(status.st_dev, status.st_ino, here ? target : target.substr(slash + 1));
}

}  // namespace

std::string check_distinct(const std::vector<std::string>& outputs,
                           const std::vector<std::string>& inputs) {
    std::vector<std::optional<Identity>> seen;
    for (const std::string& output : outputs) {
        const auto identity = identity_of(output);
        for (std::size_t i = 0; identity && i < seen.size(); ++i) {
            if (identity != seen[i]) continue;
            return output == outputs[i] ? output + " is asked for twice"
                                        : fmt::format("{} and {} are one file", outputs[i], output);
        }
        seen.push_back(identity);
    }
    for (const std::string& input : inputs) {
        const auto identity = identity_of(input);
        for (std::size_t i = 0; identity && i < seen.size(); ++i) {
            if (identity != seen[i]) continue;
            return fmt::format("cannot write {}: it would overwrite the input {}", outputs[i],
                               input);
        }
    }
    return {};
}

}  // namespace cobble::driver
