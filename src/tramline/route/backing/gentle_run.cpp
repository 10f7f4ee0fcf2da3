#include "tramline/route/backing/gentle_run.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tramline {
namespace {

/// Lines are followed as long as they turn by no more than this, as a sine.
constexpr double kBent = 0.5;
/// Stretches meet without a kink where their headings differ by no more than this sine, and are no sharper
/// than the machine turns where their radii are no less than its own by more than this share.
constexpr double kNoKink = 1e-6, kSharper = 1e-6;
/// A run is longer than another where it is so by this, m.
constexpr double kLonger_m = 1;

double turned(const Pose& pose, Point from) {
  const Point heading = pose.heading.unit();
  return dot(heading, from) > 0 ? std::abs(cross(heading, from)) : 1;
}

bool can_drive_on(const SteeredStretch& stretch, const Pose& before, double radius_m) {
  return !stretch.clothoid() && turned(stretch.start, before.heading.unit()) <= kNoKink &&
         std::abs(stretch.curvature_at_start) * radius_m <= 1 + kSharper;
}

}  // namespace

GentleRun first_run(std::span<const SteeredStretch> line, double radius_m) {
  assert(!line.empty());
  GentleRun out;
  const Point begins = line.front().start.heading.unit();
  Pose before = line.front().start;
  for (const SteeredStretch& stretch : line) {
    const Pose end = end_of(stretch);
    if (!can_drive_on(stretch, before, radius_m)) break;
    if (std::max(turned(stretch.start, begins), turned(end, begins)) > kBent) break;
    out.bent = std::max(out.bent, turned(end, begins));
    out.line.push_back(stretch);
    before = end;
  }
  out.to_end = out.line.size() == line.size();
  return out;
}

std::optional<GentleRun> longest_run_behind_bends(const SteeredPath& line, double radius_m) {
  assert(!line.empty());
  std::optional<GentleRun> out;
  std::span<const SteeredStretch> rest = line;
  GentleRun run = first_run(rest, radius_m);
  double longest_m = length(run.line);
  while (!run.to_end) {
    // Over the stretch that turns too far, and on from there.
    const Pose before = run.line.empty() ? rest.front().start : end_of(run.line.back());
    const SteeredStretch& bend = rest[run.line.size()];
    const double begins_m = run.begins_m + length(run.line) + bend.length_m;
    rest = rest.subspan(run.line.size() + 1);
    if (!can_drive_on(bend, before, radius_m) || rest.empty()) break;
    if (!can_drive_on(rest.front(), end_of(bend), radius_m)) break;
    run = first_run(rest, radius_m);
    run.begins_m = begins_m;
    if (length(run.line) <= longest_m + kLonger_m) continue;
    longest_m = length(run.line);
    out = run;
  }
  return out;
}

}  // namespace tramline
