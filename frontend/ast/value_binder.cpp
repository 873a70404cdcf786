// SPDX-License-Identifier: MIT
#include "frontend/ast/value_binder.hpp"

#include <fmt/format.h>

#include <cmath>

#include "frontend/ast/edits.hpp"
#include "frontend/ast/name_errors.hpp"
#include "frontend/ast/numbers.hpp"
#include "frontend/ast/text_errors.hpp"
#include "frontend/lex/words.hpp"
#include "frontend/names/describe.hpp"

namespace cobble::frontend {
namespace {

using grammar::FieldRow;
using grammar::ValueType;
using source::Diagnostic;
using source::DiagnosticCode;
using source::Severity;

const DiagnosticCode kWrongArity(
    "wrong-arity", Severity::kError, "a field has too few or too many values",
    "Each field takes a fixed number of values: one for a radius, three for a vector or a colour, "
    "four for Rotate and sixteen for Matrix4f. With another number of them it is unclear which are "
    "meant, so the field is not read.",
    "DirectionalLight {\n    direction 0.5 -0.8\n    color 1 1 1\n}",
    "Write as many values as the field takes, separated by blanks: `direction 0.5 -0.8 -0.7`.");

const DiagnosticCode kWrongType(
    "wrong-type", Severity::kError, "a value is of the wrong kind",
    "Fields take numbers, colours, paths or words, each its own kind. A word where a number is "
    "due, "
    "or a number where a path is due, cannot be read.",
    "Sphere {\n    center 0 0 0\n    radius large\n}",
    "Write the kind of value that the message names. A path that looks like a number, or that is a "
    "word of the language, is put in quotes: `texture \"7\"`.");

const DiagnosticCode kMalformedNumber(
    "malformed-number", Severity::kError, "a number is not well formed",
    "Numbers are decimal: an optional sign, digits with at most one point, and an optional "
    "exponent. Suffixes, commas, hexadecimal digits, infinities and undefined values are no part "
    "of "
    "the language, because programs that read scenes disagree about them.",
    "Sphere {\n    center 0 1.2.3 0\n    radius 0.5f\n}",
    "Write a plain decimal number, such as `-0.5`, `.5`, `5.` or `1e-3`, with blanks between "
    "values.");

const DiagnosticCode kNumberOutOfRange(
    "number-out-of-range", Severity::kError, "a number is too large or too small to be stored",
    "Numbers are stored with double precision, which reaches from about 5e-324 to 1.8e308, and "
    "whole "
    "numbers with 32 bits. A value beyond that would become infinite, zero, or another number.",
    "Sphere {\n    center 0 0 0\n    radius 1e999\n}",
    "Use a value of sensible size; scale the scene if need be.");

const DiagnosticCode kNotAnInteger(
    "not-an-integer", Severity::kError, "a whole number is needed",
    "Counts, indices, octaves and blades are whole numbers. Programs that read scenes cut off the "
    "fraction or stumble over what is left of it.",
    "Noise {\n    octaves 2.5\n}", "Write a whole number: `octaves 2`.");

std::string found_phrase(std::size_t count, std::string_view unit) {
    if (count == 0) return "found nothing";
    return fmt::format("found {} {}{}", count, unit, count == 1 ? "" : "s");
}

class ValueBinder {
  public:
    ValueBinder(const FieldRow& row, const ValueRun& run, Ast& ast, Reporter& reporter)
        : row_(row), run_(run), ast_(ast), reporter_(reporter), tokens_(reporter.tokens()) {}

    FieldNode bind(NodeId cst) {
        FieldNode field{};
        field.row = row_.id;
        field.cst = cst;
        field.first_value = static_cast<std::uint32_t>(ast_.values.size());
        field.broken = !bind_all();
        field.value_count = static_cast<std::uint32_t>(ast_.values.size()) - field.first_value;
        return field;
    }

  private:
    bool bind_all() {
        const std::size_t before = ast_.values.size();
        bool good = true;
        for (std::uint32_t i = run_.begin; i < run_.end; ++i) good &= bind_one({i});
        // How many there are says nothing while some are not what they should be.
        if (!good) return false;
        const std::size_t count = ast_.values.size() - before;
        const auto due = static_cast<std::size_t>(grammar::arity(row_.type));
        if (count == due) return true;
        const bool words = grammar::is_word(row_.type) || row_.type == ValueType::kMaterialRef;
        Diagnostic& finding = reporter_.add(
            kWrongArity, run_.name,
            fmt::format("{} expects {}, {}", quoted(run_.what), expected_value(row_.type),
                        found_phrase(count, words ? "value" : "number")));
        if (!run_.hint.empty()) finding.notes.push_back(run_.hint);
        // As many tokens as values, so that the last ones are those too many: no #rrggbb is there.
        if (count > due && count == run_.end - run_.begin) point_at_extra(finding, due);
        return false;
    }

    /// Some are shown one by one, many as one.
    void point_at_extra(Diagnostic& finding, std::size_t due) const {
        constexpr std::size_t kOneByOne = 4;
        const TokenId first{run_.begin + static_cast<std::uint32_t>(due)};
        const std::size_t extra = run_.end - first.value;
        if (extra > kOneByOne) {
            finding.related.push_back({reporter_.span(first, {run_.end - 1}),
                                       fmt::format("these {} are too many", extra)});
            return;
        }
        for (std::uint32_t i = first.value; i < run_.end; ++i) {
            finding.related.push_back({reporter_.span(TokenId{i}), "this one is too many"});
        }
    }

    bool bind_one(TokenId token) {
        switch (tokens_.kind(token)) {
            case TokenKind::kNumber:
                return bind_number(token);
            case TokenKind::kColor:
                return bind_color(token);
            case TokenKind::kUnterminatedString:
                return false;  // reported once for all of them
            default:
                return bind_word(token);
        }
    }

    bool bind_number(TokenId token) {
        if (grammar::is_word(row_.type)) return wrong_type(token);
        const ParsedNumber parsed = parse_number(tokens_.text_of(token));
        if (parsed.range != NumberRange::kFine) {
            const bool large = parsed.range == NumberRange::kTooLarge;
            reporter_.add(kNumberOutOfRange, token,
                          fmt::format("{} is {} a number can be", quoted(tokens_.text_of(token)),
                                      large ? "larger than" : "nearer to zero than"));
            return false;
        }
        if (is_integer() && !check_integer(token, parsed.value)) return false;
        ast_.values.push_back({parsed.value, token});
        return true;
    }

    [[nodiscard]] bool is_integer() const {
        return row_.type == ValueType::kInteger || row_.type == ValueType::kCount ||
               row_.type == ValueType::kMaterialRef;
    }

    bool check_integer(TokenId token, double value) {
        const std::string shown = quoted(tokens_.text_of(token));
        if (value != std::floor(value)) {
            reporter_.add(kNotAnInteger, token,
                          fmt::format("{} expects {}, {} has a fraction", quoted(run_.what),
                                      expected_value(row_.type), shown));
            return false;
        }
        constexpr double kLargestInteger = 2147483647.0;  // 2^31 - 1
        if (std::fabs(value) > kLargestInteger) {
            reporter_.add(kNumberOutOfRange, token,
                          fmt::format("{} is larger than a whole number can be", shown));
            return false;
        }
        return true;
    }

    bool bind_color(TokenId token) {
        if (row_.type != ValueType::kColor) return wrong_type(token);
        for (const double component : parse_color(tokens_.text_of(token))) {
            ast_.values.push_back({component, token});
        }
        return true;
    }

    bool bind_word(TokenId token) {
        const std::string_view word = tokens_.word_of(token);
        const bool bare = tokens_.kind(token) == TokenKind::kWord;
        const bool path = grammar::is_word(row_.type) && row_.type != ValueType::kTextureFilter;
        if (!path && bare && report_invisible(token, reporter_)) return false;
        if (row_.type == ValueType::kMaterialRef) {
            if (!bare || !is_label(word)) return no_number(token);
            if (report_word_as_label(token, reporter_)) return false;
        } else if (row_.type == ValueType::kTextureFilter) {
            if (word != "nearest" && word != "bilinear") return wrong_type(token);
        } else if (!grammar::is_word(row_.type)) {
            return no_number(token);
        }
        ast_.values.push_back({0, token});
        return true;
    }

    bool no_number(TokenId token) {
        const std::string_view word = tokens_.text_of(token);
        if (tokens_.kind(token) != TokenKind::kWord || !looks_like_number(word)) {
            return wrong_type(token);
        }
        MalformedNumber malformed = explain_malformed(word);
        Diagnostic& finding = reporter_.add(kMalformedNumber, token, std::move(malformed.message));
        if (!malformed.replacement.empty()) {
            finding.fixes.push_back({fmt::format("write '{}'", malformed.replacement),
                                     true,
                                     {{reporter_.span(token), malformed.replacement}}});
        }
        return false;
    }

    bool wrong_type(TokenId token) {
        // Several words are one phrase, and one mistake.
        const bool goes_on = token.value > run_.begin && last_wrong_.value == token.value - 1;
        last_wrong_ = token;
        if (goes_on) return false;
        Diagnostic& finding =
            reporter_.add(kWrongType, token,
                          fmt::format("{} expects {}, found {}", quoted(run_.what),
                                      expected_value(row_.type), quoted(tokens_.text_of(token))));
        const std::string_view word = tokens_.text_of(token);
        if (word == "=" || word == ":") {
            finding.notes.emplace_back("values stand behind the name, with nothing but blanks");
            const ByteRange removed = removal_range(tokens_, token, token);
            finding.fixes.push_back(
                {fmt::format("remove '{}'", word), true, {{reporter_.span(removed), ""}}});
        } else if (word.size() > 1 && (word[0] == '(' || word[0] == '[') &&
                   looks_like_number(word.substr(1))) {
            finding.notes.emplace_back("values stand without brackets, separated by blanks");
            const std::string rest(word.substr(1));
            finding.fixes.push_back(
                {fmt::format("write '{}'", rest), true, {{reporter_.span(token), rest}}});
        }
        const bool path = grammar::is_word(row_.type) && row_.type != ValueType::kTextureFilter;
        if (path && tokens_.kind(token) == TokenKind::kNumber && run_.end == run_.begin + 1) {
            const std::string in_quotes = fmt::format("\"{}\"", tokens_.text_of(token));
            finding.fixes.push_back(
                {"put the path in quotes", true, {{reporter_.span(token), in_quotes}}});
        }
        return false;
    }

    const FieldRow& row_;
    const ValueRun& run_;
    Ast& ast_;
    Reporter& reporter_;
    const Tokens& tokens_;
    TokenId last_wrong_;  ///< the last value of the wrong kind
};

}  // namespace

FieldNode bind_values(const FieldRow& row, const ValueRun& run, NodeId cst, Ast& ast,
                      Reporter& reporter) {
    return ValueBinder(row, run, ast, reporter).bind(cst);
}

}  // namespace cobble::frontend
