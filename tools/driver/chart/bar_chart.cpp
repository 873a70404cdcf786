// SPDX-License-Identifier: MIT
#include "tools/driver/chart/bar_chart.hpp"

#include <algorithm>
#include <cmath>

#include "tools/driver/chart/layout.hpp"
#include "tools/driver/chart/scale.hpp"

namespace cobble::driver::chart {
namespace {

constexpr double kBarHeight = 14;
constexpr double kBarGap = 2;
constexpr double kRowGap = 12;
constexpr double kTextGap = 6;
// Names and values are given so much room, and no more: the bars need the rest.
constexpr double kMostText = 220;
constexpr double kEmptyHeight = 60;

std::vector<KeyEntry> key_of(const BarChart& chart) {
    std::vector<KeyEntry> key;
    for (const BarMeasure& measure : chart.measures) {
        key.push_back({measure.name, KeyEntry::Sample::kBar, {measure.paint}, false});
    }
    return key;
}

bool has_whisker(const Bar& bar) { return std::isfinite(bar.low) && std::isfinite(bar.high); }

std::vector<double> values_of(const BarChart& chart) {
    std::vector<double> values;
    for (const BarRow& row : chart.rows) {
        for (const Bar& bar : row.bars) {
            if (!std::isfinite(bar.value)) continue;
            values.push_back(bar.value);
            if (!has_whisker(bar)) continue;
            values.push_back(bar.low);
            values.push_back(bar.high);
        }
    }
    return values;
}

class Drawing {
  public:
    explicit Drawing(const BarChart& chart)
        : chart_(chart),
          heading_(chart.legend.title, key_of(chart)),
          captions_(chart.captions),
          scale_(values_of(chart)),
          plot_(plot_of(chart, heading_.bottom())),
          captions_top_(plot_.y1 + (chart.rows.empty() ? kLineHeight : kAxisHeight)),
          svg_(kChartWidth, captions_top_ + captions_.height() + kBottom, chart.legend) {}

    std::string run() {
        heading_.draw(svg_);
        if (chart_.rows.empty()) {
            svg_.frame(plot_, {Paint::kGrid});
            svg_.text({(plot_.x0 + plot_.x1) / 2, (plot_.y0 + plot_.y1) / 2}, chart_.empty,
                      {kTextSize, Anchor::kMiddle, Paint::kSoft});
        } else {
            axis();
            double top = plot_.y0 + kRowGap / 2;
            for (const BarRow& row : chart_.rows) {
                draw_row(row, top);
                top += row_height(chart_);
            }
            svg_.line({zero(), plot_.y0}, {zero(), plot_.y1}, {Paint::kInk});
        }
        captions_.draw(svg_, captions_top_);
        return svg_.finish();
    }

  private:
    static double row_height(const BarChart& chart) {
        return static_cast<double>(chart.measures.size()) * (kBarHeight + kBarGap) + kRowGap;
    }

    static Box plot_of(const BarChart& chart, double top) {
        double names = 0;
        double texts = 0;
        for (const BarRow& row : chart.rows) {
            names = std::max(names, text_width(row.name, kTextSize));
            for (const Bar& bar : row.bars) {
                texts = std::max(texts, text_width(bar.text, kTextSize));
            }
        }
        const double height = chart.rows.empty()
                                  ? kEmptyHeight
                                  : static_cast<double>(chart.rows.size()) * row_height(chart);
        return {kMargin + std::min(names, kMostText) + kTextGap, top,
                kChartWidth - kMargin - std::min(texts, kMostText) - kTextGap, top + height};
    }

    [[nodiscard]] double x_at(double unit) const { return plot_.x0 + unit * (plot_.x1 - plot_.x0); }
    [[nodiscard]] double zero() const { return x_at(scale_.unit(0)); }

    void axis() {
        for (const Tick& tick : scale_.ticks()) {
            const double x = x_at(tick.unit);
            svg_.line({x, plot_.y0}, {x, plot_.y1}, {Paint::kGrid});
            svg_.text({x, plot_.y1 + kTickBase}, tick.label,
                      {kTextSize, Anchor::kMiddle, Paint::kSoft});
        }
        svg_.text({(plot_.x0 + plot_.x1) / 2, plot_.y1 + kAxisTitleBase}, chart_.axis_title,
                  {kTextSize, Anchor::kMiddle});
    }

    void draw_row(const BarRow& row, double top) {
        const double middle = top + (row_height(chart_) - kRowGap) / 2;
        svg_.text({plot_.x0 - kTextGap, middle + 4}, fit(row.name, kMostText, kTextSize),
                  {kTextSize, Anchor::kEnd});
        // Those that there are, in the middle.
        std::vector<std::size_t> shown;
        for (std::size_t i = 0; i < row.bars.size() && i < chart_.measures.size(); ++i) {
            const Bar& bar = row.bars[i];
            if (std::isfinite(bar.value) || !bar.text.empty()) shown.push_back(i);
        }
        double bar_top = middle - static_cast<double>(shown.size()) * (kBarHeight + kBarGap) / 2;
        for (const std::size_t i : shown) {
            draw_bar(row.bars[i], chart_.measures[i].paint, bar_top);
            bar_top += kBarHeight + kBarGap;
        }
    }

    void draw_bar(const Bar& bar, Paint paint, double top) {
        const double middle = top + kBarHeight / 2;
        double end = zero();
        if (std::isfinite(bar.value)) {
            const double x = x_at(scale_.unit(bar.value));
            svg_.rect({std::min(x, zero()), top, std::max(x, zero()), top + kBarHeight}, paint);
            end = std::max(x, zero());
            if (has_whisker(bar)) {
                const double low = x_at(scale_.unit(bar.low));
                const double high = x_at(scale_.unit(bar.high));
                svg_.line({low, middle}, {high, middle}, {Paint::kInk});
                for (const double x_end : {low, high}) {
                    svg_.line({x_end, middle - 4}, {x_end, middle + 4}, {Paint::kInk});
                }
                end = std::max(end, high);
            }
        }
        svg_.text(
            {end + kTextGap, top + kBarHeight - 3}, fit(bar.text, kMostText, kTextSize),
            {kTextSize - 1, Anchor::kStart, std::isfinite(bar.value) ? Paint::kInk : Paint::kSoft});
    }

    const BarChart& chart_;
    Heading heading_;
    Captions captions_;
    ShareScale scale_;
    Box plot_;
    double captions_top_;
    Svg svg_;
};

}  // namespace

std::string draw(const BarChart& chart) { return Drawing(chart).run(); }

}  // namespace cobble::driver::chart
