#include "tramline/tracks/zhou_tracks.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "tramline/geometry/path/extended_line.h"
#include "tramline/geometry/path/kinked_line.h"
#include "tramline/geometry/path/kinked_offset.h"
#include "tramline/geometry/path/path_between.h"
#include "tramline/tracks/zhou_track_extent.h"

namespace tramline {
namespace {

class Recursion {
 public:
  Recursion(double width_m, const Region& body) : width_m_(width_m), body_(body), box_(bounds(body)) {}

  /// The tracks to one side (+1: right) of the extended line, from it outwards.
  void add_side(const std::vector<Point>& line, int side, std::vector<LaidPiece>& out) const {
    std::vector<Point> next = kinked_offset(line, 0.5 * side * width_m_);
    bool entered = false;  // a line may begin before the box
    for (int i = 0; i < most_tracks() && next.size() > 1; ++i) {
      const Path track = extended_over(next, width_m_, body_);
      const Interval driven = add_pieces(track, side > 0 ? i : -1 - i, out);
      const bool within = driven.length() > 0 || meets_box(track);
      if (entered && !within) return;
      entered = entered || within;
      const Path last = driven.length() > 0 ? path_between(track, driven.from, driven.to) : track;
      next = kinked_offset(vertices_of(last), side * width_m_);
    }
  }

 private:
  /// From the first piece to the last: the final track t′. Empty without a piece.
  Interval add_pieces(const Path& track, int number, std::vector<LaidPiece>& out) const {
    Interval whole{};
    for (std::size_t part = 0; part < body_.size(); ++part)
      for (const Interval& reach : zhou_track_extent(track, width_m_, body_[part])) {
        if (whole.length() <= 0)
          whole = reach;
        else
          whole = {std::min(whole.from, reach.from), std::max(whole.to, reach.to)};
        out.push_back({number, static_cast<int>(part), reach.from, reach.to,
                       path_between(track, reach.from, reach.to), reach.length()});
      }
    return whole;
  }

  bool meets_box(const Path& track) const {
    const Polygon box{{{box_.min_x, box_.min_y},
                       {box_.max_x, box_.min_y},
                       {box_.max_x, box_.max_y},
                       {box_.min_x, box_.max_y}},
                      {}};
    return !zhou_track_extent(track, width_m_, box).empty();
  }

  /// Twice the number that parallel tracks would need: a line that bends back on itself might go on for ever.
  int most_tracks() const {
    return 2 * static_cast<int>(std::ceil(std::hypot(box_.width(), box_.height()) / width_m_)) + 2;
  }

  double width_m_;
  const Region& body_;
  Box box_;
};

}  // namespace

Path extended_over(const std::vector<Point>& line, double width_m, const Region& body) {
  Path out = extended(polyline_path(line), bounds(body).grown(width_m)).path;
  // An extension is merged into its edge: otherwise each track would gain two edges over the one before.
  if (out.size() > 1 && out.front().to == line.front()) {
    out[1].from = out.front().from;
    out.erase(out.begin());
  }
  if (out.size() > 1 && out.back().from == line.back()) {
    out[out.size() - 2].to = out.back().to;
    out.pop_back();
  }
  return out;
}

LaidTracks zhou_tracks(const std::vector<Point>& line, double width_m, const Region& body,
                       double min_length_m) {
  assert(line.size() >= 2);
  assert(std::adjacent_find(line.begin(), line.end()) == line.end());
  assert(!body.empty());
  const Recursion recursion(width_m, body);
  const std::vector<Point> whole = vertices_of(extended_over(line, width_m, body));
  std::vector<LaidPiece> pieces;
  for (const int side : {-1, 1}) recursion.add_side(whole, side, pieces);
  std::stable_sort(pieces.begin(), pieces.end(), [](const LaidPiece& a, const LaidPiece& b) {
    return a.track != b.track ? a.track < b.track : a.from < b.from;
  });
  LaidTracks out{{TrackFrame(), 0, width_m}, {}, {}};
  for (LaidPiece& piece : pieces)
    (piece.length_m >= min_length_m ? out.pieces : out.dropped).push_back(std::move(piece));
  return out;
}

}  // namespace tramline
