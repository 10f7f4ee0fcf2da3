#pragma once
// The passages of a boundary through a strip, and the area outside the region that a swath ending
// there works.

#include <vector>

#include "tramline/geometry/strip/strip_grid.h"
#include "tramline/tracks/end_rule.h"

namespace tramline {

/// A passage of the boundary through a strip, from one line to the other, along which it turns back
/// neither across nor along.
struct RowEndWedge {
  bool begins = false;  ///< the region lies beyond it along the direction, not before it
  double lowest = 0;    ///< coordinates along of the passage
  double highest = 0;
  double at = 0;       ///< position where the end rule lets the swath end
  double over_m2 = 0;  ///< area that the swath then works outside the region
};

/// The passages of a region's boundary by strip. Strips in which the boundary does anything else are
/// intricate: nothing is known of their passages.
class RowEndWedges {
 public:
  /// `outline` are the region's rings in the grid's turned plane, outer ones counter-clockwise.
  /// O(n + K) for n edges and K incidences of edges and strips.
  void collect(const std::vector<Ring>& outline, const StripGrid& grid, StripRange range,
               const EndCriterion& criterion);

  /// The strip's passages from low to high, where they bound consecutive pieces: first one that begins, then
  /// one that ends, and so on. Empty with `plain` false where they do not, or where the strip is intricate.
  struct InStrip {
    bool plain = false;
    const RowEndWedge* begin = nullptr;
    const RowEndWedge* end = nullptr;
  };
  InStrip in_strip(std::size_t index);

 private:
  struct Link {
    RowEndWedge end;
    int next;
  };
  void walk(const Ring& ring);
  void add(int strip, const RowEndWedge& end);
  void mark_intricate(int strip);

  const StripGrid* grid_ = nullptr;
  StripRange range_;
  EndCriterion criterion_;
  std::vector<Link> links_;
  std::vector<int> first_;  ///< by strip: into links_, −1: none
  std::vector<char> intricate_;
  std::vector<RowEndWedge> sorted_;
};

}  // namespace tramline
