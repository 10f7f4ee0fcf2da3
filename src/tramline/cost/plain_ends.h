#pragma once
// Where a boundary simply passes through a strip, and what a swath that ends there works in vain.

#include <vector>

#include "tramline/geometry/strip_grid.h"
#include "tramline/tracks/end_rule.h"

namespace tramline {

/// A passage of the boundary through a strip, from one line to the other, along which it turns back
/// neither across nor along.
struct PlainEnd {
  bool begins = false;  ///< the region lies beyond it along the direction, not before it
  double lowest = 0;    ///< coordinates along of the passage
  double highest = 0;
  double at = 0;           ///< where the end rule lets the swath end
  double over_m2 = 0;      ///< what the swath then works outside the region
  double under_m2 = 0;     ///< what it leaves inside
  double least_slope = 0;  ///< of the boundary against the line across, not negative
  double most_slope = 0;
  int previous = -1;  ///< the plain passages of the neighbouring strips that the boundary comes from
  int next = -1;      ///< and goes on to; −1: there is none
};

/// A straight part of the boundary in one strip, as the boundary runs. x is measured from the strip's
/// left line.
struct BoundaryPart {
  Point from;
  Point to;
};

/// The passages of a region's boundary by strip. Strips in which it does anything else are intricate:
/// of their passages nothing is known.
class PlainEnds {
 public:
  /// `outline` are the region's rings in the grid's turned plane, outer ones counter-clockwise.
  /// O(n + K) for n edges and K incidences of edges and strips.
  void collect(const std::vector<Ring>& outline, const StripGrid& grid, StripRange range,
               const EndCriterion& criterion, bool with_parts = false);

  /// The strip's passages from low to high, where they bound pieces one after another: first one that
  /// begins, then one that ends, and so on. `plain` is false where they do not, or where the strip is
  /// intricate. Valid until the next call.
  struct InStrip {
    bool plain = false;
    const PlainEnd* const* begin = nullptr;
    const PlainEnd* const* end = nullptr;
  };
  InStrip in_strip(std::size_t place);

  const PlainEnd& at(int index) const { return links_[static_cast<std::size_t>(index)].end; }
  /// How far the boundary goes across within the strip, all its ways summed, m. Needs parts.
  double across_m(std::size_t place) const { return across_[place]; }
  /// The boundary within the strip. Needs parts.
  void parts_in_strip(std::size_t place, std::vector<BoundaryPart>& out) const;

 private:
  struct Link {
    PlainEnd end;
    int next;
  };
  struct PartLink {
    BoundaryPart part;
    int next;
  };
  void walk(const Ring& ring);
  int add(int strip, const PlainEnd& end);
  void add_part(int strip, const BoundaryPart& part);
  void spoil(int strip);
  bool in_range(int strip) const { return strip >= range_.first && strip <= range_.last; }

  const StripGrid* grid_ = nullptr;
  StripRange range_;
  EndCriterion criterion_;
  bool with_parts_ = false;
  std::vector<Link> links_;
  std::vector<int> first_;  ///< by strip: into links_, −1: none
  std::vector<char> intricate_;
  std::vector<PartLink> parts_;
  std::vector<int> first_part_;
  std::vector<double> across_;
  std::vector<const PlainEnd*> sorted_;
};

}  // namespace tramline
