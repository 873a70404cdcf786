// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "frontend/check/checks.hpp"
#include "frontend/check/examples.hpp"
#include "frontend/check/vectors.hpp"

namespace cobble::frontend {
namespace {

const source::DiagnosticCode kUpParallel{
    "up-parallel",
    source::Severity::kError,
    "the camera's up points where it looks",
    "`up` says which way is up in the picture. If it is parallel to `direction`, left and right "
    "are unknown, and published programs draw nothing.",
    "PerspectiveCamera {\n"
    "    center 0 10 0\n"
    "    direction 0 -1 0\n"
    "    up 0 1 0\n"
    "    angle 30\n"
    "}\n",
    "Choose another `up`: a camera that looks straight down can take `0 0 -1`."};

const source::DiagnosticCode kApertureWithoutFocus{
    "aperture-without-focus",
    source::Severity::kError,
    "a lens without a distance of focus",
    "With an `aperture` above 0 only one distance is in focus, and the camera must know which.",
    camera_example("angle 30\n"
                   "aperture 0.5\n"),
    "Add `focusDistance`, measured along the view axis from `center`."};

const source::DiagnosticCode kTooFewBlades{"too-few-blades",
                                           source::Severity::kError,
                                           "an aperture of one or two blades",
                                           "One or two straight blades enclose no opening.",
                                           camera_example("angle 30\n"
                                                          "blades 2\n"),
                                           "Write 0 for a round aperture, or 3 to 16."};

const source::DiagnosticCode kShutterOrder{
    "shutter-order",
    source::Severity::kError,
    "the shutter closes before it opens",
    "`shutterOpen` must not be later than `shutterClose`; both are fractions of every Motion, from "
    "0 to 1. Equal values freeze the motion.",
    camera_example("angle 30\n"
                   "shutterOpen 0.75\n"
                   "shutterClose 0.25\n"),
    "Exchange the two."};

/// Below the sine of this angle `up` and `direction` cannot be told apart in single precision,
/// whose relative step is 2^-23.
constexpr double kParallelSine = 0x1p-23;

/// The one number of a field, if it has a usable one.
const Value* number(const CheckContext& context, const FieldNode* field) {
    if (field == nullptr || field->value_count != 1) return nullptr;
    return &context.ast().values_of(*field)[0];
}

bool mentions(const CheckContext& context, BlockNodeId id, grammar::FieldId row) {
    for (const FieldNode& field : context.ast().fields_of(id)) {
        if (field.row == row) return true;
    }
    return false;
}

void check_up(CheckContext& context, BlockNodeId id) {
    using enum grammar::FieldId;
    const FieldNode* direction_field = context.ast().find(id, kPerspectiveCamera_direction);
    const FieldNode* up_field = context.ast().find(id, kPerspectiveCamera_up);
    const auto direction = three_numbers(context, direction_field);
    const auto up = three_numbers(context, up_field);
    if (!direction || !up || is_zero(*direction) || is_zero(*up)) return;
    const double area = length(cross(*direction, *up));
    if (area > kParallelSine * (length(*direction) * length(*up))) return;
    auto& diagnostic = context.report(kUpParallel, context.value_span(*up_field),
                                      "'up' is parallel to 'direction'");
    diagnostic.related.push_back({context.value_span(*direction_field), "the direction is here"});
}

}  // namespace

void check_camera(CheckContext& context, BlockNodeId id) {
    using enum grammar::FieldId;
    const Ast& ast = context.ast();
    check_up(context, id);

    const FieldNode* aperture_field = ast.find(id, kPerspectiveCamera_aperture);
    const Value* aperture = number(context, aperture_field);
    if (aperture != nullptr && aperture->number > 0 &&
        !mentions(context, id, kPerspectiveCamera_focusDistance) && context.reliable(id) &&
        !context.explained(id, "focusDistance")) {
        context.report(kApertureWithoutFocus, context.name_span(*aperture_field),
                       "an 'aperture' needs a 'focusDistance'");
    }

    const Value* blades = number(context, ast.find(id, kPerspectiveCamera_blades));
    if (blades != nullptr && (blades->number == 1 || blades->number == 2)) {
        const source::Span place = context.span(blades->token);
        context.report(kTooFewBlades, place,
                       fmt::format("'blades' must be 0 or 3 to 16, not {}", context.shown(place)));
    }

    const FieldNode* open_field = ast.find(id, kPerspectiveCamera_shutterOpen);
    const FieldNode* close_field = ast.find(id, kPerspectiveCamera_shutterClose);
    const Value* open = number(context, open_field);
    const Value* close = number(context, close_field);
    // Their defaults, 0 and 1, cannot be out of order with a value in range.
    if (open != nullptr && close != nullptr && open->number > close->number) {
        const source::Span open_span = context.span(open->token);
        const source::Span close_span = context.span(close->token);
        auto& diagnostic =
            context.report(kShutterOrder, close_span, "'shutterClose' is before 'shutterOpen'");
        diagnostic.related.push_back({open_span, "the shutter opens here"});
        diagnostic.fixes.push_back({"exchange the two",
                                    false,
                                    {{open_span, std::string(context.text(close_span))},
                                     {close_span, std::string(context.text(open_span))}}});
    }
}

}  // namespace cobble::frontend
