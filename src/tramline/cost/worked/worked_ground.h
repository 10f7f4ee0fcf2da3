#pragma once
// The swaths of a plan in the making, indexed for what they cover near a given box.

#include <optional>
#include <vector>

#include "tramline/geometry/path/newly_covered_area.h"
#include "tramline/tracks/laid_pieces.h"

namespace tramline {

/// The parts of one track that are worked.
struct TrackWork {
  Intervals on_track;  ///< ascending, apart
  std::vector<TrackDetour> detours;
};
inline bool is_driven(const TrackWork& work) { return !work.on_track.empty() || !work.detours.empty(); }

/// The worked land, as swaths by family and track: rows of strips, swaths along curves, and detours of both.
/// Families may lie in different planes. Refers to the families.
class WorkedGround {
 public:
  explicit WorkedGround(const std::vector<TrackFamily>& families);
  /// Replaces the worked parts of one track. `track` is its index in the family.
  void set(std::size_t family, std::size_t track, TrackWork work);
  const TrackWork& at(std::size_t family, std::size_t track) const;

  /// Adds, as kCovered, every swath that reaches into one of the boxes, which lie in the window, in the plane
  /// of a family; without those of its track `except`. O(tracks near the window) of strips, O(tracks) of
  /// curves.
  void append_covered(std::size_t family, const Box& window, const std::vector<Box>& boxes,
                      std::optional<std::size_t> except, RisingCurves& out) const;
  /// Whether no other swath can meet a swath that keeps to its track in this box of its plane. Then it covers
  /// exactly the part of its subfield in it. True only where there are no other families.
  bool is_alone(std::size_t family, const Box& box, std::size_t track) const;

 private:
  struct Swath {
    PathSegment line;
    Box reach;
  };
  struct Worked {
    TrackWork work;
    std::vector<Box> reach;      ///< of the detours
    std::vector<Swath> along{};  ///< parts of a curved track that are kept to
    Box whole{};                 ///< of all of `along`
  };
  struct Family {
    const TrackFamily& tracks;
    std::vector<Worked> worked;  ///< by track
    double bulge_m = 0;          ///< largest distance by which a detour has ever left its strip
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

/// The land worked where pieces keep to their tracks, and by whole pieces with detours. `tracks` by family.
WorkedGround worked_on_tracks(const std::vector<TrackFamily>& families,
                              const std::vector<LaidTracks>& tracks);
WorkedGround worked_by(const std::vector<TrackFamily>& families, const std::vector<LaidTracks>& tracks);

/// The index of a piece's track in its family. O(1) in strips, O(tracks) along curves. Precondition: it has
/// one.
std::size_t index_in_family(const TrackFamily& family, const LaidPiece& piece);

/// A box that contains the swath of a part of a track, in the family's plane: on a straight track the exact
/// rectangle.
Box swath_box(const StripGrid& grid, const Track& track, const Interval& part);

}  // namespace tramline
