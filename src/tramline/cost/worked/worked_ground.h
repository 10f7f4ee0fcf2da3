#pragma once
// The swaths of a plan in the making, ready to be asked what they cover near one place.

#include <optional>
#include <vector>

#include "tramline/geometry/path/newly_covered_area.h"
#include "tramline/tracks/laid_pieces.h"

namespace tramline {

/// What is worked of one track.
struct TrackWork {
  Intervals on_track;  ///< ascending, apart
  std::vector<TrackDetour> detours;
};
inline bool is_driven(const TrackWork& work) { return !work.on_track.empty() || !work.detours.empty(); }

/// Swaths by family and track: rows of strips, swaths along curves, and detours of both. Families may lie in
/// different planes. Refers to the families.
class WorkedGround {
 public:
  explicit WorkedGround(const std::vector<TrackFamily>& families);
  /// Replaces what is worked of one track. `track` is its place in the family.
  void set(std::size_t family, std::size_t track, TrackWork work);
  const TrackWork& at(std::size_t family, std::size_t track) const;

  /// Adds, as taken, every swath that reaches into one of the boxes, which lie in the window, in the plane of
  /// a family; without those of its track `except`. O(tracks near the window) of strips, O(tracks) of curves.
  void append_taken(std::size_t family, const Box& window, const std::vector<Box>& boxes,
                    std::optional<std::size_t> except, RisingCurves& out) const;
  /// Is a swath that keeps to its track in this box of its plane met by no other swath for certain? Then what
  /// it covers is what of its subfield lies in it. Only where there are no other families.
  bool is_alone(std::size_t family, const Box& box, std::size_t track) const;

 private:
  struct Swath {
    PathSegment line;
    Box reach;
  };
  struct Worked {
    TrackWork work;
    std::vector<Box> reach;      ///< of the detours
    std::vector<Swath> along{};  ///< where a curved track is kept to
    Box whole{};                 ///< of those
  };
  struct Family {
    const TrackFamily& tracks;
    std::vector<Worked> worked;  ///< by track
    double bulge_m = 0;          ///< how far any detour has ever left its strip
  };
  static void append_rows(const Family& from, const Box& window, std::optional<std::size_t> except,
                          RisingCurves& out);
  static void append_along(const Family& from, const Box& window, std::optional<std::size_t> except,
                           RisingCurves& out);
  static void append_detours(const Family& from, const Box& window, const std::vector<Box>& boxes,
                             std::optional<std::size_t> except, RisingCurves& out);
  static void append_foreign(const Family& from, const Family& to, const Box& window, RisingCurves& out);

  std::vector<Family> families_;
};

/// What is worked where tracks are kept to, and what whole tracks work. `tracks` by family.
WorkedGround worked_on_tracks(const std::vector<TrackFamily>& families,
                              const std::vector<LaidTracks>& tracks);
WorkedGround worked_by(const std::vector<TrackFamily>& families, const std::vector<LaidTracks>& tracks);

/// The place of a piece's track in its family. O(1) in strips, O(tracks) along curves. Precondition: it has
/// one.
std::size_t place_of(const TrackFamily& family, const LaidPiece& piece);

/// A box that the swath of a part of a track does not leave, in the family's plane: on a straight track the
/// very rectangle.
Box swath_box(const StripGrid& grid, const Track& track, const Interval& part);

}  // namespace tramline
