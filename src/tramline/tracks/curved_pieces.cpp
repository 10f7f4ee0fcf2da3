#include "tramline/tracks/curved_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tramline {
namespace {

/// How far beyond its end a piece is asked what stopped it, m.
constexpr double kLookAhead = 1e-3;
/// A stretch shorter than this is nothing, as on straight strips, m.
constexpr double kNothing = 1e-3;

Intervals allowed_by(const EndCriterion& criterion, const PathProfile& body) {
  return criterion.by_centre_line ? centre_inside(body) : where_at_least(body, criterion.least_width_m);
}

class Clipper {
 public:
  Clipper(double width, const CurvedGround& ground, const EndCriterion& criterion, double min_length)
      : width_(width), ground_(ground), criterion_(criterion), min_length_(min_length) {}

  void clip(const FamilyTrack& track, int branch, CurvedTracks& out) const {
    const Path& path = track.track.path;
    if (!intersects(reach_of(path, width_), ground_.body.grid().bounds())) return;
    const PathProfile body = path_profile(ground_.body, path, width_);
    Intervals stretches = allowed_by(criterion_, body);
    if (stretches.empty()) return;
    PathProfile hard;
    if (!ground_.hard.edges().empty()) {
      hard = path_profile(ground_.hard, path, width_);
      stretches = without(stretches, where_at_least(hard, kWidthTolerance));
    }
    if (!ground_.field.edges().empty())
      stretches = common(stretches,
                         where_at_least(path_profile(ground_.field, path, width_), width_ - kWidthTolerance));
    std::erase_if(stretches, [](const Interval& s) { return s.length() < kNothing; });
    const bool round = track.track.closed && stretches.size() > 1 && stretches.front().from < kNothing &&
                       stretches.back().to > body.length() - kNothing;
    for (std::size_t i = round ? 1 : 0; i < stretches.size(); ++i) {
      CurvedPiece piece = piece_of(track, branch, stretches[i], body, hard);
      if (round && i + 1 == stretches.size())
        append_round(piece, piece_of(track, branch, stretches.front(), body, hard));
      const bool driven = piece.length_m >= min_length_;
      (driven ? out.pieces : out.dropped).push_back(std::move(piece));
    }
  }

 private:
  CurvedPiece piece_of(const FamilyTrack& track, int branch, const Interval& stretch, const PathProfile& body,
                       const PathProfile& hard) const {
    CurvedPiece piece{track.index, branch, stretch.from, stretch.to, {}, stretch.length()};
    piece.path = path_between(track.track.path, stretch.from, stretch.to);
    piece.inside_m2 = area_between(body, stretch.from, stretch.to);
    piece.stop_at_from = is_hard(hard, stretch.from - kLookAhead, stretch.from);
    piece.stop_at_to = is_hard(hard, stretch.to, stretch.to + kLookAhead);
    return piece;
  }

  /// On average over more than half the width tolerance.
  static bool is_hard(const PathProfile& hard, double from, double to) {
    return area_between(hard, from, to) > 0.5 * kLookAhead * kWidthTolerance;
  }

  static void append_round(CurvedPiece& piece, const CurvedPiece& rest) {
    piece.to += rest.length_m;
    piece.path.insert(piece.path.end(), rest.path.begin(), rest.path.end());
    piece.length_m += rest.length_m;
    piece.inside_m2 += rest.inside_m2;
    piece.stop_at_to = rest.stop_at_to;
  }

  double width_;
  const CurvedGround& ground_;
  const EndCriterion& criterion_;
  double min_length_;
};

/// Which side of the path the point is on, and how far off: right positive.
double signed_distance(const Path& path, Point p) {
  double least = std::numeric_limits<double>::infinity(), out = 0;
  for (const PathSegment& segment : path) {
    const double off = distance_to_edge(segment, p, p);
    if (off >= least) continue;
    least = off;
    const Point chord = segment.to - segment.from;
    bool right = cross(chord, p - segment.from) < 0;
    if (!segment.straight()) {
      const bool outside = distance(p, centre(segment)) > radius(segment);
      right = (segment.curvature > 0) == outside;
    }
    out = right ? off : -off;
  }
  return out;
}

}  // namespace

CurvedTracks curved_pieces(const std::vector<FamilyTrack>& family, double width_m, const CurvedGround& ground,
                           const EndCriterion& criterion, double min_length_m) {
  const Clipper clipper(width_m, ground, criterion, min_length_m);
  CurvedTracks out;
  int branch = 0;
  for (std::size_t i = 0; i < family.size(); ++i) {
    branch = i > 0 && family[i].index == family[i - 1].index ? branch + 1 : 0;
    clipper.clip(family[i], branch, out);
  }
  return out;
}

void append_curved_pieces(int index, std::vector<ParallelTrack> tracks, double width_m,
                          const CurvedGround& ground, const EndCriterion& criterion, double min_length_m,
                          CurvedTracks& out) {
  const Clipper clipper(width_m, ground, criterion, min_length_m);
  int branch = 0;
  for (ParallelTrack& track : tracks) clipper.clip({index, std::move(track)}, branch++, out);
}

TrackRange tracks_over(const Path& reference, const Box& box, double width_m) {
  // Points of the box are no farther off than its corners but for a bend between them: the distance to
  // the path changes by no more than the way.
  constexpr int kSteps = 16;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; j <= kSteps; ++j) {
      const Point p{box.min_x + box.width() * i / kSteps, box.min_y + box.height() * j / kSteps};
      const double off = signed_distance(reference, p);
      low = std::min(low, off);
      high = std::max(high, off);
    }
  const double slack = 0.5 * std::hypot(box.width(), box.height()) / kSteps;
  return {static_cast<int>(std::floor((low - slack) / width_m)),
          static_cast<int>(std::floor((high + slack) / width_m))};
}

}  // namespace tramline
