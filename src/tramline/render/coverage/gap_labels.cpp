#include "tramline/render/coverage/gap_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "tramline/geometry/path/simplified_line.h"
#include "tramline/render/page/text.h"

namespace tramline::render {
namespace {

constexpr std::array kReaches{30.0, 42.0, 56.0, 74.0, 98.0, 130.0, 170.0};  // px at text scale 1
constexpr int kDirections = 24;
constexpr double kApart = 3;
constexpr double kDotRadius = 3;

bool lies_in(const Box& box, Point p) {
  return p.x >= box.min_x && p.x <= box.max_x && p.y >= box.min_y && p.y <= box.max_y;
}

bool has_room(const Gap& gap, const MapView& view, double scale) {
  return gap.widest_m * view.px_per_m > 2 * (kGapBadgeRadius + kApart) * scale;
}

bool cross_each_other(Point a, Point b, Point c, Point d) {
  return cross(b - a, c - a) * cross(b - a, d - a) < 0 && cross(d - c, a - c) * cross(d - c, b - c) < 0;
}

/// What breaking the rules costs: a hidden number is worse than a hidden gap, and that than a crossing.
constexpr int kHidesNumber = 10000, kHidesGap = 100, kCrosses = 1;

int faults_of(const GapLabel& candidate, const std::vector<GapLabel>& placed,
              const std::vector<Point>& centres, double scale) {
  const double radius = kGapBadgeRadius * scale, apart = kApart * scale;
  int faults = 0;
  for (const GapLabel& other : placed) {
    if (distance(candidate.badge, other.badge) < 2 * radius + apart) faults += kHidesNumber;
    if (distance_to_segment(other.badge, candidate.gap, candidate.badge) < radius + apart) faults += kCrosses;
    if (distance_to_segment(candidate.badge, other.gap, other.badge) < radius + apart) faults += kCrosses;
    if (cross_each_other(candidate.gap, candidate.badge, other.gap, other.badge)) faults += kCrosses;
  }
  for (const Point centre : centres)
    if (!(centre == candidate.gap) && distance(candidate.badge, centre) < radius + 2 * apart)
      faults += kHidesGap;
  return faults;
}

/// Clockwise from up. The first is askew, so that leaders do not run along passes that go north or east; then
/// they open to both sides.
double direction_of(int i) {
  const int step = (i + 1) / 2 * (i % 2 == 0 ? -1 : 1);
  return std::numbers::pi / 4 + 2 * std::numbers::pi * step / kDirections;
}

GapLabel placed_beside(const GapLabel& label, const std::vector<GapLabel>& placed,
                       const std::vector<Point>& centres, double scale, const Box& room) {
  GapLabel best = label;
  best.badge = {std::clamp(label.gap.x, room.min_x, room.max_x),
                std::clamp(label.gap.y, room.min_y, room.max_y)};
  int least = std::numeric_limits<int>::max();
  for (const double reach : kReaches) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle = direction_of(i);
      GapLabel candidate = label;
      candidate.badge = label.gap + (reach * scale) * Point{std::sin(angle), -std::cos(angle)};
      if (!lies_in(room, candidate.badge)) continue;
      const int faults = faults_of(candidate, placed, centres, scale);
      if (faults >= least) continue;
      best = candidate;
      least = faults;
      if (faults == 0) return best;
    }
  }
  return best;
}

}  // namespace

std::vector<GapLabel> place_gap_labels(const std::vector<Gap>& gaps, const MapView& view, double scale,
                                       const Box& map) {
  std::vector<GapLabel> labels, waiting;
  std::vector<Point> centres;
  const std::size_t n = std::min(gaps.size(), static_cast<std::size_t>(kGapsNumbered));
  for (std::size_t i = 0; i < n; ++i) {
    const Point at = view.to_page(gaps[i].centre);
    if (!lies_in(map, at)) continue;
    centres.push_back(at);
    (has_room(gaps[i], view, scale) ? labels : waiting).push_back({gaps[i].number, at, at});
  }
  const Box room = map.grown(-(kGapBadgeRadius + kApart) * scale);
  for (const GapLabel& label : waiting) labels.push_back(placed_beside(label, labels, centres, scale, room));
  return labels;
}

void draw_gap_labels(Canvas& canvas, const std::vector<GapLabel>& labels) {
  const double k = canvas.scale();
  for (const GapLabel& label : labels) {
    if (label.gap == label.badge) continue;
    stroke_line(canvas, {label.gap, label.badge}, {rgb(kBackgroundHex, 0.85), 4 * k});
    disc(canvas, label.gap, (kDotRadius + 1) * k, kBackgroundColour);
  }
  for (const GapLabel& label : labels) {
    if (label.gap == label.badge) continue;
    stroke_line(canvas, {label.gap, label.badge}, {kInk, 1.3 * k});
    disc(canvas, label.gap, kDotRadius * k, kInk);
  }
  for (const GapLabel& label : labels) draw_gap_badge(canvas, label.badge, label.number);
}

}  // namespace tramline::render
