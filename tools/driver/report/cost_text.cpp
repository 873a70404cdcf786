// SPDX-License-Identifier: MIT
// A study of cost for people.
#include <fmt/core.h>

#include <algorithm>
#include <string_view>

#include "tools/driver/report/cost_report.hpp"
#include "tools/driver/report/cost_tables.hpp"
#include "tools/driver/report/excerpt.hpp"
#include "tools/driver/text.hpp"

namespace cobble::driver {
namespace {

constexpr std::size_t kMostColumns = 100;
constexpr std::size_t kLeastColumns = 60;
constexpr std::string_view kBold = "1";
constexpr std::string_view kGap = "  ";

std::size_t width_of_text(std::string_view text) {
    std::size_t width = 0;
    while (!text.empty()) {
        const CodePoint point = next_code_point(text);
        width += width_of(point.value);
        text.remove_prefix(point.bytes);
    }
    return width;
}

/// Broken at spaces; the first line begins after `indent` columns, the others at it.
std::string wrapped(std::string_view text, std::size_t indent, std::size_t columns) {
    std::string result;
    std::size_t at = indent;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        text.remove_prefix(std::min(word.size() + 1, text.size()));
        const std::size_t width = width_of_text(word);
        if (at > indent && at + 1 + width > columns) {
            result += '\n' + std::string(indent, ' ');
            at = indent;
        }
        if (at > indent) result += ' ';
        at += width + (at > indent ? 1 : 0);
        result += word;
    }
    return result;
}

std::string padded(std::string_view text, std::size_t width, bool left) {
    const std::string space(width - std::min(width, width_of_text(text)), ' ');
    return left ? std::string(text) + space : space + std::string(text);
}

class TableWriter {
  public:
    TableWriter(const CostTable& table, std::size_t columns) : table_(table), columns_(columns) {
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            std::size_t width = width_of_text(table.columns[i].title);
            for (const auto& row : table.rows) width = std::max(width, width_of_text(row[i]));
            widths_.push_back(width);
        }
    }

    std::string text() const {
        std::vector<std::string> titles;
        for (const CostColumn& column : table_.columns) titles.push_back(column.title);
        std::string text = line(titles);
        for (const auto& row : table_.rows) text += line(row);
        return text;
    }

  private:
    std::string line(const std::vector<std::string>& cells) const {
        std::string text;
        std::size_t at = 0;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            text += kGap;
            at += kGap.size();
            const bool words = table_.columns[i].words;
            text += words && i + 1 == cells.size() ? wrapped(cells[i], at, columns_)
                                                   : padded(cells[i], widths_[i], words);
            at += widths_[i];
        }
        text.erase(text.find_last_not_of(' ') + 1);
        return text + '\n';
    }

    const CostTable& table_;
    std::size_t columns_;
    std::vector<std::size_t> widths_;
};

std::string text_of(const CostTable& table, std::size_t columns, const ReportStyle& style) {
    std::string text = painted(kBold, table.title, style) + '\n';
    if (table.rows.empty()) return text + "  " + wrapped(table.missing, 2, columns) + "\n\n";
    text += "  " + wrapped(table.lead, 2, columns) + '\n';
    text += TableWriter(table, columns).text();
    for (const std::string& note : table.notes) text += "  " + wrapped(note, 2, columns) + '\n';
    return text + '\n';
}

}  // namespace

std::string cost_to_text(const renderer::CostReport& report, const ReportStyle& style) {
    const std::size_t columns = std::clamp(std::size_t{style.columns}, kLeastColumns, kMostColumns);
    std::string text = painted(kBold, "what accuracy costs in time", style) + "\n  " +
                       wrapped(cost_subject(report), 2, columns) + "\n\n";
    for (const CostTable& table :
         {curve_table(report), stage_table(report), effect_table(report), noise_table(report),
          precision_table(report), bias_table(report), rung_table(report)}) {
        text += text_of(table, columns, style);
    }
    text += painted(kBold, "recommendation", style) + '\n';
    text += "  " + wrapped(cost_recommendation(report), 2, columns) + '\n';
    return text + cost_study_time(report) + '\n';
}

}  // namespace cobble::driver
