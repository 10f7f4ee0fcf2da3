#pragma once
// The swaths of a plan in the making, ready to be asked what they cover near one place.

#include <optional>
#include <vector>

#include "tramline/geometry/layered_area.h"
#include "tramline/tracks/laid_pieces.h"

namespace tramline {

/// What the tracks of one strip work: positions along, in its subfield's grid.
struct StripWork {
  Intervals straight;  ///< ascending, apart
  std::vector<TrackDetour> detours;
};
inline bool is_driven(const StripWork& work) { return !work.straight.empty() || !work.detours.empty(); }

/// Straight swaths and detours by subfield and strip. Subfields may have different grids.
class WorkedGround {
 public:
  void add_subfield(const StripGrid& grid, StripRange range);
  /// Replaces what is worked of one strip. Precondition: the strip is in the subfield's range.
  void set(std::size_t subfield, int strip, StripWork work);
  const StripWork& at(std::size_t subfield, int strip) const;
  const StripGrid& grid(std::size_t subfield) const { return subfields_[subfield].grid; }

  /// Adds, as taken, every swath that reaches into one of the boxes, which lie in the window, in the
  /// plane of a subfield's grid; without those of the strip `except` of that subfield.
  /// O(strips near the window).
  void append_taken(std::size_t subfield, const Box& window, const std::vector<Box>& boxes,
                    std::optional<int> except, RisingCurves& out) const;
  /// Is a straight swath of the strip in this box of its plane met by no other swath for certain? Then
  /// what it covers is what of its subfield lies in it. Only where there are no other subfields.
  bool straight_alone(std::size_t subfield, const Box& box, int strip) const;

 private:
  struct Worked {
    StripWork work;
    std::vector<Box> reach;  ///< of the detours
  };
  struct Subfield {
    StripGrid grid;
    StripRange range;
    std::vector<Worked> strips;
    double bulge_m = 0;  ///< how far any detour has ever left its strip
  };
  static void append_own(const Subfield& from, const Box& window, const std::vector<Box>& boxes,
                         std::optional<int> except, RisingCurves& out);
  static void append_foreign(const Subfield& from, const Subfield& to, const Box& window, RisingCurves& out);

  std::vector<Subfield> subfields_;
};

/// What the straight parts of tracks work, and what whole tracks do.
WorkedGround worked_straight(const std::vector<LaidTracks>& tracks);
WorkedGround worked_by(const std::vector<LaidTracks>& tracks);

/// The rectangle a straight part works, in the grid's plane.
Box straight_box(const StripGrid& grid, int strip, const Interval& part);
/// A box that the swath of a detour does not leave, in the grid's plane.
Box detour_box(const TrackDetour& detour, double width_m);

}  // namespace tramline
