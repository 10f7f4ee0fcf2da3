#include "tramline/geometry/profile/section_parts.h"

#include <algorithm>
#include <cmath>

#include "tramline/geometry/tolerances.h"

namespace tramline {

double across_at(const SegmentProfile& segment, double half_width, const SectionPart& part, double along) {
  if (along <= part.from) return part.across_from;
  if (along >= part.to) return part.across_to;
  if (segment.radius == 0)
    return part.across_from +
           (part.across_to - part.across_from) * ((along - part.from) / (part.to - part.from));
  const double angle = along / segment.radius - segment.half_turn;
  const double radius = part.moment / (std::cos(angle) * part.edge.y - std::sin(angle) * part.edge.x);
  const double across = segment.sense * (radius - segment.radius) + half_width;
  const auto [low, high] = std::minmax(part.across_from, part.across_to);
  return across >= low ? std::min(across, high) : low;  // NaN: low
}

namespace {

class PartsMaker {
 public:
  PartsMaker(const SegmentFrame& frame, double width, SegmentProfile& out)
      : frame_(frame), width_(width), out_(out) {}

  /// All edges near the segment, in order.
  void add_edges(const EdgeIndex& region, std::vector<std::size_t>& near) {
    near.clear();
    const int count = std::clamp(static_cast<int>(0.5 * out_.length / region.grid().cell_m()), 1, 1000);
    const double part = out_.length / count;
    const double bulge = frame_.straight() ? 0 : part * part / (4 * frame_.radius());
    Point end = frame_.point_at(0, 0.5 * width_);
    for (int i = 1; i <= count; ++i) {
      Box box;
      box.extend(end);
      end = frame_.point_at(i * part, 0.5 * width_);
      box.extend(end);
      region.grid().each_meeting(box.grown(0.5 * width_ + bulge + kSamePlace_m),
                                 [&](std::size_t e) { near.push_back(e); });
    }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (const std::size_t e : near) add(region.edges()[e].from, region.edges()[e].to);
  }

  RightEnds& right_ends() { return right_; }

 private:
  void add(Point from, Point to) {
    Point a = frame_.local(from), b = frame_.local(to);
    if (frame_.straight()) return add_monotonic(a, b);
    // Points behind the centre are on none of the arc's cross-sections: it turns by half a circle at most.
    if (a.x < 0 && b.x < 0) return;
    if (a.x < 0) a = {0, a.y + (b.y - a.y) * (a.x / (a.x - b.x))};
    if (b.x < 0) b = {0, b.y + (a.y - b.y) * (b.x / (b.x - a.x))};
    const Point edge = b - a;
    const double square = dot(edge, edge);
    if (square == 0) return;
    const double foot = -dot(a, edge) / square;
    if (foot <= 0 || foot >= 1) return add_monotonic(a, b);
    const Point nearest = a + foot * edge;
    add_monotonic(a, nearest);
    add_monotonic(nearest, b);
  }

  /// Across changes one way only from a to b.
  void add_monotonic(Point a, Point b) {
    const double across_a = frame_.across(a), across_b = frame_.across(b);
    const bool rightward = across_a < across_b;
    const Point left = rightward ? a : b, right = rightward ? b : a;
    const double low = rightward ? across_a : across_b, high = rightward ? across_b : across_a;
    // Points on an end count as right of it, so a cross-section owns [0, w).
    if (high < 0 || low >= width_) return;
    const double left_along = low < 0 ? along_where(left, right, 0) : frame_.along(left);
    const double right_along = high >= width_ ? along_where(left, right, width_) : frame_.along(right);
    if (high >= width_) {
      // A crossing as near to an end may be that of the segment beside.
      right_.near_start = right_.near_start || std::abs(right_along) < kTouch_m;
      right_.near_end = right_.near_end || std::abs(right_along - out_.length) < kTouch_m;
      if (right_along >= 0 && right_along < out_.length)
        right_.crossings.push_back({right_along, rightward ? 1 : -1});
    }
    const double clipped_low = std::max(low, 0.0), clipped_high = std::min(high, width_);
    if (left_along == right_along) return;
    const bool rises = left_along < right_along;
    SectionPart part;
    part.from = rises ? left_along : right_along;
    part.to = rises ? right_along : left_along;
    part.across_from = rises ? clipped_low : clipped_high;
    part.across_to = rises ? clipped_high : clipped_low;
    part.sign = rises == rightward ? 1 : -1;
    part.edge = right - left;
    part.moment = cross(left, part.edge);
    if (part.to <= 0 || part.from >= out_.length) return;
    clip_along(part);
    out_.parts.push_back(part);
  }

  void clip_along(SectionPart& part) const {
    const double at_start = across_at(out_, 0.5 * width_, part, 0);
    const double at_end = across_at(out_, 0.5 * width_, part, out_.length);
    if (part.from < 0) {
      part.from = 0;
      part.across_from = at_start;
    }
    if (part.to > out_.length) {
      part.to = out_.length;
      part.across_to = at_end;
    }
  }

  /// Position at which the segment from left to right is that far across.
  double along_where(Point left, Point right, double across) const {
    const Point edge = right - left;
    if (frame_.straight()) {
      const double share = (across - frame_.across(left)) / edge.x;
      const double y = left.y + share * edge.y;
      return std::clamp(y, std::min(left.y, right.y), std::max(left.y, right.y));
    }
    const double radius = frame_.radius() + frame_.sense() * (across - 0.5 * width_);
    const double square = dot(edge, edge), half = dot(left, edge);
    const double root = std::sqrt(std::max(0.0, half * half - square * (dot(left, left) - radius * radius)));
    // Away from the centre the radius grows with the edge's parameter, on the arc's inside it shrinks.
    const double share = std::clamp((-half + (frame_.sense() > 0 ? root : -root)) / square, 0.0, 1.0);
    return frame_.along(left + share * edge);
  }

  const SegmentFrame& frame_;
  double width_;
  SegmentProfile& out_;
  RightEnds right_;
};

}  // namespace

RightEnds add_section_parts(const EdgeIndex& region, const SegmentFrame& frame, double width_m,
                            std::vector<std::size_t>& near, SegmentProfile& out) {
  PartsMaker maker(frame, width_m, out);
  maker.add_edges(region, near);
  return std::move(maker.right_ends());
}

}  // namespace tramline
