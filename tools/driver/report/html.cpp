// SPDX-License-Identifier: MIT
#include "tools/driver/report/html.hpp"

#include <fmt/core.h>

#include <cstdint>

#include "renderer/picture/picture_io.hpp"
#include "tools/driver/chart/svg.hpp"

namespace cobble::driver {
namespace {

std::string escape(std::string_view text) { return chart::escape_xml(text); }

}  // namespace

std::string sentence(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') {
        text[0] = static_cast<char>(text[0] - 'a' + 'A');
    }
    return text;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = group << 8U |
                    (k < count ? static_cast<unsigned char>(bytes[i + k]) : std::uint32_t{0});
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += k <= count ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
        }
    }
    return text;
}

std::string html_picture(const renderer::Plane32& picture, std::string_view alt) {
    if (picture.values.empty()) return {};
    const renderer::Encoded png = renderer::encode(picture, renderer::PictureFormat::kPng);
    if (!png.error.empty()) return {};
    return fmt::format(R"(<img src="data:image/png;base64,{}" width="{}" height="{}" alt="{}">)",
                       base64(png.bytes), picture.width, picture.height, escape(alt));
}

std::string html_table(const CostTable& table) {
    if (table.rows.empty()) {
        return fmt::format("<p class=\"missing\">{}.</p>\n", escape(sentence(table.missing)));
    }
    std::string html = fmt::format(
        "<p>{2}.</p>\n<div class=\"scroll\" role=\"region\" aria-labelledby=\"{0}-caption\" "
        "tabindex=\"0\">\n"
        "<table>\n<caption id=\"{0}-caption\">{1}</caption>\n<thead><tr>",
        escape(table.id), escape(sentence(table.title)), escape(sentence(table.lead)));
    for (const CostColumn& column : table.columns) {
        html += fmt::format("<th scope=\"col\"{}>{}</th>", column.words ? " class=\"words\"" : "",
                            escape(column.title));
    }
    html += "</tr></thead>\n<tbody>\n";
    for (const auto& row : table.rows) {
        html += "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string_view look = table.columns[i].words ? " class=\"words\"" : "";
            html += i == 0 ? fmt::format("<th scope=\"row\"{}>{}</th>", look, escape(row[i]))
                           : fmt::format("<td{}>{}</td>", look, escape(row[i]));
        }
        html += "</tr>\n";
    }
    html += "</tbody>\n</table>\n</div>\n";
    for (const std::string& note : table.notes) {
        html += fmt::format("<p class=\"note\">{}.</p>\n", escape(sentence(note)));
    }
    return html;
}

}  // namespace cobble::driver
