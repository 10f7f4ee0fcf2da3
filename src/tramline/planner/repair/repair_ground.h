#pragma once
// The state of a repair: gaps, their parts not yet covered, and the lines that may be driven over them.

#include <string>
#include <vector>

#include "tramline/model/field.h"
#include "tramline/planner/repair/driven_directions.h"
#include "tramline/planner/repair/gap_lines.h"

namespace tramline {

/// The position of a line: a strip in one of the directions, given by its left edge in the turned plane
/// (track_frame.h).
struct LinePosition {
  std::size_t direction = 0;
  double left_m = 0;
};

/// A line with its position.
struct RepairLine {
  LinePosition position;
  GapLine line;
  Region swaths;     ///< swaths of its pieces, in the field's frame, oriented
  double worth = 0;  ///< worth_of() at the time it was found, without the turn to it
};

/// Frame: the field's local metres. Lines of a direction are laid over the gaps that may be worked in it;
/// swaths cover all gaps they overlap, whatever the direction.
class RepairGround {
 public:
  /// `gaps`: those that are large enough.
  RepairGround(const Field& field, const std::vector<Gap>& gaps, DrivenDirections directions,
               RepairTerms terms);

  const RepairTerms& terms() const { return terms_; }
  const Region& free() const { return free_; }  ///< the field less its obstacles, oriented
  std::size_t gaps() const { return shapes_.size(); }
  const Polygon& gap(std::size_t i) const { return shapes_[i]; }
  const Region& open(std::size_t i) const { return open_[i]; }  ///< the part of gap(i) that no line covers
  double open_m2() const;                                       ///< of all gaps
  std::size_t directions() const { return turned_.size(); }
  const TrackFrame& frame(std::size_t direction) const { return turned_[direction].frame; }

  /// Indices of the gaps that may be worked in a direction, ascending.
  const std::vector<std::size_t>& gaps_in(std::size_t direction) const { return turned_[direction].gaps; }

  /// The lines at this position over the open land, as lines_on() gives them. O(edges of the field and of the
  /// gaps that the strip crosses). Safe to call from several threads.
  std::vector<RepairLine> lines_at(const LinePosition& position) const;
  /// The same over the open land of one gap.
  std::vector<RepairLine> lines_at(const LinePosition& position, std::size_t gap) const;
  /// The same over one whole gap as if no line covered it, with all pieces that the end rule finds, whatever
  /// they cost.
  std::vector<RepairLine> lines_over(std::size_t gap, const LinePosition& position, EndRule end_rule) const;

  /// Sets the covered land to that of these lines; the rest is open. Only gaps that `changed` overlaps are
  /// updated.
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
  std::vector<RepairLine> lines_at(const LinePosition& position, const Region& turned_gaps, EndRule end_rule,
                                   WantedPieces wanted) const;

  RepairTerms terms_;
  Region free_;
  std::vector<Polygon> shapes_;
  std::vector<Box> boxes_;
  std::vector<Region> open_;
  std::vector<Turned> turned_;
};

}  // namespace tramline
