// SPDX-License-Identifier: MIT
#include "tools/driver/chart/svg.hpp"

#include <fmt/core.h>

#include <cmath>

#include "tools/driver/text.hpp"

namespace cobble::driver::chart {
namespace {

constexpr std::string_view kFonts =
    "system-ui, -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, 'DejaVu Sans', "
    "sans-serif";

// Bold letters of the common fonts are up to a ninth wider than plain ones.
constexpr double kBoldRatio = 1.12;

// In units of the font's size; DejaVu Sans, rounded up in classes.
double width_of_letter(std::uint32_t letter) {
    if (width_of(letter) != 1) return width_of(letter);
    if (letter >= 0x80) return 1;
    const char c = static_cast<char>(letter);
    if (std::string_view("ijlI'|").find(c) != std::string_view::npos) return 0.34;
    if (std::string_view(" .,:;-()[]/!ftr").find(c) != std::string_view::npos) return 0.42;
    if (std::string_view("mwMW%@").find(c) != std::string_view::npos) return 1.01;
    if (c >= 'A' && c <= 'Z') return 0.79;
    if (std::string_view("#&+<=>^_~").find(c) != std::string_view::npos) return 0.84;
    return 0.65;
}

std::string_view dashes_of(Dash dash) {
    switch (dash) {
        case Dash::kSolid:
            return "";
        case Dash::kDashed:
            return " stroke-dasharray=\"6 4\"";
        case Dash::kDotted:
            return " stroke-dasharray=\"1.5 3.5\"";
    }
    return "";
}

std::string_view name_of(Anchor anchor) {
    switch (anchor) {
        case Anchor::kStart:
            return "";
        case Anchor::kMiddle:
            return " text-anchor=\"middle\"";
        case Anchor::kEnd:
            return " text-anchor=\"end\"";
    }
    return "";
}

std::string filled(Paint paint) {
    return fmt::format(R"(class="fill-{}" fill="{}")", name_of(paint), color_of(paint));
}

std::string stroked(const Stroke& stroke) {
    return fmt::format(R"(class="stroke-{}" fill="none" stroke="{}" stroke-width="{}"{})",
                       name_of(stroke.paint), color_of(stroke.paint), coordinate(stroke.width),
                       dashes_of(stroke.dash));
}

// Over the lines and bands that they lie on: open marks are filled with paper.
std::string outlined(Paint paint) {
    return fmt::format(R"(class="fill-paper stroke-{}" fill="{}" stroke="{}" stroke-width="1.75")",
                       name_of(paint), color_of(Paint::kPaper), color_of(paint));
}

std::string list_of(std::span<const Point> points) {
    std::string list;
    for (const Point& p : points) {
        list += fmt::format("{}{},{}", list.empty() ? "" : " ", coordinate(p.x), coordinate(p.y));
    }
    return list;
}

std::string opacity_of(double opacity) {
    return opacity < 1 ? fmt::format(R"( fill-opacity="{}")", coordinate(opacity)) : "";
}

}  // namespace

std::string escape_xml(std::string_view text) {
    std::string result;
    for (const char c : printable(text)) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            case '\'':
                result += "&#39;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

std::string coordinate(double value) {
    if (!std::isfinite(value)) return "0";
    std::string text = fmt::format("{:.2f}", value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

double text_width(std::string_view text, double size, bool bold) {
    double sum = 0;
    while (!text.empty()) {
        const CodePoint point = next_code_point(text);
        sum += width_of_letter(point.value);
        text.remove_prefix(point.bytes);
    }
    return sum * size * (bold ? kBoldRatio : 1);
}

std::string fit(std::string_view text, double width, double size) {
    constexpr std::string_view kMore = "…";
    if (text_width(text, size) <= width) return std::string(text);
    std::size_t end = 0;
    for (;;) {
        const std::size_t next = end + next_code_point(text.substr(end)).bytes;
        if (next == end || text_width(text.substr(0, next), size) + text_width(kMore, size) > width)
            break;
        end = next;
    }
    return std::string(text.substr(0, end)) + std::string(kMore);
}

std::vector<std::string> wrap(std::string_view text, double width, double size) {
    std::vector<std::string> lines;
    std::string line;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        const std::string_view word = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (word.empty()) continue;
        std::string longer = line.empty() ? std::string(word) : line + ' ' + std::string(word);
        if (!line.empty() && text_width(longer, size) > width) {
            lines.push_back(std::move(line));
            longer = word;
        }
        line = std::move(longer);
    }
    if (!line.empty()) lines.push_back(std::move(line));
    return lines;
}

Svg::Svg(double width, double height, const Legend& legend) {
    text_ = fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" height="{1}" role="img" aria-labelledby="{2}-title {2}-description" font-family="{3}">
<title id="{2}-title">{4}</title>
<desc id="{2}-description">{5}</desc>
)",
        coordinate(width), coordinate(height), escape_xml(legend.id), kFonts,
        escape_xml(legend.title), escape_xml(legend.description));
    rect({0, 0, width, height}, Paint::kPaper);
}

void Svg::rect(const Box& box, Paint fill, double opacity) {
    text_ += fmt::format(R"(<rect x="{}" y="{}" width="{}" height="{}" {}{}/>)", coordinate(box.x0),
                         coordinate(box.y0), coordinate(box.x1 - box.x0),
                         coordinate(box.y1 - box.y0), filled(fill), opacity_of(opacity)) +
             "\n";
}

void Svg::frame(const Box& box, const Stroke& stroke) {
    text_ += fmt::format(R"(<rect x="{}" y="{}" width="{}" height="{}" {}/>)", coordinate(box.x0),
                         coordinate(box.y0), coordinate(box.x1 - box.x0),
                         coordinate(box.y1 - box.y0), stroked(stroke)) +
             "\n";
}

void Svg::line(Point from, Point to, const Stroke& stroke) {
    text_ += fmt::format(R"(<line x1="{}" y1="{}" x2="{}" y2="{}" {}/>)", coordinate(from.x),
                         coordinate(from.y), coordinate(to.x), coordinate(to.y), stroked(stroke)) +
             "\n";
}

void Svg::polyline(std::span<const Point> points, const Stroke& stroke) {
    text_ += fmt::format(R"(<polyline points="{}" {}/>)", list_of(points), stroked(stroke)) + "\n";
}

void Svg::polygon(std::span<const Point> points, Paint fill, double opacity) {
    text_ += fmt::format(R"(<polygon points="{}" {}{}/>)", list_of(points), filled(fill),
                         opacity_of(opacity)) +
             "\n";
}

void Svg::mark(Point at, Mark mark, Paint paint, std::string_view tip) {
    std::string shape;
    const auto circle = [&](std::string_view radius, const std::string& look) {
        shape = fmt::format(R"(circle cx="{}" cy="{}" r="{}" {})", coordinate(at.x),
                            coordinate(at.y), radius, look);
    };
    const auto diamond = [&](const std::string& look) {
        const Point corners[] = {{at.x, at.y - kMarkRadius},
                                 {at.x + kMarkRadius, at.y},
                                 {at.x, at.y + kMarkRadius},
                                 {at.x - kMarkRadius, at.y}};
        shape = fmt::format(R"(polygon points="{}" {})", list_of(corners), look);
    };
    switch (mark) {
        case Mark::kNone:
            return;
        case Mark::kDot:
            circle("3.5", filled(paint));
            break;
        case Mark::kRing:
            circle("3.5", outlined(paint));
            break;
        case Mark::kDiamond:
            diamond(filled(paint));
            break;
        case Mark::kHollowDiamond:
            diamond(outlined(paint));
            break;
    }
    if (tip.empty()) {
        text_ += fmt::format("<{}/>\n", shape);
    } else {
        const std::string_view name = std::string_view(shape).substr(0, shape.find(' '));
        text_ += fmt::format("<{}><title>{}</title></{}>\n", shape, escape_xml(tip), name);
    }
}

void Svg::text(Point at, std::string_view text, const TextStyle& style) {
    const std::string x = coordinate(at.x);
    const std::string y = coordinate(at.y);
    text_ +=
        fmt::format(R"(<text x="{}" y="{}" font-size="{}"{}{}{} {}>{}</text>)", x, y,
                    coordinate(style.size), name_of(style.anchor),
                    style.bold ? " font-weight=\"bold\"" : "",
                    style.upwards ? fmt::format(R"-( transform="rotate(-90 {} {})")-", x, y) : "",
                    filled(style.paint), escape_xml(text)) +
        "\n";
}

}  // namespace cobble::driver::chart
