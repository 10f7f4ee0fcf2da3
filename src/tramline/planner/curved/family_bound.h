#pragma once
// A lower bound of the cost of a family of curved tracks while it is being laid.

#include "tramline/planner/candidate/candidate.h"
#include "tramline/tracks/curved_tracks.h"

namespace tramline {

/// The least cost of a family without detours, while its tracks are laid one after another. Refers to its
/// arguments.
class FamilyBound {
 public:
  /// For the tracks parallel to the reference with the numbers of the range.
  FamilyBound(const SearchTask& task, const Path& reference, const StripRange& range)
      : task_(task), reference_(reference), range_(range) {}

  /// The bound once the tracks up to this number are laid, in the order of visit_family(): the certain cost
  /// of these plus the least cost of the rest of the body, less a little for rounding. O(new pieces +
  /// segments of the reference).
  double after(int index, const LaidTracks& tracks);

 private:
  double least_for_the_rest(int index) const;

  const SearchTask& task_;
  const Path& reference_;
  StripRange range_;
  std::size_t seen_ = 0;
  double inside_m2_ = 0, overlap_m2_ = 0;
  int stops_ = 0;
};

}  // namespace tramline
