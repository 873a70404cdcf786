// SPDX-License-Identifier: MIT
#include "frontend/parse/cst.hpp"
#include "frontend/parse/token_input.hpp"
#include "frontend/parse/tree_builder.hpp"
#include "grammar/structure.hpp"

namespace cobble::frontend {
namespace {

namespace structure = grammar::structure;
namespace pegtl = tao::pegtl;
using ActionInput = TokenInput::action_t;

template <typename Rule>
struct Action : pegtl::nothing<Rule> {};

// Passes the matched tokens on to a method of the builder.
template <auto method>
struct Call {
    static void apply(const ActionInput& in, TreeBuilder& builder) {
        (builder.*method)(in.begin(), in.end());
    }
};

template <NodeKind kind>
struct Error {
    static void apply(const ActionInput& in, TreeBuilder& builder) {
        builder.add_error(kind, in.begin(), in.end());
    }
};

template <bool bare>
struct Enter {
    static void apply(const ActionInput& in, TreeBuilder& builder) {
        builder.enter_block(in.begin(), bare);
    }
};

template <>
struct Action<structure::field> : Call<&TreeBuilder::add_field> {};
template <>
struct Action<structure::inline_block> : Call<&TreeBuilder::add_inline_block> {};
template <>
struct Action<structure::numbers> : Call<&TreeBuilder::add_numbers> {};
template <>
struct Action<structure::unknown> : Call<&TreeBuilder::add_unknown> {};
template <>
struct Action<structure::lone_head> : Call<&TreeBuilder::add_lone_head> {};
template <>
struct Action<structure::stray_values> : Error<NodeKind::kStrayValue> {};
template <>
struct Action<structure::block_head> : Enter<false> {};
template <>
struct Action<structure::bare_head> : Enter<true> {};

template <>
struct Action<structure::nameless_head> {
    static void apply(const ActionInput& in, TreeBuilder& builder) {
        builder.enter_nameless(in.begin());
    }
};

template <>
struct Action<structure::block_close> {
    static void apply(const ActionInput& in, TreeBuilder& builder) {
        builder.close_block(in.begin());
    }
};

}  // namespace

Cst parse(const Tokens& tokens) {
    Cst cst;
    // A node for each block and field; published scenes have 4.5 tokens a node.
    cst.nodes.reserve(tokens.size() / 4 + 16);
    TreeBuilder builder(tokens, cst);
    TokenInput in(tokens, builder);
    pegtl::parse<structure::file, Action>(in, builder);
    builder.finish(tokens.size() - 1);
    return cst;
}

}  // namespace cobble::frontend
