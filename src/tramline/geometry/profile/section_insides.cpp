#include <algorithm>
#include <cmath>
#include <limits>

#include "tramline/geometry/profile/path_profile.h"
#include "tramline/geometry/profile/section_parts.h"

namespace tramline {
namespace {

/// Accuracy of positions on arcs, m.
constexpr double kPosition_m = 1e-9;
/// A length across that deviates from its chord by no more counts as straight, m: about its rounding.
constexpr double kStraight_m = 1e-12;

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
  /// The inside length at two positions, and between what it stays from one to the other.
  struct Inside {
    double at_from, at_to;
    double low, high;
    double bend;  ///< it deviates from its chord by no more
  };

  Inside inside(const SegmentProfile& segment, const SectionSlab& slab, double from, double to) const {
    const double all = slab.right_inside * width_;
    Inside out{all, all, all, all, 0};
    for (const std::size_t p : slab.parts) {
      const SectionPart& part = segment.parts[p];
      const double a = across_at(segment, 0.5 * width_, part, from);
      const double b = across_at(segment, 0.5 * width_, part, to);
      out.at_from += part.sign * a;
      out.at_to += part.sign * b;
      // Every part is monotonic.
      out.low += part.sign * (part.sign > 0 ? std::min(a, b) : std::max(a, b));
      out.high += part.sign * (part.sign > 0 ? std::max(a, b) : std::min(a, b));
      out.bend += most_bent(segment, part, a, b) * (to - from) * (to - from) / 8;
    }
    // Where the parts go along with one another, the sum lies nearer to its chord than each to its ends.
    out.low = std::max(out.low, std::min(out.at_from, out.at_to) - out.bend);
    out.high = std::min(out.high, std::max(out.at_from, out.at_to) + out.bend);
    return out;
  }

  /// The greatest second derivative of a part's distance across by the position along, 1/m, between two
  /// distances. With r = d / cos ψ about the arc's centre, d²r/dψ² = r·(2r²/d² − 1), which grows with r.
  double most_bent(const SegmentProfile& segment, const SectionPart& part, double a, double b) const {
    if (segment.radius == 0) return 0;
    const double nearest_square = part.moment * part.moment / dot(part.edge, part.edge);
    if (!(nearest_square > 0)) return std::numeric_limits<double>::infinity();
    const double half = 0.5 * width_;
    const double farthest = segment.radius + std::max(std::abs(a - half), std::abs(b - half));
    return farthest * (2 * farthest * farthest / nearest_square - 1) / (segment.radius * segment.radius);
  }

  void search(const SegmentProfile& segment, const SectionSlab& slab, double from, double to,
              Intervals& out) const {
    const Inside here = inside(segment, slab, from, to);
    if (here.low >= least_) return append(segment, from, to, out);
    if (here.high < least_) return;
    const bool begins = here.at_from >= least_, ends = here.at_to >= least_;
    if (here.bend <= kStraight_m) {
      if (begins == ends) {
        if (begins) append(segment, from, to, out);
        return;
      }
      const double where = from + (to - from) * ((least_ - here.at_from) / (here.at_to - here.at_from));
      return begins ? append(segment, from, where, out) : append(segment, where, to, out);
    }
    if (to - from <= kPosition_m) {
      if (begins && ends) append(segment, from, to, out);
      return;
    }
    const double middle = 0.5 * (from + to);
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
