// SPDX-License-Identifier: MIT
#include "tools/driver/walk.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <set>

#include "frontend/names/dialects.hpp"
#include "tools/driver/disk_file_source.hpp"
#include "tools/driver/ignore.hpp"

namespace cobble::driver {
namespace {

// Ignore files are lists of a few lines; a larger one is something else.
constexpr std::uint64_t kMaxIgnoreFile = 1 << 20;
// How much of a .txt file is read to see what it is.
constexpr std::size_t kSniffBytes = std::size_t{1} << 16;

constexpr std::string_view kIgnoreFiles[] = {".gitignore", ".cobbleignore"};

struct Entry {
    std::string name;
    bool is_folder = false;
};

struct Listing {
    std::vector<Entry> entries;
    int error = 0;
    int entry_error = 0;  // why the last of the entries that could not be looked at could not
};

Listing list(const std::string& folder) {
    Listing listing;
    const std::unique_ptr<DIR, int (*)(DIR*)> handle(opendir(folder.empty() ? "." : folder.c_str()),
                                                     closedir);
    if (handle == nullptr) {
        listing.error = errno;
        return listing;
    }
    while (const dirent* entry = readdir(handle.get())) {
        const std::string name = entry->d_name;
        if (name == "." || name == ".." || name == ".git") continue;
        struct stat status {};
        if (lstat((folder + name).c_str(), &status) != 0) {
            // Gone since it was listed is no loss; too long a path would hide what lies below.
            if (errno != ENOENT) listing.entry_error = errno;
            continue;
        }
        if (S_ISDIR(status.st_mode)) {
            listing.entries.push_back({name, true});
            continue;
        }
        // A link counts as the file that it leads to, but never as a folder: no walk in circles.
        const bool link = S_ISLNK(status.st_mode);
        if (link && stat((folder + name).c_str(), &status) != 0) continue;
        if (S_ISREG(status.st_mode)) listing.entries.push_back({name, false});
    }
    std::sort(listing.entries.begin(), listing.entries.end(),
              [](const Entry& a, const Entry& b) { return a.name < b.name; });
    return listing;
}

void add_rules(IgnoreRules& rules, const std::string& on_disk, const std::string& in_rules) {
    DiskFileSource disk;
    for (const std::string_view name : kIgnoreFiles) {
        const auto file = disk.read(on_disk + std::string(name), kMaxIgnoreFile);
        if (file.status == source::ReadStatus::kOk) rules.add(in_rules, file.bytes);
    }
}

// The path's own name on this machine, links followed; or as it was, if the system would not tell.
std::string real_path(const std::string& path) {
    const std::unique_ptr<char, void (*)(void*)> real(realpath(path.c_str(), nullptr), std::free);
    return real == nullptr ? path : real.get();
}

// The folder's own name on this machine, with a final '/'.
std::string absolute(const std::string& folder) {
    std::string result = folder.empty() ? real_path(".") : real_path(folder);
    if (!result.ends_with('/')) result += '/';
    return result;
}

// The rules of the folders above `folder`, from the top of its Git repository down.
void add_rules_above(IgnoreRules& rules, const std::string& folder) {
    struct stat status {};
    std::vector<std::string> above;
    for (std::string at = folder;;) {
        const bool top = stat((at + ".git").c_str(), &status) == 0;
        if (at != folder) above.push_back(at);
        if (top) break;
        // No repository: only what lies within the folder counts. A folder whose own name the
        // system would not tell (it is too long) has nothing above it that could be found.
        if (at == "/" || !at.starts_with('/')) return;
        at = at.substr(0, at.rfind('/', at.size() - 2) + 1);
    }
    for (auto at = above.rbegin(); at != above.rend(); ++at) add_rules(rules, *at, *at);
}

bool has_ending(std::string_view name, std::string_view ending) { return name.ends_with(ending); }

bool file_begins_like_a_scene(const std::string& path) {
    const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0) return false;
    std::string text(kSniffBytes, '\0');
    const ssize_t size = ::read(descriptor, text.data(), text.size());
    close(descriptor);
    text.resize(size < 0 ? 0 : static_cast<std::size_t>(size));
    return begins_like_a_scene(text);
}

class Walk {
  public:
    explicit Walk(SceneFiles& result) : result_(result) {}

    void take_file(const std::string& path) {
        // Not by what lies there: each of a file's hard links is to be fixed, as a rewritten one
        // may part from the others.
        if (!seen_.insert(real_path(path)).second) return;
        result_.paths.push_back(path);
    }

    void take_folder(const std::string& argument) {
        std::string shown = argument;
        if (!shown.ends_with('/')) shown += '/';
        while (shown.starts_with("./")) {
            shown.erase(0, std::min(shown.find_first_not_of('/', 2), shown.size()));
        }
        const std::size_t before = result_.paths.size() + result_.problems.size();
        IgnoreRules rules;
        const std::string real = absolute(shown);
        add_rules_above(rules, real);
        descend(rules, shown, real);
        if (result_.paths.size() + result_.problems.size() == before && !skipped_repeat_) {
            result_.problems.push_back(fmt::format("there is no scene in the folder {}", argument));
        }
    }

  private:
    struct Level {
        std::string shown, real;
        std::vector<Entry> entries;
        std::size_t next = 0;
        std::size_t rules_before = 0;
    };

    void enter(std::vector<Level>& levels, IgnoreRules& rules, std::string shown,
               std::string real) {
        Listing listing = list(shown);
        if (listing.error != 0) {
            result_.problems.push_back(
                fmt::format("cannot read the folder {}: {}", shown, std::strerror(listing.error)));
            return;
        }
        if (listing.entry_error != 0) {
            result_.problems.push_back(fmt::format("cannot read what is in the folder {}: {}",
                                                   shown, std::strerror(listing.entry_error)));
        }
        const std::size_t rules_before = rules.size();
        add_rules(rules, shown, real);
        levels.push_back(
            {std::move(shown), std::move(real), std::move(listing.entries), 0, rules_before});
    }

    void descend(IgnoreRules& rules, const std::string& shown, const std::string& real) {
        std::vector<Level> levels;
        enter(levels, rules, shown, real);
        while (!levels.empty()) {
            Level& level = levels.back();
            if (level.next == level.entries.size()) {
                rules.truncate(level.rules_before);
                levels.pop_back();
                continue;
            }
            const Entry& entry = level.entries[level.next++];
            if (rules.ignores(level.real + entry.name, entry.is_folder)) continue;
            const std::string path = level.shown + entry.name;
            if (entry.is_folder) {
                enter(levels, rules, path + "/", level.real + entry.name + "/");
            } else if (has_ending(entry.name, ".scene") ||
                       (has_ending(entry.name, ".txt") && file_begins_like_a_scene(path))) {
                const std::size_t count = result_.paths.size();
                take_file(path);
                skipped_repeat_ = skipped_repeat_ || result_.paths.size() == count;
            }
        }
    }

    SceneFiles& result_;
    std::set<std::string> seen_;
    bool skipped_repeat_ = false;
};

}  // namespace

bool begins_like_a_scene(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    constexpr std::string_view kSpace = " \t\r\n\v\f";
    while (!text.empty()) {
        const std::size_t start = text.find_first_not_of(kSpace);
        if (start == std::string_view::npos) return false;
        text.remove_prefix(start);
        if (!text.starts_with("//")) break;
        text.remove_prefix(std::min(text.find_first_of("\r\n"), text.size()));
    }
    const std::size_t end = std::min(text.find_first_of(" \t\r\n\v\f{}\""), text.size());
    return frontend::is_top_level_name_of_any_dialect(text.substr(0, end));
}

SceneFiles find_scenes(const std::vector<std::string>& arguments) {
    SceneFiles result;
    Walk walk(result);
    for (const std::string& argument : arguments) {
        struct stat status {};
        if (argument == "-") {
            result.paths.push_back(argument);
        } else if (stat(argument.c_str(), &status) != 0) {
            result.problems.push_back(fmt::format(
                "cannot read {}: {}", argument.empty() ? "''" : argument, std::strerror(errno)));
        } else if (S_ISDIR(status.st_mode)) {
            walk.take_folder(argument);
        } else {
            walk.take_file(argument);
        }
    }
    return result;
}

}  // namespace cobble::driver
