// SPDX-License-Identifier: MIT
// What each rule of the grammar of tokens does to the tree.
#pragma once

#include "frontend/parse/cst.hpp"
#include "frontend/parse/token_input.hpp"
#include "frontend/parse/tree_builder.hpp"
#include "grammar/structure.hpp"

namespace cobble::frontend {

template <typename Rule>
struct ParseAction : tao::pegtl::nothing<Rule> {};

// Passes the matched tokens on to a method of the builder.
template <auto method>
struct CallBuilder {
    static void apply(const TokenInput::action_t& in, TreeBuilder& builder) {
        (builder.*method)(in.begin(), in.end());
    }
};

template <NodeKind kind>
struct AddError {
    static void apply(const TokenInput::action_t& in, TreeBuilder& builder) {
        builder.add_error(kind, in.begin(), in.end());
    }
};

template <bool bare>
struct EnterBlock {
    static void apply(const TokenInput::action_t& in, TreeBuilder& builder) {
        builder.enter_block(in.begin(), in.end(), bare);
    }
};

template <>
struct ParseAction<grammar::structure::field> : CallBuilder<&TreeBuilder::add_field> {};
template <>
struct ParseAction<grammar::structure::inline_block> : CallBuilder<&TreeBuilder::add_inline_block> {
};
template <>
struct ParseAction<grammar::structure::numbers> : CallBuilder<&TreeBuilder::add_numbers> {};
template <>
struct ParseAction<grammar::structure::unknown> : CallBuilder<&TreeBuilder::add_unknown> {};
template <>
struct ParseAction<grammar::structure::lone_head> : CallBuilder<&TreeBuilder::add_lone_head> {};
template <>
struct ParseAction<grammar::structure::stray_values> : AddError<NodeKind::kStrayValue> {};
template <>
struct ParseAction<grammar::structure::block_head> : EnterBlock<false> {};
template <>
struct ParseAction<grammar::structure::bare_head> : EnterBlock<true> {};

template <>
struct ParseAction<grammar::structure::nameless_head> {
    static void apply(const TokenInput::action_t& in, TreeBuilder& builder) {
        builder.enter_nameless(in.begin());
    }
};

template <>
struct ParseAction<grammar::structure::block_close> {
    static void apply(const TokenInput::action_t& in, TreeBuilder& builder) {
        builder.close_block(in.begin());
    }
};

}  // namespace cobble::frontend
