// SPDX-License-Identifier: MIT
// .gitignore and .cobbleignore: which files a walk through folders leaves out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cobble::driver {

/// True if the glob `pattern` matches all of `path`. `*` and `?` stop at '/', `**` between slashes
/// stands for any folders, [...] is a set, a backslash takes the next character as it is. Costs
/// at most their lengths multiplied.
bool glob_matches(std::string_view pattern, std::string_view path);

/// The rules of ignore files, outermost folder first: the last that matches wins, as in Git.
class IgnoreRules {
  public:
    /// Adds the lines of an ignore file that stands in `folder` ("" or ending with '/').
    void add(std::string_view folder, std::string_view text);
    /// Forgets all rules added since size() was `size`.
    void truncate(std::size_t size) { rules_.resize(size); }
    [[nodiscard]] std::size_t size() const { return rules_.size(); }

    /// Whether the file or folder `path` is left out. A folder that is left out is not entered.
    [[nodiscard]] bool ignores(std::string_view path, bool is_folder) const;

  private:
    struct Rule {
        std::string folder;   // where the rule stands
        std::string pattern;  // relative to it
        bool negated = false;
        bool folders_only = false;
    };
    std::vector<Rule> rules_;
};

}  // namespace cobble::driver
