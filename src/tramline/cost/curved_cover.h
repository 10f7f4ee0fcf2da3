#pragma once
// What curved tracks with detours cover, exactly: swaths are cut by lines and arcs, not by chords.

#include <vector>

#include "tramline/geometry/layered_area.h"
#include "tramline/tracks/curved_tracks.h"

namespace tramline {

/// The swaths of curved tracks in the making, ready to be asked what they cover near one place.
class CurvedCover {
 public:
  explicit CurvedCover(std::size_t tracks) : tracks_(tracks) {}
  /// Replaces what is worked of one track: where it keeps to its line, and its detours.
  void set(std::size_t track, const std::vector<Path>& kept, const std::vector<TrackDetour>& detours,
           double width_m);
  void add(std::size_t track, const Path& path, double width_m);

  /// Adds, as taken, every swath of other tracks that reaches into the window. O(segments near by).
  void append_taken(const Box& window, std::size_t except, RisingCurves& out) const;
  /// Those of all tracks.
  void append_taken(const Box& window, RisingCurves& out) const;
  /// Does a detour of another track reach into the window?
  bool detours_near(const Box& window, std::size_t except) const;

 private:
  struct Swath {
    PathSegment line;
    Box reach;
  };
  struct Worked {
    double width_m = 0;
    std::vector<Swath> swaths;
    std::vector<Box> detours;
    Box reach;
  };
  static void append(const Worked& track, const Box& window, RisingCurves& out);

  std::vector<Worked> tracks_;
};

/// What a swath covers of the body that nothing else does, m². O(n + m) for n edges and m swaths near by.
double new_area_of(const Path& path, double width_m, const std::vector<Ring>& body, const CurvedCover& cover,
                   std::size_t except);

/// Body that detours cover and no part of a track outside its detours does, m². O(d·m) for d detours and m
/// edges of the body.
double covered_by_detours_m2(const Region& body, const TrackFamily& family, const LaidTracks& laid,
                             double width_m);

}  // namespace tramline
