#include <algorithm>
#include <cmath>

#include "tramline/geometry/profile/path_profile.h"
#include "tramline/geometry/profile/section_parts.h"

namespace tramline {
namespace {

/// Accuracy of positions on arcs, m.
constexpr double kPosition_m = 1e-9;

class Insides {
 public:
  Insides(const PathProfile& profile, double least) : width_(profile.width_m), least_(least) {}

  void add(const SegmentProfile& segment, const SectionSlab& slab, Intervals& out) const {
    if (slab.parts.empty()) {
      if (slab.right_inside * width_ >= least_) append(segment, slab.from, slab.to, out);
      return;
    }
    search(segment, slab, slab.from, slab.to, out);
  }

 private:
  /// Bounds of the inside length between two positions: every part is monotonic.
  void search(const SegmentProfile& segment, const SectionSlab& slab, double from, double to,
              Intervals& out) const {
    double low = slab.right_inside * width_, high = low, at_from = low, at_to = low;
    for (const std::size_t p : slab.parts) {
      const SectionPart& part = segment.parts[p];
      const double a = part.sign * across_at(segment, 0.5 * width_, part, from);
      const double b = part.sign * across_at(segment, 0.5 * width_, part, to);
      low += std::min(a, b);
      high += std::max(a, b);
      at_from += a;
      at_to += b;
    }
    if (low >= least_) return append(segment, from, to, out);
    if (high < least_) return;
    double middle = 0.5 * (from + to);
    if (segment.radius == 0) {
      if ((at_from >= least_) == (at_to >= least_)) {
        if (at_from >= least_) append(segment, from, to, out);
        return;
      }
      middle = from + (to - from) * ((least_ - at_from) / (at_to - at_from));
      return at_from >= least_ ? append(segment, from, middle, out) : append(segment, middle, to, out);
    }
    if (to - from <= kPosition_m) {
      if (at_from >= least_ && at_to >= least_) append(segment, from, to, out);
      return;
    }
    search(segment, slab, from, middle, out);
    search(segment, slab, middle, to, out);
  }

  static void append(const SegmentProfile& segment, double from, double to, Intervals& out) {
    if (from < to) append_joining(out, {segment.start + from, segment.start + to});
  }

  double width_;
  double least_;
};

double area_of(const SegmentProfile& segment, double width, const SectionSlab& slab, double from, double to) {
  const double half = 0.5 * width, along = to - from;
  double sum = slab.right_inside * width * along;
  for (const std::size_t p : slab.parts) {
    const SectionPart& part = segment.parts[p];
    const double a = across_at(segment, half, part, from), b = across_at(segment, half, part, to);
    if (segment.radius == 0) {
      sum += part.sign * 0.5 * (a + b) * along;
      continue;
    }
    // The triangle from the arc's centre, and the sector up to the cross-sections' left ends.
    const double angle = along / segment.radius, left = segment.radius - segment.sense * half;
    const double r_a = left + segment.sense * a, r_b = left + segment.sense * b;
    sum += part.sign * segment.sense * 0.5 * (r_a * r_b * std::sin(angle) - left * left * angle);
  }
  return sum;
}

/// The slab's ends and where parts cross the centre line in between, in order.
std::vector<double> centre_cuts(const SegmentProfile& segment, const SectionSlab& slab, double half) {
  std::vector<double> cuts{slab.from, slab.to};
  for (const std::size_t p : slab.parts) {
    const SectionPart& part = segment.parts[p];
    double low = slab.from, high = slab.to;
    const bool above = across_at(segment, half, part, low) >= half;
    if (above == (across_at(segment, half, part, high) >= half)) continue;
    while (high - low > kPosition_m) {
      const double middle = 0.5 * (low + high);
      (above == (across_at(segment, half, part, middle) >= half) ? low : high) = middle;
    }
    cuts.push_back(0.5 * (low + high));
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

}  // namespace

Intervals where_at_least(const PathProfile& profile, double least_m) {
  const Insides insides(profile, least_m);
  Intervals out;
  for (const SegmentProfile& segment : profile.segments)
    for (const SectionSlab& slab : segment.slabs) insides.add(segment, slab, out);
  return out;
}

Intervals centre_inside(const PathProfile& profile) {
  const double half = 0.5 * profile.width_m;
  Intervals out;
  for (const SegmentProfile& segment : profile.segments)
    for (const SectionSlab& slab : segment.slabs) {
      const std::vector<double> cuts = centre_cuts(segment, slab, half);
      for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        int inside = slab.right_inside;
        for (const std::size_t p : slab.parts)
          if (across_at(segment, half, segment.parts[p], 0.5 * (cuts[i] + cuts[i + 1])) > half)
            inside += segment.parts[p].sign;
        if (inside > 0 && cuts[i] < cuts[i + 1])
          append_joining(out, {segment.start + cuts[i], segment.start + cuts[i + 1]});
      }
    }
  return out;
}

double area_between(const PathProfile& profile, double from, double to) {
  double sum = 0;
  for (const SegmentProfile& segment : profile.segments) {
    if (segment.start >= to || segment.start + segment.length <= from) continue;
    for (const SectionSlab& slab : segment.slabs) {
      const double low = std::max(slab.from, from - segment.start);
      const double high = std::min(slab.to, to - segment.start);
      if (low < high) sum += area_of(segment, profile.width_m, slab, low, high);
    }
  }
  return sum;
}

}  // namespace tramline
