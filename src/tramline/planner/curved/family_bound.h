#pragma once
// A lower bound of the cost of a family of curved tracks while it is being laid.

#include <limits>

#include "tramline/planner/candidate/candidate.h"
#include "tramline/tracks/curved_tracks.h"

namespace tramline {

/// Costs above which a family need not be completed: its own, and its cost if stops cost no more than turns,
/// as if most obstacles had a way round. It has to be above both.
struct CostLimits {
  double cost = std::numeric_limits<double>::infinity();
  double soft = -std::numeric_limits<double>::infinity();
};

/// The least cost of a family without detours, while its tracks are laid one after another. Refers to its
/// arguments.
class FamilyBound {
 public:
  /// For the tracks parallel to the subfield's reference with the numbers of the range.
  FamilyBound(const SearchTask& task, const Subfield& subfield, const StripRange& range);

  /// Adds a track's pieces. `inside_m2`: the area of the subfield in all of its swath, worked or not.
  /// O(new pieces).
  void add(const LaidTracks& pieces, double inside_m2);

  /// Whether the family is certain to cost more than both limits once the tracks up to this number are added,
  /// in the order of visit_family(): they have their certain cost, and land in their swaths that they do not
  /// work stays uncovered, since swaths of a family never overlap; a little is left for rounding. O(segments
  /// of the reference).
  bool exceeds(const CostLimits& limits, int index) const;

 private:
  double least_rate(int index) const;  ///< per m²

  const SearchTask& task_;
  const Path& reference_;
  StripRange range_;
  double subfield_m2_;
  int entered_ = 0, stops_ = 0;  ///< pieces that a turn leads to, but for the first
  double worked_m2_ = 0, overlap_m2_ = 0;
  double passed_m2_ = 0;  ///< in the swaths of the tracks so far
};

}  // namespace tramline
