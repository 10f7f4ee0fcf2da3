#include "tramline/coverage/drive/plan_runs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tramline/geometry/path/path_between.h"

namespace tramline::coverage {
namespace {

/// How far the axle is ahead of the implement, m.
double ahead_m(const Turning& turning) {
  return turning.implement_offset_m + (turning.implement == Coupling::kTowed ? turning.drawbar_m : 0);
}

/// A place on a path and the way it goes there.
struct Along {
  Point at;
  Point direction;
};

Along place_on(const PathSegment& segment, double share) {
  const Point start = direction_at_start(segment);
  if (segment.straight()) return {segment.from + share * (segment.to - segment.from), start};
  const double turn = share * turning(segment);
  const Point middle = centre(segment);
  return {middle + turned(segment.from - middle, turn), turned(start, turn)};
}

/// Beyond its ends the path goes straight on.
Along place_on(const Path& path, double at_m) {
  if (at_m <= 0) {
    const Point direction = direction_at_start(path.front());
    return {path.front().from + at_m * direction, direction};
  }
  for (const PathSegment& segment : path) {
    const double length_m = length(segment);
    if (at_m <= length_m) return place_on(segment, at_m / length_m);
    at_m -= length_m;
  }
  const Point direction = direction_at_end(path.back());
  return {path.back().to + at_m * direction, direction};
}

/// How little the pose fits the place: metres aside, and one more for each unit by which directions differ.
double misfit(const Along& place, const tramline::Pose& pose) {
  return distance(place.at, pose.at) + distance(place.direction, pose.heading.unit());
}

/// The share of the segment at which it is nearest to a place.
double nearest_share(const PathSegment& segment, Point p) {
  if (segment.straight()) {
    const Point way = segment.to - segment.from;
    return std::clamp(dot(p - segment.from, way) / dot(way, way), 0.0, 1.0);
  }
  const double turn = turning(segment);
  const Point from = segment.from - centre(segment), to = p - centre(segment);
  const double angle = std::atan2(cross(from, to), dot(from, to));
  // An arc of half a circle or less: what lies on the other side of its beginning is nearer to one of its
  // ends.
  const double share = angle / turn;
  if (share >= 0 && share <= 1) return share;
  return distance(segment.from, p) <= distance(segment.to, p) ? 0 : 1;
}

/// A closed path from where the axle enters it, less what the axle is ahead; `misfit` tells how well the
/// sense of the path is that of the axle.
std::pair<double, Path> entered(const Path& path, const tramline::Pose& axle, double ahead_m) {
  double least = std::numeric_limits<double>::infinity(), at_m = 0, before_m = 0;
  for (const PathSegment& segment : path) {
    const double share = nearest_share(segment, axle.at);
    if (const double here = misfit(place_on(segment, share), axle); here < least) {
      least = here;
      at_m = before_m + share * length(segment);
    }
    before_m += length(segment);
  }
  const double whole_m = length(path);
  double from_m = std::fmod(at_m - ahead_m, whole_m);
  if (from_m < 0) from_m += whole_m;
  // Ends of a segment stay whole: a stretch of a rounding error would be a sliver.
  constexpr double kNoLength_m = 1e-6;
  if (from_m < kNoLength_m || from_m > whole_m - kNoLength_m) return {least, path};
  Path out = path_between(path, from_m, whole_m);
  const Path rest = path_between(path, 0, from_m);
  out.insert(out.end(), rest.begin(), rest.end());
  return {least, std::move(out)};
}

/// The path of a piece or a pass as the leg drives it: in its sense, and a closed one from where it enters
/// it.
Path as_driven(const Path& path, bool closed, const RouteLeg& leg, const Turning& turning) {
  if (leg.path.empty()) return path;
  const tramline::Pose& axle = leg.path.front().start;
  const double ahead = ahead_m(turning);
  const Path back = reversed(path);
  if (!closed)
    return misfit(place_on(path, ahead), axle) <= misfit(place_on(back, ahead), axle) ? path : back;
  auto [along_misfit, along] = entered(path, axle, ahead);
  auto [against_misfit, against] = entered(back, axle, ahead);
  return along_misfit <= against_misfit ? std::move(along) : std::move(against);
}

/// By number: pieces, then passes.
std::vector<PlanRun> all_runs(const Plan& plan) {
  std::vector<PlanRun> out;
  for (const TrackPiece& piece : plan.pieces)
    out.push_back({static_cast<int>(out.size()), centre_line(piece)});
  for (const HeadlandPass& pass : plan.headland.passes)
    out.push_back({static_cast<int>(out.size()), pass.path});
  return out;
}

/// The number of the run that a leg is part of; nullopt where it is of none that there is.
std::optional<std::size_t> run_of(const Plan& plan, const RouteLeg& leg) {
  if (leg.kind == LegKind::kWork && leg.piece && *leg.piece < plan.pieces.size()) return *leg.piece;
  if (leg.pass && *leg.pass < plan.headland.passes.size()) return plan.pieces.size() + *leg.pass;
  return std::nullopt;
}

}  // namespace

bool is_of_pass(const Plan& plan, const PlanRun& run) { return run.run >= std::ssize(plan.pieces); }

std::vector<PlanRun> runs_of(const Plan& plan) {
  std::vector<PlanRun> all = all_runs(plan);
  if (!plan.route.planned()) return all;
  std::vector<PlanRun> out;
  std::vector<bool> driven(all.size(), false);
  for (const RouteLeg& leg : plan.route.legs) {
    const std::optional<std::size_t> number = run_of(plan, leg);
    if (!number || driven[*number]) continue;
    driven[*number] = true;
    const bool closed =
        is_of_pass(plan, all[*number]) && is_closed(plan.headland.passes[*number - plan.pieces.size()]);
    out.push_back({all[*number].run, as_driven(all[*number].path, closed, leg, plan.machine.turning)});
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!driven[i]) out.push_back(std::move(all[i]));
  return out;
}

}  // namespace tramline::coverage
