// SPDX-License-Identifier: MIT
// Nothing of a file is lost in its tokens and its tree, whatever it looks like.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/frontend/case_text.hpp"
#include "tests/frontend/format_mutate.hpp"
#include "tests/frontend/tree_invariants.hpp"

using namespace cobble;
using namespace cobble::frontend;

namespace {

void check_text(const std::string& text) {
    const Tokens tokens = lex(text);
    CHECK(test::rebuilt(tokens) == text);
    CHECK(test::tree_fault(tokens, parse(tokens)) == "");
}

std::string replaced(const std::string& text, char wanted, std::string_view by) {
    std::string result;
    for (const char byte : text) {
        if (byte == wanted) {
            result += by;
        } else {
            result += byte;
        }
    }
    return result;
}

std::string without_final_newline(std::string text) {
    while (text.ends_with('\n') || text.ends_with('\r')) text.pop_back();
    return text;
}

std::vector<std::string> texts() {
    std::vector<std::string> result = frontend::testing::scene_texts();
    for (const std::string& path : test::files_in(COBBLE_ROOT "/tests/frontend/cases", ".scene")) {
        result.push_back(test::read_file(path));
    }
    return result;
}

}  // namespace

TEST_CASE("every file is rebuilt from its tokens, however its lines end") {
    for (const std::string& original : texts()) {
        const std::string lf = replaced(original, '\r', "");
        check_text(original);
        check_text(lf);
        check_text(replaced(lf, '\n', "\r\n"));
        check_text(replaced(lf, '\n', "\r"));
        check_text(replaced(lf, '\n', "\v"));
        check_text(replaced(lf, ' ', "\t"));
        check_text(replaced(lf, ' ', "\f \v"));
        check_text("\xEF\xBB\xBF" + lf);
        check_text(without_final_newline(lf));
        check_text("\xEF\xBB\xBF" + without_final_newline(replaced(lf, '\n', "\r\n")));
    }
}

TEST_CASE("line ends and indentation do not change the tree of a good file") {
    const auto shape = [](const std::string& text) {
        std::string kinds;
        for (const CstNode& node : parse(lex(text)).nodes) {
            kinds += static_cast<char>('0' + node.kind);
            kinds += node.has_error != 0 ? '!' : ' ';
        }
        return kinds;
    };
    for (const std::string& path : test::files_in(COBBLE_ROOT "/scenes", ".scene")) {
        CAPTURE(path);
        const std::string text = test::read_file(path);
        const std::string expected = shape(text);
        CHECK(expected.find('!') == std::string::npos);
        CHECK(shape(replaced(text, '\n', "\r\n")) == expected);
        CHECK(shape(replaced(text, '\n', "\r")) == expected);
        CHECK(shape(replaced(text, '\n', "\n\n   ")) == expected);
        CHECK(shape(replaced(text, ' ', "\t")) == expected);
        if (text.find("//") == std::string::npos) {
            CHECK(shape(replaced(text, '\n', " ")) == expected);
        }
    }
}

TEST_CASE("damaged files keep every byte and every token") {
    const int count = frontend::testing::wanted_runs(4000);
    const std::vector<std::string> originals = texts();
    frontend::testing::Random random(1);
    for (int i = 0; i < count; ++i) {
        std::string text = originals[random.below(originals.size())];
        if (text.size() > 8000) text.resize(8000);
        const std::string& other = originals[random.below(originals.size())];
        for (std::size_t changes = 1 + random.below(6); changes > 0; --changes) {
            frontend::testing::mutate(text, other, random);
        }
        CAPTURE(i);
        CAPTURE(text);
        const Tokens tokens = lex(text);
        REQUIRE(test::rebuilt(tokens) == text);
        REQUIRE(test::tree_fault(tokens, parse(tokens)) == "");
    }
}
