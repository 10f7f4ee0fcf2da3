#include "tramline/tracks/curved_pieces.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "tramline/geometry/path_between.h"

namespace tramline {
namespace {

/// How far beyond its end a piece is asked what stopped it, m.
constexpr double kLookAhead = 1e-3;
/// A stretch shorter than this is nothing, as on straight strips, m.
constexpr double kNothing = 1e-3;
/// A piece that goes all round ends this far before its beginning, m: a piece has two ends.
constexpr double kOpening = 1e-5;
/// What is left of a track between two detours that follow one another at once is no path, m.
constexpr double kNoPath = 1e-9;

Intervals allowed_by(const EndCriterion& criterion, const PathProfile& body) {
  return criterion.by_centre_line ? centre_inside(body) : where_at_least(body, criterion.least_width_m);
}

class Laying {
 public:
  Laying(double width, const CurvedGround& ground, const EndCriterion& criterion)
      : width_(width), ground_(ground), criterion_(criterion) {}

  /// False where the track may be driven nowhere.
  bool lay(CurvedTrack& track) const {
    if (!intersects(reach_of(track.path, width_), ground_.body.grid().bounds())) return false;
    profile(track);
    if (track.stretches.empty()) return false;
    if (!track.closed || track.by_hard.empty()) return true;
    begin_at(middle_of_longest(track), track);
    profile(track);
    return !track.stretches.empty();
  }

 private:
  void profile(CurvedTrack& track) const {
    track.body = path_profile(ground_.body, track.path, width_);
    track.length_m = track.body.length();
    track.stretches = allowed_by(criterion_, track.body);
    if (track.stretches.empty()) return;
    if (!ground_.hard.edges().empty()) {
      track.hard = path_profile(ground_.hard, track.path, width_);
      track.by_hard = where_at_least(track.hard, kWidthTolerance);
      track.stretches = without(track.stretches, track.by_hard);
    }
    track.by_passable = met(ground_.passable, track.path);
    track.stretches = without(track.stretches, met(ground_.beyond, track.path));
    if (!ground_.field.edges().empty())
      track.stretches =
          common(track.stretches,
                 where_at_least(path_profile(ground_.field, track.path, width_), width_ - kWidthTolerance));
    std::erase_if(track.stretches, [](const Interval& s) { return s.length() < kNothing; });
  }

  Intervals met(const EdgeIndex& region, const Path& path) const {
    if (region.edges().empty()) return {};
    return where_at_least(path_profile(region, path, width_), kWidthTolerance);
  }

  static double middle_of_longest(const CurvedTrack& track) {
    Interval longest = track.stretches.front();
    for (const Interval& s : track.stretches)
      if (s.length() > longest.length()) longest = s;
    return 0.5 * (longest.from + longest.to);
  }

  static void begin_at(double place, CurvedTrack& track) {
    Path path = path_between(track.path, place, track.length_m);
    const Path rest = path_between(track.path, 0, place);
    path.insert(path.end(), rest.begin(), rest.end());
    track.path = std::move(path);
  }

  double width_;
  const CurvedGround& ground_;
  const EndCriterion& criterion_;
};

/// On average over more than half the width tolerance.
bool is_hard(const CurvedTrack& track, double from, double to) {
  return area_between(track.hard, from, to) > 0.5 * kLookAhead * kWidthTolerance;
}

/// A position on a closed track counted from its beginning.
double wrapped(const CurvedTrack& track, double at) { return at > track.length_m ? at - track.length_m : at; }

Path driven_path(const CurvedTrack& track, const CurvedPiece& piece) {
  Path out;
  double at = piece.from;
  const auto keep_on_until = [&](double to) {
    if (to - at < kNoPath) return;
    Path part = path_along(track, at, to);
    if (part.empty()) return;
    if (!out.empty()) part.front().from = out.back().to;
    out.insert(out.end(), part.begin(), part.end());
  };
  for (const StripDetour& detour : piece.detours) {
    keep_on_until(detour.from);
    if (!out.empty()) out.back().to = detour.path.front().from;
    out.insert(out.end(), detour.path.begin(), detour.path.end());
    at = detour.to;
  }
  keep_on_until(piece.to);
  return out;
}

CurvedPiece piece_of(LaidPart part, const CurvedTrack& track) {
  CurvedPiece piece;
  piece.track = track.index;
  piece.branch = track.branch;
  piece.from = part.whole.from;
  piece.to = part.whole.to;
  piece.length_m = part.length_m;
  piece.after_crossing = part.after_crossing;
  piece.detours = std::move(part.detours);
  piece.path = driven_path(track, piece);
  for (const Interval& kept : parts_on_track(piece))
    piece.inside_m2 += inside_between(track, kept.from, kept.to);
  const double first = wrapped(track, piece.from), last = wrapped(track, piece.to);
  piece.stop_at_from = is_hard(track, first - kLookAhead, first);
  piece.stop_at_to = is_hard(track, last, last + kLookAhead);
  return piece;
}

void move_on(JoinedStretch& joined, double by) {
  joined.whole = {joined.whole.from + by, joined.whole.to + by};
  for (StripDetour& detour : joined.detours) {
    detour.from += by;
    detour.to += by;
  }
}

/// The stretch before the beginning of a closed track goes on behind it. One that is driven all round
/// begins where work is interrupted.
void close(const CurvedTrack& track, std::vector<JoinedStretch>& stretches) {
  if (stretches.empty() || stretches.front().whole.from > kNothing ||
      stretches.back().whole.to < track.length_m - kNothing)
    return;
  if (stretches.size() > 1) {
    move_on(stretches.front(), track.length_m);
    stretches.back().whole.to = stretches.front().whole.to;
    std::vector<StripDetour>& detours = stretches.front().detours;
    std::move(detours.begin(), detours.end(), std::back_inserter(stretches.back().detours));
    stretches.erase(stretches.begin());
    return;
  }
  JoinedStretch& round = stretches.front();
  if (!round.detours.empty()) return;
  if (track.by_passable.empty()) {
    round.whole.to = track.length_m - kOpening;
    return;
  }
  const double first = track.by_passable.front().to;
  if (first < track.length_m - kNothing) round.whole = {first, first + track.length_m};
}

/// What lies along a track, once more where a closed one goes on.
Intervals going_on(const Intervals& along, double length_m) {
  Intervals out = along;
  for (const Interval& one : along) append_joining(out, {one.from + length_m, one.to + length_m});
  return out;
}

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

std::vector<CurvedTrack> curved_tracks(const std::vector<FamilyTrack>& family, double width_m,
                                       const CurvedGround& ground, const EndCriterion& criterion) {
  const Laying laying(width_m, ground, criterion);
  std::vector<CurvedTrack> out;
  int branch = 0;
  for (std::size_t i = 0; i < family.size(); ++i) {
    branch = i > 0 && family[i].index == family[i - 1].index ? branch + 1 : 0;
    CurvedTrack track;
    track.index = family[i].index;
    track.branch = branch;
    track.closed = family[i].track.closed;
    track.path = family[i].track.path;
    if (laying.lay(track)) out.push_back(std::move(track));
  }
  return out;
}

void append_joined(const CurvedTrack& track, const JoinedStretch& joined, double min_length_m,
                   CurvedTracks& out) {
  const Intervals passable = track.closed ? going_on(track.by_passable, track.length_m) : track.by_passable;
  for (LaidPart& part : laid_parts(joined, passable, min_length_m)) {
    const bool driven = part.driven;
    (driven ? out.pieces : out.dropped).push_back(piece_of(std::move(part), track));
  }
}

void append_pieces(const CurvedTrack& track, const std::vector<StripDetour>& detours, double min_length_m,
                   CurvedTracks& out) {
  std::vector<JoinedStretch> stretches = joined_stretches(track.stretches, detours);
  if (track.closed) close(track, stretches);
  for (const JoinedStretch& joined : stretches) append_joined(track, joined, min_length_m, out);
}

CurvedTracks cut_pieces(const std::vector<CurvedTrack>& tracks, double min_length_m) {
  CurvedTracks out;
  for (const CurvedTrack& track : tracks) append_pieces(track, {}, min_length_m, out);
  return out;
}

CurvedTracks curved_pieces(const std::vector<FamilyTrack>& family, double width_m, const CurvedGround& ground,
                           const EndCriterion& criterion, double min_length_m) {
  return cut_pieces(curved_tracks(family, width_m, ground, criterion), min_length_m);
}

Intervals parts_on_track(const CurvedPiece& piece) {
  Intervals out;
  double at = piece.from;
  for (const StripDetour& detour : piece.detours) {
    if (detour.from > at) out.push_back({at, detour.from});
    at = detour.to;
  }
  if (piece.to > at) out.push_back({at, piece.to});
  return out;
}

Path path_along(const CurvedTrack& track, double from, double to) {
  if (to <= track.length_m) return path_between(track.path, from, to);
  if (from >= track.length_m) return path_between(track.path, from - track.length_m, to - track.length_m);
  Path out = path_between(track.path, from, track.length_m);
  const Path rest = path_between(track.path, 0, to - track.length_m);
  out.insert(out.end(), rest.begin(), rest.end());
  return out;
}

double inside_between(const CurvedTrack& track, double from, double to) {
  if (to <= track.length_m) return area_between(track.body, from, to);
  if (from >= track.length_m) return area_between(track.body, from - track.length_m, to - track.length_m);
  return area_between(track.body, from, track.length_m) + area_between(track.body, 0, to - track.length_m);
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
