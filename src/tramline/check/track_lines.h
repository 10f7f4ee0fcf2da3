#pragma once
// The lines of tracks that follow a curve: where a track would be if nothing stood in its way.

#include <optional>
#include <vector>

#include "tramline/geometry/parallel.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// A stretch of one line: positions along it, the second ahead of the first. On a closed line it may lie
/// across the beginning; then it ends beyond the line's length.
struct OnLine {
  std::size_t line = 0;
  double from_m = 0;
  double to_m = 0;
};

/// Parallels of the plan's reference at the distances of all tracks that its pieces and encounters name; none
/// where no piece is curved.
class TrackLines {
 public:
  explicit TrackLines(const Plan& plan);

  std::size_t size() const { return lines_.size(); }
  int track(std::size_t line) const { return lines_[line].index; }
  bool closed(std::size_t line) const { return lines_[line].track.closed; }
  double length_m(std::size_t line) const { return lengths_m_[line]; }

  /// From one place of a track's line to another, leaving in this heading, or against it; nullopt where no
  /// line of the track leads from the one to the other. Places may be a millimetre off.
  std::optional<OnLine> between(int track, Point from, Point heading, Point to) const;
  /// Where on a line a place is; nullopt where it is a millimetre off.
  std::optional<double> place_on(std::size_t line, Point p) const;
  Path path_of(const OnLine& stretch) const;

 private:
  std::optional<OnLine> stretch(std::size_t line, double from_m, double to_m) const;

  struct Segment {
    double from_m = 0;  ///< along the line
    Box reach;
  };

  std::vector<FamilyTrack> lines_;
  std::vector<double> lengths_m_;
  std::vector<Box> boxes_;
  std::vector<std::vector<Segment>> segments_;  ///< of each line
};

/// Does the stretch hold a place of the line, up to a millimetre?
bool holds(const TrackLines& lines, const OnLine& stretch, Point p);

}  // namespace tramline::check
