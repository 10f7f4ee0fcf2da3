#include "tramline/geometry/cross_section.h"

#include <algorithm>

namespace tramline {
namespace {

/// The part of a boundary edge within one strip, bottom up. x is measured from the strip's left line.
struct EdgePart {
  double bottom, top;
  double x_bottom, x_top;
  double sign;  ///< +1 where the edge runs up: the region lies left of it
};

/// The boundary crosses a line across the strips: the region begins (+1) or ends (−1) there.
struct Crossing {
  double along;
  int change;
};

struct Bucket {
  std::vector<EdgePart> parts;
  std::vector<Crossing> right_line;
  std::vector<Crossing> centre_line;
};

double along_at(Point a, Point b, double across) {
  if (across == a.x) return a.y;
  if (across == b.x) return b.y;
  const double y = a.y + (b.y - a.y) * ((across - a.x) / (b.x - a.x));
  return std::clamp(y, std::min(a.y, b.y), std::max(a.y, b.y));
}

class Buckets {
 public:
  Buckets(const StripGrid& grid, StripRange range, const StripMask& wanted)
      : grid_(grid), range_(range), wanted_(wanted), buckets_(static_cast<std::size_t>(range.size())) {}

  void add(const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) add(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]);
  }

  std::vector<Bucket>& buckets() { return buckets_; }

 private:
  /// Points on a line count as right of it, so a strip owns [line(k), line(k + 1)).
  void add(Point a, Point b) {
    const bool rightward = a.x < b.x;
    const Point left = rightward ? a : b, right = rightward ? b : a;
    const int k_left = grid_.strip_at(left.x), k_right = grid_.strip_at(right.x);
    for (int k = std::max(k_left, range_.first); k <= std::min(k_right, range_.last); ++k) {
      const auto place = static_cast<std::size_t>(k - range_.first);
      if (!wanted_.empty() && !wanted_[place]) continue;
      Bucket& bucket = buckets_[place];
      const Point from = k == k_left ? left : Point{grid_.line(k), along_at(left, right, grid_.line(k))};
      const Point to =
          k == k_right ? right : Point{grid_.line(k + 1), along_at(left, right, grid_.line(k + 1))};
      const int change = rightward ? +1 : -1;
      if (k < k_right) bucket.right_line.push_back({to.y, change});
      const double centre = grid_.centre(k);
      if (left.x < centre && right.x >= centre)
        bucket.centre_line.push_back({along_at(left, right, centre), change});
      add_part(bucket, from, to, rightward, grid_.line(k));
    }
  }

  static void add_part(Bucket& bucket, Point from, Point to, bool rightward, double line) {
    if (from.y == to.y) return;
    const bool rises = from.y < to.y;
    const double sign = rises == rightward ? +1 : -1;
    if (rises)
      bucket.parts.push_back({from.y, to.y, from.x - line, to.x - line, sign});
    else
      bucket.parts.push_back({to.y, from.y, to.x - line, from.x - line, sign});
  }

  const StripGrid& grid_;
  StripRange range_;
  const StripMask& wanted_;
  std::vector<Bucket> buckets_;
};

void sort_crossings(std::vector<Crossing>& crossings) {
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& a, const Crossing& b) { return a.along < b.along; });
}

Intervals inside_intervals(std::vector<Crossing>& crossings) {
  sort_crossings(crossings);
  Intervals out;
  int inside = 0;
  double from = 0;
  for (const Crossing& crossing : crossings) {
    const int before = inside;
    inside += crossing.change;
    if (before <= 0 && inside > 0) from = crossing.along;
    if (before > 0 && inside <= 0 && crossing.along > from) append_joining(out, {from, crossing.along});
  }
  return out;
}

std::vector<double> event_positions(const Bucket& bucket) {
  std::vector<double> events;
  events.reserve(2 * bucket.parts.size() + bucket.right_line.size());
  for (const EdgePart& part : bucket.parts) {
    events.push_back(part.bottom);
    events.push_back(part.top);
  }
  for (const Crossing& crossing : bucket.right_line) events.push_back(crossing.along);
  std::sort(events.begin(), events.end());
  events.erase(std::unique(events.begin(), events.end()), events.end());
  return events;
}

double across_at(const EdgePart& part, double along) {
  if (along == part.bottom) return part.x_bottom;
  if (along == part.top) return part.x_top;
  return part.x_bottom + (part.x_top - part.x_bottom) * ((along - part.bottom) / (part.top - part.bottom));
}

std::vector<Slab> slabs_of(Bucket& bucket, double strip_width) {
  sort_crossings(bucket.right_line);
  std::sort(bucket.parts.begin(), bucket.parts.end(),
            [](const EdgePart& a, const EdgePart& b) { return a.bottom < b.bottom; });
  const std::vector<double> events = event_positions(bucket);
  std::vector<Slab> slabs;
  std::vector<EdgePart> active;
  std::size_t next_part = 0, next_crossing = 0;
  int right_inside = 0;
  for (std::size_t i = 0; i + 1 < events.size(); ++i) {
    const double from = events[i], to = events[i + 1];
    for (; next_crossing < bucket.right_line.size() && bucket.right_line[next_crossing].along <= from;
         ++next_crossing)
      right_inside += bucket.right_line[next_crossing].change;
    std::erase_if(active, [from](const EdgePart& part) { return part.top <= from; });
    for (; next_part < bucket.parts.size() && bucket.parts[next_part].bottom <= from; ++next_part)
      active.push_back(bucket.parts[next_part]);
    Slab slab{from, to, right_inside * strip_width, right_inside * strip_width};
    for (const EdgePart& part : active) {
      slab.width_from += part.sign * across_at(part, from);
      slab.width_to += part.sign * across_at(part, to);
    }
    slab.width_from = std::clamp(slab.width_from, 0.0, strip_width);
    slab.width_to = std::clamp(slab.width_to, 0.0, strip_width);
    if (slab.width_from > 0 || slab.width_to > 0) slabs.push_back(slab);
  }
  return slabs;
}

}  // namespace

std::vector<StripProfile> cross_sections(const Region& turned, const StripGrid& grid, StripRange range,
                                         const StripMask& wanted) {
  if (turned.empty()) return std::vector<StripProfile>(static_cast<std::size_t>(range.size()));
  Buckets fold(grid, range, wanted);
  for (const Polygon& polygon : turned) {
    fold.add(polygon.outer);
    for (const Ring& hole : polygon.holes) fold.add(hole);
  }
  std::vector<StripProfile> profiles;
  profiles.reserve(fold.buckets().size());
  for (Bucket& bucket : fold.buckets())
    profiles.push_back({slabs_of(bucket, grid.width_m), inside_intervals(bucket.centre_line)});
  return profiles;
}

Intervals where_at_least(const StripProfile& profile, double width_m) {
  Intervals out;
  for (const Slab& slab : profile.slabs) {
    const bool at_from = slab.width_from >= width_m, at_to = slab.width_to >= width_m;
    if (!at_from && !at_to) continue;
    Interval part{slab.from, slab.to};
    if (at_from != at_to) {
      const double share = (width_m - slab.width_from) / (slab.width_to - slab.width_from);
      const double turning_point = slab.from + share * (slab.to - slab.from);
      (at_from ? part.to : part.from) = turning_point;
    }
    if (part.from < part.to) append_joining(out, part);
  }
  return out;
}

double area_between(const StripProfile& profile, double from, double to) {
  double sum = 0;
  for (const Slab& slab : profile.slabs) {
    const double lo = std::max(from, slab.from), hi = std::min(to, slab.to);
    if (lo < hi) sum += 0.5 * (slab.width_at(lo) + slab.width_at(hi)) * (hi - lo);
  }
  return sum;
}

}  // namespace tramline
