#pragma once
// What a family of curved tracks costs at least, while it is laid.

#include "tramline/planner/candidate/candidate.h"
#include "tramline/tracks/curved_tracks.h"

namespace tramline {

/// What a family without detours costs at least, while its tracks are laid one after another. Refers to its
/// arguments.
class FamilyBound {
 public:
  /// Of tracks parallel to the reference with the numbers of the range.
  FamilyBound(const SearchTask& task, const Path& reference, const StripRange& range)
      : task_(task), reference_(reference), range_(range) {}

  /// With the tracks up to this number, in the order of visit_family(): what these cost for certain, and the
  /// least the rest of the body can. A little less for rounding. O(new pieces + segments of the reference).
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
