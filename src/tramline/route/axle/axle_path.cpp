#include "tramline/route/axle/axle_path.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tramline/turns/track_ends.h"

namespace tramline {
namespace {

Heading heading_along(Point direction) { return Heading::from_to({0, 0}, direction); }

/// Appends, where it has a length.
void append(SteeredPath& path, const SteeredStretch& stretch) {
  if (stretch.length_m > 0) path.push_back(stretch);
}

/// The part of a stretch between two positions on it.
SteeredStretch cut(const SteeredStretch& stretch, double from_m, double to_m) {
  const double change =
      stretch.length_m > 0 ? (stretch.curvature_at_end - stretch.curvature_at_start) / stretch.length_m : 0;
  SteeredStretch out = stretch;
  if (from_m > 0) out.start = pose_after(stretch, from_m);
  out.length_m = to_m - from_m;
  out.curvature_at_start = stretch.curvature_at_start + change * from_m;
  if (to_m < stretch.length_m) out.curvature_at_end = stretch.curvature_at_start + change * to_m;
  if (!stretch.clothoid()) out.curvature_at_end = out.curvature_at_start;
  return out;
}

}  // namespace

SteeredPath steered(const Path& path) {
  SteeredPath out;
  out.reserve(path.size());
  for (const PathSegment& segment : path)
    append(out, {{segment.from, heading_along(direction_at_start(segment))},
                 length(segment),
                 segment.curvature,
                 segment.curvature});
  return out;
}

SteeredPath part_of(const SteeredPath& path, double from_m, double to_m) {
  SteeredPath out;
  double begins_m = 0;
  for (const SteeredStretch& stretch : path) {
    const double low = std::max(0.0, from_m - begins_m);
    const double high = std::min(stretch.length_m, to_m - begins_m);
    if (high > low) out.push_back(cut(stretch, low, high));
    begins_m += stretch.length_m;
  }
  return out;
}

Pose end_of(const SteeredPath& path) {
  assert(!path.empty());
  return end_of(path.back());
}

Pose pose_on(const SteeredPath& path, double at_m) {
  assert(!path.empty());
  const Pose& start = path.front().start;
  if (at_m <= 0) return {start.at + at_m * start.heading.unit(), start.heading};
  double begins_m = 0;
  for (const SteeredStretch& stretch : path) {
    if (at_m - begins_m <= stretch.length_m) return pose_after(stretch, at_m - begins_m);
    begins_m += stretch.length_m;
  }
  const Pose last = end_of(path);
  return {last.at + (at_m - begins_m) * last.heading.unit(), last.heading};
}

SteeredPath axle_path(const Path& path, const Turning& turning) {
  const double back_m = reach_back_m(turning);
  SteeredPath whole = steered(path);
  if (back_m == 0) return whole;
  const double length_m = length(whole);
  SteeredPath out;
  if (back_m < 0) {
    append(out, {pose_on(whole, back_m), std::min(-back_m, length_m), 0, 0});
    for (const SteeredStretch& stretch : part_of(whole, 0, length_m + back_m)) append(out, stretch);
    return out;
  }
  out = part_of(whole, back_m, length_m);
  const double beyond_m = std::max(0.0, back_m - length_m);
  append(out, {pose_on(whole, length_m + beyond_m), std::min(back_m, length_m), 0, 0});
  return out;
}

SteeredPath axle_path(const TrackPiece& piece, const Turning& turning) {
  return axle_path(centre_line(piece), turning);
}

SteeredPath closed_axle_path(const Path& path, double entered_m, const Turning& turning) {
  const SteeredPath whole = steered(path);
  const double length_m = length(whole);
  double from_m = std::fmod(entered_m + reach_back_m(turning), length_m);
  if (from_m < 0) from_m += length_m;
  SteeredPath out = part_of(whole, from_m, length_m);
  for (const SteeredStretch& stretch : part_of(whole, 0, from_m)) append(out, stretch);
  return out;
}

}  // namespace tramline
