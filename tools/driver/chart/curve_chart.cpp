// SPDX-License-Identifier: MIT
#include "tools/driver/chart/curve_chart.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "tools/driver/chart/curve_plot.hpp"
#include "tools/driver/chart/layout.hpp"

namespace cobble::driver::chart {
namespace {

// From the top of a name's box to its base line.
constexpr double kNameBase = 11;

// What has nothing to show is not explained.
std::vector<KeyEntry> key_of(const CurveChart& chart) {
    std::vector<KeyEntry> key;
    for (const Series& series : chart.series) {
        if (!has_place(series)) continue;
        key.push_back({series.name,
                       KeyEntry::Sample::kLine,
                       {series.paint, 2, series.dash},
                       series.line,
                       series.mark});
        if (series.band_name.empty()) continue;
        key.push_back({series.band_name, KeyEntry::Sample::kShade, {series.paint}, false});
    }
    return key;
}

// With what the chart could not show.
std::vector<std::string> captions_of(const CurveChart& chart, const CurvePlot& plot) {
    std::vector<std::string> captions = chart.captions;
    const auto points = [](std::ptrdiff_t count) {
        return fmt::format("{} point{}", count, count == 1 ? "" : "s");
    };
    std::ptrdiff_t lost = 0;
    for (const Series& series : chart.series) {
        lost += std::count_if(series.points.begin(), series.points.end(),
                              [](const CurvePoint& point) { return !has_place(point); });
    }
    if (lost > 0) {
        captions.push_back(
            fmt::format("Not shown, as logarithmic axes have no place for 0 and for what was not "
                        "measured: {}.",
                        points(lost)));
    }
    const auto nameless = std::count_if(plot.names().begin(), plot.names().end(),
                                        [](const PlacedName& name) { return !name.place.placed; });
    if (nameless > 0) {
        captions.push_back(
            fmt::format("Without its name, for there was no room: {}.", points(nameless)));
    }
    return captions;
}

class Drawing {
  public:
    explicit Drawing(const CurveChart& chart)
        : chart_(chart),
          heading_(chart.legend.title, key_of(chart)),
          plot_(chart, heading_.bottom()),
          captions_(captions_of(chart, plot_)),
          captions_top_(plot_.box().y1 + kAxisHeight),
          svg_(kChartWidth, captions_top_ + captions_.height() + kBottom, chart.legend) {}

    std::string run() {
        const Box& box = plot_.box();
        const bool any = std::any_of(chart_.series.begin(), chart_.series.end(),
                                     [](const Series& series) { return has_place(series); });
        heading_.draw(svg_);
        titles();
        if (any) ticks();
        for (const Series& series : chart_.series) band(series);
        for (const Series& series : chart_.series) line(series);
        svg_.frame(box, {Paint::kSoft});
        for (const Series& series : chart_.series) marks(series);
        for (const PlacedName& name : plot_.names()) draw_name(name);
        if (!any) {
            svg_.text({(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2}, chart_.empty,
                      {kTextSize, Anchor::kMiddle, Paint::kSoft});
        }
        captions_.draw(svg_, captions_top_);
        return svg_.finish();
    }

  private:
    void titles() {
        const Box& box = plot_.box();
        svg_.text({(box.x0 + box.x1) / 2, box.y1 + kAxisTitleBase}, chart_.x_title,
                  {kTextSize, Anchor::kMiddle});
        TextStyle upwards{kTextSize, Anchor::kMiddle};
        upwards.upwards = true;
        svg_.text({kMargin + 6, (box.y0 + box.y1) / 2}, chart_.y_title, upwards);
    }

    // Lines between first, so that none lies over a labelled one.
    void ticks() {
        const Box& box = plot_.box();
        for (const bool labelled : {false, true}) {
            const Stroke stroke{labelled ? Paint::kGrid : Paint::kFaint};
            for (const Tick& tick : plot_.x().ticks()) {
                if (tick.label.empty() == labelled) continue;
                const double x = plot_.x_at(tick.unit);
                svg_.line({x, box.y0}, {x, box.y1}, stroke);
                if (!labelled) continue;
                svg_.text({x, box.y1 + kTickBase}, tick.label,
                          {kTextSize, Anchor::kMiddle, Paint::kSoft});
            }
            for (const Tick& tick : plot_.y().ticks()) {
                if (tick.label.empty() == labelled) continue;
                const double y = plot_.y_at(tick.unit);
                svg_.line({box.x0, y}, {box.x1, y}, stroke);
                if (!labelled) continue;
                svg_.text({box.x0 - 6, y + 4}, tick.label, {kTextSize, Anchor::kEnd, Paint::kSoft});
            }
        }
    }

    // One shade for each run of points that have a band.
    void band(const Series& series) {
        if (series.band_name.empty()) return;
        std::vector<Point> upper;
        std::vector<Point> lower;
        const auto close = [&] {
            if (upper.size() > 1) {
                upper.insert(upper.end(), lower.rbegin(), lower.rend());
                svg_.polygon(upper, series.paint, kBandOpacity);
            } else if (upper.size() == 1) {
                // Of a point alone: a bar as wide as a mark.
                svg_.rect(
                    {upper[0].x - kMarkRadius, upper[0].y, upper[0].x + kMarkRadius, lower[0].y},
                    series.paint, kBandOpacity);
            }
            upper.clear();
            lower.clear();
        };
        for (const CurvePoint& point : series.points) {
            if (!has_place(point)) continue;
            if (std::isnan(point.low) || std::isnan(point.high)) {
                close();
                continue;
            }
            upper.push_back(plot_.place(point.x, point.high));
            lower.push_back(plot_.place(point.x, point.low));
        }
        close();
    }

    void line(const Series& series) {
        const std::vector<Point> points = plot_.places(series);
        if (series.line && points.size() > 1) {
            svg_.polyline(points, {series.paint, 2, series.dash});
        }
    }

    void marks(const Series& series) {
        for (const CurvePoint& point : series.points) {
            if (!has_place(point)) continue;
            svg_.mark(plot_.place(point.x, point.y), series.mark, series.paint, point.tip);
        }
    }

    // Boxes of names are as wide as the widest font needs: letters begin at the side of the point.
    void draw_name(const PlacedName& name) {
        if (!name.place.placed) return;
        const Box& box = name.place.box;
        if (name.place.leader) {
            const Segment& leader = name.place.leader_line;
            svg_.line(leader.from, leader.to, {Paint::kSoft, 0.75});
        }
        double x = (box.x0 + box.x1) / 2;
        Anchor anchor = Anchor::kMiddle;
        if (box.x0 >= name.point.x) {
            x = box.x0;
            anchor = Anchor::kStart;
        } else if (box.x1 <= name.point.x) {
            x = box.x1;
            anchor = Anchor::kEnd;
        }
        svg_.text({x, box.y0 + kNameBase}, name.text, {kNameSize, anchor});
    }

    const CurveChart& chart_;
    Heading heading_;
    CurvePlot plot_;
    Captions captions_;
    double captions_top_;
    Svg svg_;
};

}  // namespace

std::string draw(const CurveChart& chart) { return Drawing(chart).run(); }

}  // namespace cobble::driver::chart
