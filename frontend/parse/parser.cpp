// SPDX-License-Identifier: MIT
#include "frontend/parse/actions.hpp"
#include "frontend/parse/cst.hpp"
#include "frontend/parse/token_input.hpp"
#include "frontend/parse/tree_builder.hpp"
#include "grammar/structure.hpp"

namespace cobble::frontend {

Cst parse(const Tokens& tokens) {
    Cst cst;
    // A node for each block and field; published scenes have 4.5 tokens a node.
    cst.nodes.reserve(tokens.size() / 4 + 16);
    TreeBuilder builder(tokens, cst);
    TokenInput in(tokens, builder);
    tao::pegtl::parse<grammar::structure::file, ParseAction>(in, builder);
    builder.finish(tokens.size() - 1);
    return cst;
}

}  // namespace cobble::frontend
