// SPDX-License-Identifier: MIT
#include "tools/driver/chart/labels.hpp"

#include <algorithm>

namespace cobble::driver::chart {
namespace {

// From the point to the label: beside the mark, and in rings around it.
constexpr double kDistances[] = {8, 14, 22, 32, 44, 58, 74, 92};
// Beyond this it is no longer plain which point a label belongs to.
constexpr double kNear = 12;
// Ways from the point, the better ones first: to the right as one reads, then where a falling curve
// is not.
constexpr Point kWays[] = {{1, 0},    {1, -1},  {1, 1},    {-1, 1},   {-1, 0},   {-1, -1},
                           {0, -1},   {0, 1},   {0.5, -1}, {0.5, 1},  {-0.5, 1}, {-0.5, -1},
                           {1, -0.5}, {1, 0.5}, {-1, 0.5}, {-1, -0.5}};

// Costs: a line through a label is worse than a label far away, and a leader across another is
// worse than a line through a label.
constexpr int kCrossedLine = 40;
constexpr int kCrossedLeader = 100;
// One that is nearer to another point may be read as that one's.
constexpr int kMistakable = 60;
constexpr int kRing = 8;

Box box_at(const LabelRequest& request, Point way, double distance) {
    // The corner or the middle of the side that looks at the point.
    const double x = request.point.x + way.x * distance;
    const double y = request.point.y + way.y * distance;
    const double left = way.x >= 1 ? 0 : way.x <= -1 ? 1 : 0.5 - way.x * 0.5;
    const double top = way.y >= 1 ? 0 : way.y <= -1 ? 1 : 0.5 - way.y * 0.5;
    const double x0 = x - left * request.width;
    const double y0 = y - top * request.height;
    return {x0, y0, x0 + request.width, y0 + request.height};
}

Point nearest(const Box& box, Point point) {
    return {std::clamp(point.x, box.x0, box.x1), std::clamp(point.y, box.y0, box.y1)};
}

double squared_distance(const Box& box, Point point) {
    const Point near = nearest(box, point);
    const double dx = near.x - point.x;
    const double dy = near.y - point.y;
    return dx * dx + dy * dy;
}

bool contains(const Box& box, Point point) {
    return point.x >= box.x0 && point.x <= box.x1 && point.y >= box.y0 && point.y <= box.y1;
}

class Placer {
  public:
    explicit Placer(const Surroundings& around) : around_(around) {}

    LabelPlace place(const LabelRequest& request) {
        LabelPlace best;
        int least = 0;
        int ring = 0;
        for (const double distance : kDistances) {
            int order = 0;
            for (const Point way : kWays) {
                const LabelPlace place = at(request, way, distance);
                const int cost = ring * kRing + order++;
                if (best.placed && cost >= least) continue;
                if (!is_free(place)) continue;
                const int whole = cost + crossings(place) + mistakes(place);
                if (best.placed && whole >= least) continue;
                best = place;
                least = whole;
            }
            ++ring;
        }
        if (!best.placed) return best;
        taken_.push_back(best.box);
        if (best.leader) leaders_.push_back(best.leader_line);
        return best;
    }

  private:
    static LabelPlace at(const LabelRequest& request, Point way, double distance) {
        LabelPlace place;
        place.placed = true;
        place.box = box_at(request, way, distance);
        place.leader = distance > kNear;
        place.leader_line = {request.point, nearest(place.box, request.point)};
        return place;
    }

    [[nodiscard]] bool is_free(const LabelPlace& place) const {
        if (!inside(place.box, around_.frame)) return false;
        for (const Box& box : taken_) {
            if (overlap(box, place.box)) return false;
            if (place.leader && meets(place.leader_line, box)) return false;
        }
        for (const Segment& leader : leaders_) {
            if (meets(leader, place.box)) return false;
        }
        return std::none_of(around_.marks.begin(), around_.marks.end(),
                            [&](const Box& mark) { return overlap(mark, place.box); });
    }

    [[nodiscard]] int crossings(const LabelPlace& place) const {
        int cost = 0;
        for (const Segment& line : around_.lines) {
            if (meets(line, place.box)) cost += kCrossedLine;
        }
        if (!place.leader) return cost;
        const Segment& own = place.leader_line;
        const Box about{std::min(own.from.x, own.to.x), std::min(own.from.y, own.to.y),
                        std::max(own.from.x, own.to.x), std::max(own.from.y, own.to.y)};
        for (const Segment& leader : leaders_) {
            if (meets(leader, about)) cost += kCrossedLeader;
        }
        return cost;
    }

    // Of marks that its own point lies in nothing can be told apart.
    [[nodiscard]] int mistakes(const LabelPlace& place) const {
        const Point own = place.leader_line.from;
        const double distance = squared_distance(place.box, own);
        return std::any_of(around_.marks.begin(), around_.marks.end(),
                           [&](const Box& mark) {
                               const Point middle{(mark.x0 + mark.x1) / 2, (mark.y0 + mark.y1) / 2};
                               return !contains(mark, own) &&
                                      squared_distance(place.box, middle) < distance;
                           })
                   ? kMistakable
                   : 0;
    }

    const Surroundings& around_;
    std::vector<Box> taken_;
    std::vector<Segment> leaders_;
};

}  // namespace

std::vector<LabelPlace> place_labels(std::span<const LabelRequest> requests,
                                     const Surroundings& around) {
    Placer placer(around);
    std::vector<LabelPlace> places;
    places.reserve(requests.size());
    for (const LabelRequest& request : requests) places.push_back(placer.place(request));
    return places;
}

}  // namespace cobble::driver::chart
