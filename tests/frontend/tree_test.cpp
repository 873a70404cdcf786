// SPDX-License-Identifier: MIT
// Tree cases: NAME.scene and, beside it, NAME.tree with the tree and what was bound from it.
// COBBLE_UPDATE=1 rewrites the expectations; review them before they are committed.
#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "frontend/dump/dump.hpp"
#include "tests/frontend/case_text.hpp"

using namespace cobble;
using namespace cobble::frontend;

TEST_CASE("every tree is what its expectation says") {
    const bool update = std::getenv("COBBLE_UPDATE") != nullptr;
    const auto files = test::files_in(COBBLE_ROOT "/tests/frontend/trees", ".scene");
    REQUIRE(!files.empty());
    for (const std::string& path : files) {
        CAPTURE(path);
        const std::string text = test::read_file(path);
        const Tokens tokens = lex(text);
        const Cst cst = parse(tokens);
        const BoundAst bound = bind(source::SourceId{0}, tokens, cst);
        const std::string found = dump_cst(tokens, cst) + "\n" + dump_ast(tokens, cst, bound.ast) +
                                  "\n" + test::describe(text, bound.diagnostics);
        const std::string expectation = path.substr(0, path.rfind('.')) + ".tree";
        if (update) {
            std::ofstream(expectation, std::ios::binary) << found;
            continue;
        }
        CHECK(found == test::read_file(expectation));
    }
}

TEST_CASE("tokens are dumped with their places, comments among them") {
    const std::string text = "Sphere { // round\n\tradius 1 \"a\x01\xFF\" #ff0000 \"b\n}";
    CHECK(dump_tokens(lex(text)) ==
          "1:1 word Sphere\n"
          "1:8 open {\n"
          "1:10 comment // round\n"
          "2:2 word radius\n"
          "2:9 number 1\n"
          "2:11 string \"a\\x01\\xFF\"\n"
          "2:17 color #ff0000\n"
          "2:25 unterminated-string \"b\n"
          "3:1 close }\n"
          "3:2 end\n");
}

TEST_CASE("blocks stand in the order of their nodes, and know them") {
    const std::string text =
        test::read_file(COBBLE_ROOT "/tests/frontend/cases/valid_everything.scene");
    const Tokens tokens = lex(text);
    const Cst cst = parse(tokens);
    const Ast ast = bind(source::SourceId{7}, tokens, cst).ast;
    CHECK(ast.source == source::SourceId{7});
    CHECK(!ast.blocks.empty());
    for (std::uint32_t i = 0; i < ast.blocks.size(); ++i) {
        const BlockNode& block = ast.blocks[i];
        CHECK(grammar::row(block.row).name == tokens.text_of({cst.node(block.cst).first_token}));
        if (i > 0) CHECK(ast.blocks[i - 1].cst < block.cst);
        for (const BlockNodeId child : ast.children_of(BlockNodeId{i})) {
            CHECK(ast.block(child).parent == BlockNodeId{i});
        }
    }
    for (const BlockNodeId root : ast.roots) CHECK(!ast.block(root).parent.valid());
}
