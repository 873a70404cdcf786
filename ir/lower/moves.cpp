// SPDX-License-Identifier: MIT
#include "ir/lower/moves.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "frontend/ast/views.hpp"
#include "frontend/check/vectors.hpp"
#include "ir/math/elementary.hpp"

namespace cobble::ir {
namespace {

namespace field = frontend::field;
using frontend::BlockNodeId;
using frontend::BlockView;
using grammar::BlockId;
using math::Affined;
using math::Vec3d;

template <std::size_t n>
std::optional<std::array<double, 16>> widen(const std::optional<std::array<double, n>>& values) {
    if (!values) return std::nullopt;
    std::array<double, 16> result{};
    std::copy(values->begin(), values->end(), result.begin());
    return result;
}
std::optional<std::array<double, 16>> widen(const std::optional<double>& value) {
    if (!value) return std::nullopt;
    return std::array<double, 16>{*value};
}

std::optional<std::array<double, 16>> arguments(const BlockView& view, BlockId kind) {
    switch (kind) {
        case BlockId::kTranslate:
            return widen(field::Translate_value(view));
        case BlockId::kScale:
            return widen(field::Scale_value(view));
        case BlockId::kUniformScale:
            return widen(field::UniformScale_value(view));
        case BlockId::kXRotate:
            return widen(field::XRotate_value(view));
        case BlockId::kYRotate:
            return widen(field::YRotate_value(view));
        case BlockId::kZRotate:
            return widen(field::ZRotate_value(view));
        case BlockId::kRotate:
            return widen(field::Rotate_value(view));
        case BlockId::kMatrix4f:
            return widen(field::Matrix4f_value(view));
        default:
            return std::nullopt;
    }
}

std::vector<Move> read_list(const frontend::CheckedScene& checked, BlockNodeId parent) {
    std::vector<Move> moves;
    for (const BlockNodeId child : checked.ast.children_of(parent)) {
        const auto& block = checked.ast.block(child);
        if (block.broken) continue;
        const auto numbers = arguments(BlockView(checked.tokens, checked.ast, child), block.row);
        if (numbers) moves.push_back({block.row, *numbers, *numbers});
    }
    return moves;
}

/// A rotation about a unit axis (Rodrigues' formula).
Affined rotation(Vec3d axis, double degrees) {
    const auto [s, c] = math::sincos_degrees(degrees);
    const double k = 1 - c;
    const auto [x, y, z] = axis;
    Affined result;
    result.rows[0] = {c + k * x * x, k * x * y - s * z, k * x * z + s * y, 0};
    result.rows[1] = {k * x * y + s * z, c + k * y * y, k * y * z - s * x, 0};
    result.rows[2] = {k * x * z - s * y, k * y * z + s * x, c + k * z * z, 0};
    return result;
}

/// A rotation that turns axis `from` towards axis `to`; the third row and column stay exact.
Affined axis_rotation(std::size_t from, std::size_t to, double degrees) {
    const auto [s, c] = math::sincos_degrees(degrees);
    Affined result;
    result.rows[from][from] = c;
    result.rows[from][to] = -s;
    result.rows[to][from] = s;
    result.rows[to][to] = c;
    return result;
}

Affined scaling(double x, double y, double z) {
    Affined result;
    result.rows[0][0] = x;
    result.rows[1][1] = y;
    result.rows[2][2] = z;
    return result;
}

Affined map_of(const Move& move, double time) {
    std::array<double, 16> a;
    for (std::size_t i = 0; i < a.size(); ++i) {
        // The end as it is written, not as rounding leaves it.
        a[i] = time == 1 ? move.end[i] : math::lerp(move.start[i], move.end[i], time);
    }
    switch (move.kind) {
        case BlockId::kTranslate: {
            Affined result;
            for (std::size_t i = 0; i < 3; ++i) result.rows[i][3] = a[i];
            return result;
        }
        case BlockId::kScale:
            return scaling(a[0], a[1], a[2]);
        case BlockId::kUniformScale:
            return scaling(a[0], a[0], a[0]);
        case BlockId::kXRotate:
            return axis_rotation(1, 2, a[0]);
        case BlockId::kYRotate:
            return axis_rotation(2, 0, a[0]);
        case BlockId::kZRotate:
            return axis_rotation(0, 1, a[0]);
        case BlockId::kRotate:
            return rotation(math::normalize(Vec3d{a[0], a[1], a[2]}), a[3]);
        default: {
            Affined result;  // Matrix4f, column by column
            for (std::size_t j = 0; j < 4; ++j) {
                for (std::size_t i = 0; i < 3; ++i) result.rows[i][j] = a[4 * j + i];
            }
            return result;
        }
    }
}

double degrees(double radians) { return radians * (180 / math::kPi); }

void judge(const Move& move, MoveList& list) {
    const auto& a = move.start;
    const auto& b = move.end;
    if (a == b) return;
    list.moving = true;
    const auto scale = [&](std::size_t count) {
        double largest = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const double ratio = b[i] / a[i];
            if (!(ratio > 0) || !std::isfinite(ratio)) {
                list.vanishes = true;
                return;
            }
            largest = std::max(largest, std::fabs(math::log(ratio)));
        }
        list.turn_degrees += degrees(largest);
    };
    switch (move.kind) {
        case BlockId::kScale:
            return scale(3);
        case BlockId::kUniformScale:
            return scale(1);
        case BlockId::kXRotate:
        case BlockId::kYRotate:
        case BlockId::kZRotate:
            list.turn_degrees += std::fabs(b[0] - a[0]);
            return;
        case BlockId::kRotate: {
            const Vec3d from = math::normalize(Vec3d{a[0], a[1], a[2]});
            const Vec3d to = math::normalize(Vec3d{b[0], b[1], b[2]});
            const double between = math::atan2(math::length(cross(from, to)), dot(from, to));
            list.vanishes |= frontend::are_opposite({a[0], a[1], a[2]}, {b[0], b[1], b[2]});
            list.turn_degrees += std::fabs(b[3] - a[3]) + 2 * degrees(between);
            return;
        }
        default:
            return;
    }
}

}  // namespace

MoveList read_moves(const frontend::CheckedScene& checked, BlockNodeId transform) {
    MoveList list;
    list.moves = read_list(checked, transform);
    for (const BlockNodeId child : checked.ast.children_of(transform)) {
        const auto& block = checked.ast.block(child);
        if (block.row != BlockId::kMotion || block.broken) continue;
        const std::vector<Move> ends = read_list(checked, child);
        const bool match = std::equal(ends.begin(), ends.end(), list.moves.begin(),
                                      list.moves.end(), [](const Move& a, const Move& b) {
                                          return a.kind == b.kind && a.kind != BlockId::kMatrix4f;
                                      });
        if (!match) continue;
        for (std::size_t i = 0; i < ends.size(); ++i) list.moves[i].end = ends[i].start;
    }
    for (const Move& move : list.moves) judge(move, list);
    return list;
}

Affined compose(const MoveList& list, double time) {
    Affined result;
    for (const Move& move : list.moves) {
        const Affined map = map_of(move, time);
        result = move.kind == BlockId::kMatrix4f ? map * result : result * map;
    }
    return result;
}

}  // namespace cobble::ir
