// SPDX-License-Identifier: MIT
// Typed reading of AST fields, generated from the vocabulary:
// `field::Sphere_radius(BlockView(tokens, ast, id))` is an optional<double>.
//
// A getter gives the value that counts, or nothing where the field is absent or broken; defaults
// are the reader's business. Vectors and colours are arrays, paths are views into the text.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "frontend/ast/ast.hpp"
#include "frontend/lex/tokens.hpp"

namespace cobble::frontend {

class BlockView {
  public:
    BlockView(const Tokens& tokens, const Ast& ast, BlockNodeId id)
        : tokens_(&tokens), ast_(&ast), id_(id) {}

    [[nodiscard]] BlockNodeId id() const { return id_; }
    [[nodiscard]] const FieldNode* field(grammar::FieldId row) const {
        return ast_->find(id_, row);
    }

    template <grammar::ValueType type>
    [[nodiscard]] auto get(grammar::FieldId row) const {
        using enum grammar::ValueType;
        if constexpr (type == kNumber) {
            return one(numbers<1>(row));
        } else if constexpr (type == kInteger || type == kCount) {
            return integer(row);
        } else if constexpr (type == kVector2) {
            return numbers<2>(row);
        } else if constexpr (type == kVector3 || type == kColor) {
            return numbers<3>(row);
        } else if constexpr (type == kNumbers4) {
            return numbers<4>(row);
        } else if constexpr (type == kNumbers16) {
            return numbers<16>(row);
        } else {
            return word(row);
        }
    }

  private:
    template <std::size_t n>
    [[nodiscard]] std::optional<std::array<double, n>> numbers(grammar::FieldId row) const {
        const FieldNode* found = field(row);
        if (found == nullptr || found->value_count < n) return std::nullopt;
        std::array<double, n> result;
        const auto values = ast_->values_of(*found);
        for (std::size_t i = 0; i < n; ++i) result[i] = values[i].number;
        return result;
    }
    static std::optional<double> one(const std::optional<std::array<double, 1>>& numbers) {
        return numbers ? std::optional<double>((*numbers)[0]) : std::nullopt;
    }
    [[nodiscard]] std::optional<int> integer(grammar::FieldId row) const {
        const auto number = one(numbers<1>(row));
        return number ? std::optional<int>(static_cast<int>(*number)) : std::nullopt;
    }
    [[nodiscard]] std::optional<std::string_view> word(grammar::FieldId row) const {
        const FieldNode* found = field(row);
        if (found == nullptr || found->value_count < 1) return std::nullopt;
        return tokens_->word_of(ast_->values_of(*found)[0].token);
    }

    const Tokens* tokens_;
    const Ast* ast_;
    BlockNodeId id_;
};

// One function per field: `field::Sphere_radius(view)`.
namespace field {
#define COBBLE_FIELD(block, id, type, range, unit, fallback, presence, repeat, doc)   \
    inline auto block##_##id(const BlockView& view) {                                 \
        return view.get<grammar::ValueType::type>(grammar::FieldId::k##block##_##id); \
    }
#include "grammar/vocabulary.def"
}  // namespace field

}  // namespace cobble::frontend
