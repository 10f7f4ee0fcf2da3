#pragma once
// The ground of a repair: gaps, what of them is open yet, and the lines that may be driven over them.

#include <string>
#include <vector>

#include "tramline/model/field.h"
#include "tramline/planner/repair/driven_directions.h"
#include "tramline/planner/repair/gap_lines.h"

namespace tramline {

/// A place for a line: the strip with its left edge there, in one of the directions. Left of it as seen in
/// the turned plane (track_frame.h).
struct LinePlace {
  std::size_t direction = 0;
  double left_m = 0;
};

/// A line with its place.
struct RepairLine {
  LinePlace place;
  GapLine line;
  Region swaths;     ///< of its pieces, in the field's frame, oriented
  double worth = 0;  ///< when it was found, but for the turn to it: see worth_of()
};

/// Frame: the field's local metres. Gaps are seen by the directions they may be worked in; swaths of other
/// directions cover what they meet all the same.
class RepairGround {
 public:
  /// `gaps`: those that are large enough.
  RepairGround(const Field& field, const std::vector<Gap>& gaps, DrivenDirections directions,
               RepairTerms terms);

  const RepairTerms& terms() const { return terms_; }
  const Region& free() const { return free_; }  ///< the field less its obstacles, oriented
  std::size_t gaps() const { return shapes_.size(); }
  const Polygon& gap(std::size_t i) const { return shapes_[i]; }
  const Region& open(std::size_t i) const { return open_[i]; }  ///< of that, what no line covers
  double open_m2() const;                                       ///< of all gaps
  std::size_t directions() const { return turned_.size(); }
  const TrackFrame& frame(std::size_t direction) const { return turned_[direction].frame; }

  /// Gaps worked in a direction, increasing.
  const std::vector<std::size_t>& gaps_in(std::size_t direction) const { return turned_[direction].gaps; }

  /// The lines there over what is open, as lines_on() has them. O(edges of the field and of the gaps that the
  /// strip meets). Safe to call from several threads.
  std::vector<RepairLine> lines_at(const LinePlace& place) const;
  /// Those over what is open of one gap.
  std::vector<RepairLine> lines_at(const LinePlace& place, std::size_t gap) const;
  /// Those over one gap alone, as it is without any line, with all that the end rule finds, whatever that
  /// costs.
  std::vector<RepairLine> lines_over(std::size_t gap, const LinePlace& place, EndRule end_rule) const;

  /// Ground is covered, or open again, as these lines say. Only gaps that `changed` meets are looked at.
  void cover(const std::vector<RepairLine>& lines, const Region& changed);

 private:
  struct Turned {
    TrackFrame frame;
    std::vector<std::size_t> gaps;  ///< worked in this direction
    std::vector<Region> open;       ///< of these
    std::vector<Box> boxes;
    Region free;
    Region obstacles;
  };
  void turn(Turned& turned, std::size_t k) const;
  std::vector<RepairLine> lines_at(const LinePlace& place, const Region& turned_gaps, EndRule end_rule,
                                   WantedPieces wanted) const;

  RepairTerms terms_;
  Region free_;
  std::vector<Polygon> shapes_;
  std::vector<Box> boxes_;
  std::vector<Region> open_;
  std::vector<Turned> turned_;
};

}  // namespace tramline
