// SPDX-License-Identifier: MIT
#include "tools/driver/chart/layout.hpp"

#include <utility>

namespace cobble::driver::chart {
namespace {

constexpr double kTitleBase = 28;
constexpr double kSampleWidth = 30;
constexpr double kSampleGap = 6;
constexpr double kEntryGap = 18;
// From a line's base to the middle of its small letters.
constexpr double kMiddle = 4;

void draw_sample(Svg& svg, const KeyEntry& entry, Point base) {
    const double middle = base.y - kMiddle;
    const Box box{base.x + 2, middle - 6, base.x + kSampleWidth - 2, middle + 6};
    switch (entry.sample) {
        case KeyEntry::Sample::kShade:
            svg.rect(box, entry.stroke.paint, kBandOpacity);
            return;
        case KeyEntry::Sample::kBar:
            svg.rect(box, entry.stroke.paint);
            return;
        case KeyEntry::Sample::kLine:
            if (entry.line) {
                svg.line({base.x, middle}, {base.x + kSampleWidth, middle}, entry.stroke);
            }
            svg.mark({base.x + kSampleWidth / 2, middle}, entry.mark, entry.stroke.paint);
            return;
    }
}

}  // namespace

Heading::Heading(std::string title, std::vector<KeyEntry> entries)
    : title_(std::move(title)), entries_(std::move(entries)) {
    Point at{kMargin, kTitleBase + kLineHeight + 6};
    for (const KeyEntry& entry : entries_) {
        const double width =
            kSampleWidth + kSampleGap + text_width(entry.name, kTextSize) + kEntryGap;
        if (at.x > kMargin && at.x + width > kChartWidth) at = {kMargin, at.y + kLineHeight};
        places_.push_back(at);
        at.x += width;
    }
    bottom_ = (entries_.empty() ? kTitleBase : at.y) + 14;
}

void Heading::draw(Svg& svg) const {
    svg.text({kMargin, kTitleBase}, title_, {kTitleSize, Anchor::kStart, Paint::kInk, true});
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        draw_sample(svg, entries_[i], places_[i]);
        svg.text({places_[i].x + kSampleWidth + kSampleGap, places_[i].y}, entries_[i].name,
                 {kTextSize});
    }
}

Captions::Captions(std::span<const std::string> captions) {
    for (const std::string& caption : captions) {
        for (std::string& line : wrap(caption, kChartWidth - 2 * kMargin, kTextSize)) {
            lines_.push_back(std::move(line));
        }
    }
}

void Captions::draw(Svg& svg, double top) const {
    double base = top + kTextSize;
    for (const std::string& line : lines_) {
        svg.text({kMargin, base}, line, {kTextSize, Anchor::kStart, Paint::kSoft});
        base += kLineHeight;
    }
}

}  // namespace cobble::driver::chart
