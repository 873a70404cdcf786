// SPDX-License-Identifier: MIT
// The grammar of tokens: how names, values and braces make blocks and fields.
//
// Input: anything that answers `is<Symbol>()` for its current token, `bump`, `recover` and
// `recover_at_end` (frontend/parse/token_input.hpp). Total: errors are alternatives that match, so
// every sequence of tokens is a `file`. There is no recursion: blocks open and close one by one,
// and the actions keep the stack. What may stand where is asked of the vocabulary, one question a
// word. Actions belong on the rules directly inside `item`, which are never undone once they have
// matched.
#pragma once

#include <tao/pegtl.hpp>
#include <tao/pegtl/contrib/analyze_traits.hpp>

namespace cobble::grammar::structure {

namespace pegtl = tao::pegtl;

/// What a token can be at its place. A token may be several of these; the order of the rules
/// decides.
enum class Symbol : unsigned char {
    kOpen,
    kClose,
    kEnd,         ///< the end of the file
    kName,        ///< any word
    kFieldName,   ///< a word that names a field of the open block
    kInlineName,  ///< a word that names a block without braces, such as Translate
    kBlockName,   ///< a word that names a block with braces
    kLabel,       ///< what is surely one: before a {, on the line of the token before it
    kBareLabel,   ///< a well-formed label that is not followed by {
    kMember,      ///< what may stand in the block just named
    kLiteral,     ///< a number or a colour
    kWordValue,   ///< a word or string directly after a field's name that is its value
    kOddValue,    ///< a malformed number, or a word where numbers are still due
    kBareValue,   ///< what a positional block holds: anything but names of blocks
    kStrayValue,  ///< a literal, string or malformed number
    kProse,       ///< a word or string after a word that is no name, on the same line
};

template <Symbol symbol>
struct token {
    using rule_t = token;
    using subs_t = pegtl::empty_list;

    template <typename Input>
    static bool match(Input& in) {
        if (!in.template is<symbol>()) return false;
        in.bump();
        return true;
    }
};

/// Goes back to an earlier token if an action found out that a brace is missing there.
struct recover {
    using rule_t = recover;
    using subs_t = pegtl::empty_list;

    template <typename Input>
    static bool match(Input& in) {
        return in.recover();
    }
};

/// The same when the file ends inside a block. Matches only if it has moved the input back, and
/// each place is gone back to once.
struct recover_at_end {
    using rule_t = recover_at_end;
    using subs_t = pegtl::empty_list;

    template <typename Input>
    static bool match(Input& in) {
        return in.recover_at_end();
    }
};

struct open : token<Symbol::kOpen> {};
struct close : token<Symbol::kClose> {};
struct end : token<Symbol::kEnd> {};
struct name : token<Symbol::kName> {};
struct field_name : token<Symbol::kFieldName> {};
struct inline_name : token<Symbol::kInlineName> {};
struct block_name : token<Symbol::kBlockName> {};
struct label : token<Symbol::kLabel> {};
struct bare_label : token<Symbol::kBareLabel> {};
struct member : token<Symbol::kMember> {};
struct literal : token<Symbol::kLiteral> {};
struct word_value : token<Symbol::kWordValue> {};
struct odd_value : token<Symbol::kOddValue> {};
struct bare_value : token<Symbol::kBareValue> {};
struct stray_value : token<Symbol::kStrayValue> {};
struct prose : token<Symbol::kProse> {};

struct values : pegtl::seq<pegtl::opt<word_value>, pegtl::star<pegtl::sor<literal, odd_value>>> {};

// What is right.
struct field : pegtl::seq<field_name, pegtl::not_at<open>, values> {};
struct inline_block : pegtl::seq<inline_name, pegtl::not_at<open>, values> {};
struct block_head : pegtl::seq<name, pegtl::opt<label>, open> {};
struct block_close : pegtl::seq<close> {};
struct numbers : pegtl::plus<bare_value> {};

// What is wrong.
struct bare_head : pegtl::seq<block_name, pegtl::opt<bare_label>, pegtl::at<member>> {};
struct lone_head : pegtl::seq<block_name, pegtl::star<stray_value>> {};
struct nameless_head : pegtl::seq<open> {};
struct stray_values : pegtl::plus<stray_value> {};
struct unknown : pegtl::seq<name, pegtl::star<prose>, pegtl::star<pegtl::sor<literal, odd_value>>> {
};
struct unfinished : pegtl::seq<pegtl::at<end>, recover_at_end> {};

struct item : pegtl::sor<field, block_close, inline_block, block_head, numbers, bare_head,
                         lone_head, nameless_head, stray_values, unknown, unfinished> {};
struct file : pegtl::seq<pegtl::star<item, pegtl::opt<recover>>, end> {};

}  // namespace cobble::grammar::structure

namespace tao::pegtl {
template <typename Name, cobble::grammar::structure::Symbol symbol>
struct analyze_traits<Name, cobble::grammar::structure::token<symbol>> : analyze_any_traits<> {};
template <typename Name>
struct analyze_traits<Name, cobble::grammar::structure::recover> : analyze_opt_traits<> {};
// It consumes in the sense of the analysis: it cannot succeed for ever.
template <typename Name>
struct analyze_traits<Name, cobble::grammar::structure::recover_at_end> : analyze_any_traits<> {};
}  // namespace tao::pegtl
