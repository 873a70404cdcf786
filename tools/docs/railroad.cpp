// SPDX-License-Identifier: MIT
// Railroad diagrams. Every expression becomes a box on a rail: it enters at its left end and leaves
// at its right end at the same height, and knows how far it reaches above and below.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>

#include "tools/docs/expression.hpp"

namespace cobble::docs {
namespace {

// All in pixels. A monospaced character of 13 px is 7.8 px wide in nearly every font; textLength
// makes it so in the others.
constexpr double kCharWidth = 7.8;
constexpr double kHalfBox = 12;  // half the height of a box with one line of text
constexpr double kPadding = 10;  // between a box's border and its text
constexpr double kGap = 12;      // rail between two boxes
constexpr double kRadius = 9;    // of the bends
constexpr double kRowGap = 8;    // between the rows of a choice
constexpr double kMargin = 16;
constexpr double kTitleHeight = 26;

constexpr std::string_view kHead =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0:.0f}" height="{1:.0f}" viewBox="0 0 {0:.0f} {1:.0f}">
<style>
.back {{ fill: #fffdf8; }}
path {{ fill: none; stroke: #4a4a4a; stroke-width: 1.6; }}
rect.text {{ fill: #dff0e0; stroke: #3d7a45; }}
rect.rule {{ fill: #e3ecf9; stroke: #3a639e; }}
rect.class {{ fill: #fbf0d9; stroke: #a3782a; }}
rect.ahead {{ fill: none; stroke: #8a8a8a; stroke-dasharray: 4 3; }}
text {{ font: 13px "DejaVu Sans Mono", Menlo, Consolas, monospace; fill: #1f1f1f; }}
text.box {{ text-anchor: middle; }}
text.class, text.note {{ font-style: italic; }}
text.note {{ font-size: 11px; fill: #5a5a5a; text-anchor: middle; }}
text.title {{ font-weight: bold; }}
</style>
<rect class="back" width="{0:.0f}" height="{1:.0f}" rx="6"/>
)";

std::string escape(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '&':
                result += "&amp;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

/// One expression laid out.
struct Box {
    Form form;
    std::string text;
    std::vector<Box> parts;
    double width = 0;
    double up = 0;    ///< above the rail
    double down = 0;  ///< below it
};

double text_width(std::string_view text) { return static_cast<double>(text.size()) * kCharWidth; }

Box lay_out(const Expression& expression);

Box leaf(Form form, std::string text) {
    Box box{form, std::move(text), {}, 0, kHalfBox, kHalfBox};
    box.width = text_width(box.text) + 2 * kPadding;
    return box;
}

Box sequence(std::vector<Box> parts) {
    Box box{Form::kSequence, {}, std::move(parts)};
    for (const Box& part : box.parts) {
        box.width += part.width + (&part == &box.parts.front() ? 0 : kGap);
        box.up = std::max(box.up, part.up);
        box.down = std::max(box.down, part.down);
    }
    return box;
}

/// The first part on the rail, the others below it.
Box choice(std::vector<Box> parts) {
    Box box{Form::kChoice, {}, std::move(parts)};
    double inner = 0;
    for (const Box& part : box.parts) inner = std::max(inner, part.width);
    box.width = inner + 4 * kRadius;
    box.up = box.parts[0].up;
    box.down = box.parts[0].down;
    for (std::size_t i = 1; i < box.parts.size(); ++i) {
        const double step = std::max(box.down + kRowGap + box.parts[i].up, 2 * kRadius);
        box.down = step + box.parts[i].down;
    }
    return box;
}

Box around(Form form, Box inner) {
    Box box{form, {}, {}};
    box.width = inner.width + 4 * kRadius;
    box.up = inner.up;
    box.down = inner.down;
    if (form == Form::kOptional || form == Form::kMany) {
        box.up = std::max(inner.up + kRowGap, 2 * kRadius);
    }
    if (form == Form::kSome || form == Form::kMany) {
        box.down = std::max(inner.down + kRowGap, 2 * kRadius);
    }
    box.parts.push_back(std::move(inner));
    return box;
}

// The recursion is as deep as the grammar's source is nested.
Box lay_out(const Expression& expression) {
    std::vector<Box> parts;
    for (const Expression& part : expression.parts) parts.push_back(lay_out(part));
    switch (expression.form) {
        case Form::kText:
        case Form::kClass:
        case Form::kRule:
            return leaf(expression.form, expression.text);
        case Form::kSequence:
            return sequence(std::move(parts));
        case Form::kChoice:
            return choice(std::move(parts));
        case Form::kRepeat: {
            Box box = around(Form::kSome, std::move(parts[0]));
            box.text = fmt::format("{} times", expression.count);
            box.down += kRowGap + 6;
            return box;
        }
        case Form::kAhead:
        case Form::kNotAhead: {
            Box inner = std::move(parts[0]);
            Box box{expression.form,
                    expression.form == Form::kAhead ? "only before" : "not before",
                    {}};
            box.width = std::max(inner.width, text_width(box.text)) + 2 * kPadding;
            box.up = inner.up + kRowGap + 14;
            box.down = inner.down + kRowGap;
            box.parts.push_back(std::move(inner));
            return box;
        }
        default:
            return around(expression.form, std::move(parts[0]));
    }
}

class Painter {
  public:
    explicit Painter(std::string& out) : out_(out) {}

    void title(double x, double y, std::string_view name) {
        put(R"(<text class="title" x="{:.1f}" y="{:.1f}">{}</text>)", x, y, escape(name));
    }

    void rail(double x, double y, double length) {
        if (length > 0) put(R"(<path d="M{:.1f} {:.1f}h{:.1f}"/>)", x, y, length);
    }

    void station(double x, double y) { put(R"(<path d="M{:.1f} {:.1f}v16m5 -16v16"/>)", x, y - 8); }

    void box(const Box& box, double x, double y) {
        switch (box.form) {
            case Form::kText:
            case Form::kClass:
            case Form::kRule:
                leaf(box, x, y);
                break;
            case Form::kSequence:
                for (const Box& part : box.parts) {
                    this->box(part, x, y);
                    x += part.width;
                    if (&part != &box.parts.back()) rail(x, y, kGap);
                    x += kGap;
                }
                break;
            case Form::kChoice:
                choice(box, x, y);
                break;
            case Form::kAhead:
            case Form::kNotAhead:
                ahead(box, x, y);
                break;
            default:
                loop(box, x, y);
        }
    }

  private:
    template <typename... Args>
    void put(fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
        out_ += '\n';
    }

    void leaf(const Box& box, double x, double y) {
        const char* kind = box.form == Form::kText   ? "text"
                           : box.form == Form::kRule ? "rule"
                                                     : "class";
        put(R"(<rect class="{}" x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.0f}" rx="{}"/>)",
            kind, x, y - kHalfBox, box.width, 2 * kHalfBox, box.form == Form::kRule ? 2 : 12);
        put(R"(<text class="box {}" x="{:.1f}" y="{:.1f}" textLength="{:.1f}">{}</text>)", kind,
            x + box.width / 2, y + 4.5, text_width(box.text), escape(box.text));
    }

    void centred(const Box& part, double x, double y, double width) {
        const double side = (width - part.width) / 2;
        rail(x, y, side);
        box(part, x + side, y);
        rail(x + side + part.width, y, side);
    }

    void choice(const Box& box, double x, double y) {
        const double inner = box.width - 4 * kRadius;
        rail(x, y, 2 * kRadius);
        centred(box.parts[0], x + 2 * kRadius, y, inner);
        rail(x + box.width - 2 * kRadius, y, 2 * kRadius);
        double below = box.parts[0].down;
        for (std::size_t i = 1; i < box.parts.size(); ++i) {
            const Box& part = box.parts[i];
            const double step = std::max(below + kRowGap + part.up, 2 * kRadius);
            put(R"(<path d="M{0:.1f} {1:.1f}a{2} {2} 0 0 1 {2} {2}v{3:.1f}a{2} {2} 0 0 0 {2} {2}"/>)",
                x, y, kRadius, step - 2 * kRadius);
            centred(part, x + 2 * kRadius, y + step, inner);
            put(R"(<path d="M{0:.1f} {1:.1f}a{2} {2} 0 0 0 {2} -{2}v{3:.1f}a{2} {2} 0 0 1 {2} -{2}"/>)",
                x + box.width - 2 * kRadius, y + step, kRadius, 2 * kRadius - step);
            below = step + part.down;
        }
    }

    void loop(const Box& box, double x, double y) {
        const Box& part = box.parts[0];
        rail(x, y, 2 * kRadius);
        this->box(part, x + 2 * kRadius, y);
        rail(x + box.width - 2 * kRadius, y, 2 * kRadius);
        if (box.form != Form::kSome) {  // a way past it, above
            put(R"(<path d="M{0:.1f} {1:.1f}a{2} {2} 0 0 0 {2} -{2}v{3:.1f}a{2} {2} 0 0 1 {2} -{2}h{4:.1f}a{2} {2} 0 0 1 {2} {2}v{5:.1f}a{2} {2} 0 0 0 {2} {2}"/>)",
                x, y, kRadius, 2 * kRadius - box.up, part.width, box.up - 2 * kRadius);
        }
        if (box.form != Form::kOptional) {  // a way back, below
            const double depth = std::max(part.down + kRowGap, 2 * kRadius);
            const double left = x + 2 * kRadius;
            put(R"(<path d="M{0:.1f} {1:.1f}a{2} {2} 0 0 0 -{2} {2}v{3:.1f}a{2} {2} 0 0 0 {2} {2}h{4:.1f}a{2} {2} 0 0 0 {2} -{2}v{5:.1f}a{2} {2} 0 0 0 -{2} -{2}"/>)",
                left, y, kRadius, depth - 2 * kRadius, part.width, 2 * kRadius - depth);
            // An arrow head that shows the way back.
            put(R"(<path d="M{:.1f} {:.1f}l-5 4l5 4"/>)", left + part.width / 2 - 2, y + depth - 4);
            if (!box.text.empty()) {
                put(R"(<text class="note" x="{:.1f}" y="{:.1f}">{}</text>)", left + part.width / 2,
                    y + depth + 14, box.text);
            }
        }
    }

    void ahead(const Box& box, double x, double y) {
        put(R"(<rect class="ahead" x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" rx="4"/>)",
            x, y - box.up, box.width, box.up + box.down);
        put(R"(<text class="note" x="{:.1f}" y="{:.1f}">{}</text>)", x + box.width / 2,
            y - box.up + 14, box.text);
        const Box& part = box.parts[0];
        this->box(part, x + (box.width - part.width) / 2, y);
    }

    std::string& out_;
};

}  // namespace

std::string railroad(const Grammar& rules) {
    constexpr double kStation = 5;
    std::vector<Box> boxes;
    double width = 0;
    double height = kMargin;
    for (const Rule& rule : rules) {
        boxes.push_back(lay_out(rule.body));
        const Box& box = boxes.back();
        width = std::max({width, box.width + 2 * (kStation + kGap), text_width(rule.name)});
        height += kTitleHeight + box.up + box.down + kMargin;
    }
    std::string out = fmt::format(fmt::runtime(kHead), width + 2 * kMargin, height);
    Painter painter(out);
    double y = kMargin;
    for (std::size_t i = 0; i < rules.size(); ++i) {
        const Box& box = boxes[i];
        painter.title(kMargin, y + 10, rules[i].name);
        const double rail = y + kTitleHeight + box.up;
        painter.station(kMargin, rail);
        painter.rail(kMargin + kStation, rail, kGap);
        painter.box(box, kMargin + kStation + kGap, rail);
        const double right = kMargin + kStation + kGap + box.width;
        painter.rail(right, rail, kGap);
        painter.station(right + kGap, rail);
        y += kTitleHeight + box.up + box.down + kMargin;
    }
    return out + "</svg>\n";
}

}  // namespace cobble::docs
