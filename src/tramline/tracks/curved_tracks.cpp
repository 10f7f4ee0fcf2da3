#include "tramline/tracks/curved_tracks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tramline/geometry/path/path_between.h"
#include "tramline/tracks/tolerances.h"

namespace tramline {
namespace {

class Laying {
 public:
  Laying(double width, const CurvedGround& ground, const EndCriterion& criterion)
      : width_(width), ground_(ground), criterion_(criterion) {}

  /// False where the track cannot be driven anywhere.
  bool lay(Track& track) const {
    if (!intersects(reach_of(track.path, width_), ground_.body.grid().bounds())) return false;
    profile(track);
    if (track.stretches.empty()) return false;
    if (!track.closed || track.hard_stretches.empty()) return true;
    begin_at(middle_of_longest(track), track);
    profile(track);
    return !track.stretches.empty();
  }

 private:
  void profile(Track& track) const {
    PathProfile body = path_profile(ground_.body, track.path, width_);
    track.length_m = body.length();
    track.subfield = TrackProfile(std::move(body));
    track.stretches = allowed_by(criterion_, track.subfield);
    if (track.stretches.empty()) return;
    if (!ground_.hard.edges().empty()) {
      track.hard = TrackProfile(path_profile(ground_.hard, track.path, width_));
      track.hard_stretches = track.hard.where_at_least(kWidthTolerance);
      track.stretches = without(track.stretches, track.hard_stretches);
    }
    track.passable_stretches = stretches_in(ground_.passable, track.path);
    track.stretches = without(track.stretches, stretches_in(ground_.beyond, track.path));
    if (!ground_.field.edges().empty())
      track.stretches =
          common(track.stretches,
                 where_at_least(path_profile(ground_.field, track.path, width_), width_ - kWidthTolerance));
    std::erase_if(track.stretches, [](const Interval& s) { return s.length() < kNoPiece_m; });
  }

  Intervals stretches_in(const EdgeIndex& region, const Path& path) const {
    if (region.edges().empty()) return {};
    return where_at_least(path_profile(region, path, width_), kWidthTolerance);
  }

  static double middle_of_longest(const Track& track) {
    Interval longest = track.stretches.front();
    for (const Interval& s : track.stretches)
      if (s.length() > longest.length()) longest = s;
    return 0.5 * (longest.from + longest.to);
  }

  static void begin_at(double position, Track& track) {
    Path path = path_between(track.path, position, track.length_m);
    const Path rest = path_between(track.path, 0, position);
    path.insert(path.end(), rest.begin(), rest.end());
    track.path = std::move(path);
  }

  double width_;
  const CurvedGround& ground_;
  const EndCriterion& criterion_;
};

/// Signed distances from a path, right positive.
class SignedDistances {
 public:
  explicit SignedDistances(const Path& path) : path_(path), reaches_(reaches_of(path, 0)) {}

  /// The segment nearest to a place that was asked for before is near this one too: what cannot be nearer is
  /// not measured. Of segments at the same distance the first counts, whatever was asked for before.
  double from(Point p) {
    double least = std::numeric_limits<double>::infinity(), out = 0;
    const double no_more_than = nearest_ < path_.size() ? distance_to_edge(path_[nearest_], p, p) : least;
    for (std::size_t i = 0; i < path_.size(); ++i) {
      if (at_least(reaches_[i], p) > std::min(least, no_more_than)) continue;
      const PathSegment& segment = path_[i];
      const double off = distance_to_edge(segment, p, p);
      if (off >= least) continue;
      least = off;
      nearest_ = i;
      out = is_right_of(segment, p) ? off : -off;
    }
    return out;
  }

 private:
  /// A lower bound of the distance from what lies in the box. Slightly smaller, so that rounding never rules
  /// a segment out.
  static double at_least(const Box& box, Point p) {
    constexpr double kLess = 1 - 1e-9;
    const double x = std::max({box.min_x - p.x, p.x - box.max_x, 0.0});
    const double y = std::max({box.min_y - p.y, p.y - box.max_y, 0.0});
    return kLess * std::sqrt(x * x + y * y) - kWidthTolerance;
  }

  static bool is_right_of(const PathSegment& segment, Point p) {
    if (segment.straight()) return cross(segment.to - segment.from, p - segment.from) < 0;
    const bool outside = distance(p, centre(segment)) > radius(segment);
    return (segment.curvature > 0) == outside;
  }

  const Path& path_;
  std::vector<Box> reaches_;
  std::size_t nearest_ = std::numeric_limits<std::size_t>::max();  ///< to the last place; beyond: to none
};

}  // namespace

TrackFamily curved_tracks(const std::vector<FamilyTrack>& parallel, double width_m,
                          const CurvedGround& ground, const EndCriterion& criterion) {
  const Laying laying(width_m, ground, criterion);
  TrackFamily out{{TrackFrame(), 0, width_m}, {}};
  int branch = 0;
  for (std::size_t i = 0; i < parallel.size(); ++i) {
    branch = i > 0 && parallel[i].index == parallel[i - 1].index ? branch + 1 : 0;
    Track track;
    track.index = parallel[i].index;
    track.branch = branch;
    track.closed = parallel[i].track.closed;
    track.path = parallel[i].track.path;
    if (laying.lay(track)) out.tracks.push_back(std::move(track));
  }
  return out;
}

LaidTracks curved_pieces(const std::vector<FamilyTrack>& parallel, double width_m, const CurvedGround& ground,
                         const EndCriterion& criterion, double min_length_m) {
  return cut_pieces(curved_tracks(parallel, width_m, ground, criterion), min_length_m);
}

StripRange tracks_over(const Path& reference, const Box& box, double width_m) {
  // Points of the box are no farther off than its corners, except for a bend between them: the distance to
  // the path changes by no more than the length moved.
  constexpr int kSteps = 16;
  SignedDistances distances(reference);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; j <= kSteps; ++j) {
      const Point p{box.min_x + box.width() * i / kSteps, box.min_y + box.height() * j / kSteps};
      const double off = distances.from(p);
      low = std::min(low, off);
      high = std::max(high, off);
    }
  const double slack = 0.5 * std::hypot(box.width(), box.height()) / kSteps;
  return {static_cast<int>(std::floor((low - slack) / width_m)),
          static_cast<int>(std::floor((high + slack) / width_m))};
}

}  // namespace tramline
