// SPDX-License-Identifier: MIT
// Cases of the editor questions: tests/frontend/editor/cases/QUESTION_NAME.scene, in which `<|>` is
// a cursor, and what is answered in QUESTION_NAME.expected. COBBLE_UPDATE=1 rewrites the
// expectations; read them before committing.
#include <doctest/doctest.h>

#include <filesystem>
#include <set>
#include <string>

#include "tests/frontend/case_text.hpp"
#include "tests/frontend/editor/answers.hpp"
#include "tests/support/golden.hpp"

namespace cobble::frontend::editor {
namespace {

namespace fs = std::filesystem;

TEST_CASE("every editor question answers as its cases say") {
    const std::string folder = "tests/frontend/editor/cases";
    std::set<std::string> asked;
    for (const std::string& path : test::files_in(fs::path(COBBLE_ROOT) / folder, ".scene")) {
        const std::string name = fs::path(path).stem().string();
        CAPTURE(name);
        const std::string question = name.substr(0, name.find('_'));
        asked.insert(question);
        const auto marked = testing::read_marks(test::read_file(path));
        const std::string answer = testing::answer(question, marked);
        CHECK(!answer.empty());
        std::string expected = folder;
        expected.append("/").append(name).append(".expected");
        test::check_golden(expected, answer);
    }
    CHECK(asked == std::set<std::string>{"colors", "completion", "hover", "links", "outline",
                                         "references", "selections", "signature", "tokens"});
}

}  // namespace
}  // namespace cobble::frontend::editor
