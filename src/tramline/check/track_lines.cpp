#include "tramline/check/track_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tramline/check/sound_path.h"
#include "tramline/check/tolerances.h"
#include "tramline/geometry/path_between.h"

namespace tramline::check {
namespace {

/// How far along a segment the place on it nearest to a point is.
double along_of(const PathSegment& segment, Point p) {
  const double whole_m = length(segment);
  if (segment.straight())
    return std::clamp(dot(p - segment.from, segment.to - segment.from) / whole_m, 0.0, whole_m);
  const Point middle = centre(segment), first = segment.from - middle, there = p - middle;
  const double angle = std::atan2(cross(first, there), dot(first, there)) * segment.curvature;
  const double along_m = angle * radius(segment) * radius(segment);
  // Half a circle on, rounding may say that it is half a circle back.
  if (along_m < 0) return -along_m > 0.5 * whole_m ? whole_m : 0;
  return std::min(along_m, whole_m);
}

Point heading_at(const Path& path, double along_m) {
  constexpr double kAhead_m = 1e-4;
  const Path part = path_between(path, along_m, along_m + kAhead_m);
  return part.empty() ? direction_at_end(path.back()) : direction_at_start(part.front());
}

/// A path that parallels can be made of: sound, no tighter than tracks, without kinks.
bool can_be_followed(const Path& reference, const Machine& machine) {
  const double least_m = std::max(machine.radius_m, 0.5 * machine.width_m);
  if (!fault_of(reference).empty() || smallest_radius(reference) < least_m * (1 - kRadiusShare)) return false;
  for (std::size_t i = 0; i + 1 < reference.size(); ++i)
    if (distance(direction_at_end(reference[i]), direction_at_start(reference[i + 1])) > 1e-3) return false;
  return true;
}

}  // namespace

TrackLines::TrackLines(const Plan& plan) {
  if (plan.reference.empty() || !is_curved(plan) || !can_be_followed(plan.reference, plan.machine)) return;
  int first = std::numeric_limits<int>::max(), last = std::numeric_limits<int>::min();
  const auto extend = [&](int track) {
    first = std::min(first, track);
    last = std::max(last, track);
  };
  for (const TrackPiece& piece : plan.pieces) extend(piece.track);
  for (const Encounter& encounter : plan.encounters) extend(encounter.track);
  // More have no room between the farthest places of a map.
  constexpr int kMost = 100000;
  if (first < -kMost || last > kMost) return;
  TrackLimits limits;
  limits.radius_m = plan.machine.radius_m;
  limits.width_m = plan.machine.width_m;
  lines_ = parallel_family(plan.reference, first, last, limits);
  for (const FamilyTrack& line : lines_) {
    lengths_m_.push_back(tramline::length(line.track.path));
    boxes_.push_back(reach_of(line.track.path, 2 * kLengthTolerance_m));
    std::vector<Segment>& segments = segments_.emplace_back();
    double from_m = 0;
    const std::vector<Box> reaches = reaches_of(line.track.path, 2 * kLengthTolerance_m);
    for (std::size_t i = 0; i < reaches.size(); ++i) {
      // Flat ends reach no further than the line.
      segments.push_back({from_m, reaches[i].grown(kLengthTolerance_m)});
      from_m += tramline::length(line.track.path[i]);
    }
  }
}

std::optional<double> TrackLines::place_on(std::size_t line, Point p) const {
  double nearest_m = kLengthTolerance_m;
  std::optional<double> out;
  const auto in = [p](const Box& box) {
    return p.x >= box.min_x && p.x <= box.max_x && p.y >= box.min_y && p.y <= box.max_y;
  };
  if (!in(boxes_[line])) return out;
  const Path& path = lines_[line].track.path;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Segment& segment = segments_[line][i];
    if (!in(segment.reach)) continue;
    const double off_m = distance_to_edge(path[i], p, p);
    if (off_m >= nearest_m) continue;
    nearest_m = off_m;
    out = segment.from_m + along_of(path[i], p);
  }
  return out;
}

std::optional<OnLine> TrackLines::stretch(std::size_t line, double from_m, double to_m) const {
  if (to_m > from_m) return OnLine{line, from_m, to_m};
  if (closed(line)) return OnLine{line, from_m, to_m + lengths_m_[line]};
  return std::nullopt;
}

std::optional<OnLine> TrackLines::between(int track, Point from, Point heading, Point to) const {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (lines_[i].index != track) continue;
    const std::optional<double> first = place_on(i, from), last = place_on(i, to);
    if (!first || !last) continue;
    const bool back = dot(heading, heading_at(lines_[i].track.path, *first)) < 0;
    if (const auto found = back ? stretch(i, *last, *first) : stretch(i, *first, *last)) return found;
  }
  return std::nullopt;
}

Path TrackLines::path_of(const OnLine& stretch) const {
  const Path& path = lines_[stretch.line].track.path;
  const double whole_m = lengths_m_[stretch.line];
  Path out = path_between(path, stretch.from_m, std::min(stretch.to_m, whole_m));
  if (stretch.to_m > whole_m) {
    const Path rest = path_between(path, std::max(0.0, stretch.from_m - whole_m), stretch.to_m - whole_m);
    out.insert(out.end(), rest.begin(), rest.end());
  }
  return out;
}

bool holds(const TrackLines& lines, const OnLine& stretch, Point p) {
  const std::optional<double> place_m = lines.place_on(stretch.line, p);
  if (!place_m) return false;
  const auto within = [&stretch](double at_m) {
    return at_m >= stretch.from_m - kLengthTolerance_m && at_m <= stretch.to_m + kLengthTolerance_m;
  };
  return within(*place_m) || (lines.closed(stretch.line) && within(*place_m + lines.length_m(stretch.line)));
}

}  // namespace tramline::check
