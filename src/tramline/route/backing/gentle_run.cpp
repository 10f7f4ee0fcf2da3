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
/// Shorter parts of stretches are not followed, m.
constexpr double kLeastPart_m = 0.01;
/// A run is longer than another where it is so by this, m.
constexpr double kLonger_m = 1;

double turned(const Pose& pose, Point from) {
  const Point heading = pose.heading.unit();
  return dot(heading, from) > 0 ? std::abs(cross(heading, from)) : 1;
}

/// How far along a stretch the machine drives until it points as far aside as lines are followed, m.
double until_bent_m(const SteeredStretch& arc, Point begins) {
  const double rate = (arc.gear == Gear::kForward ? 1 : -1) * arc.curvature_at_start;
  if (rate == 0) return arc.length_m;
  const double aside = std::asin(std::clamp(cross(begins, arc.start.heading.unit()), -1.0, 1.0));
  return (std::asin(kBent) - std::copysign(1.0, rate) * aside) / std::abs(rate);
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
    if (!can_drive_on(stretch, before, radius_m) || turned(stretch.start, begins) > kBent) break;
    const double follows_m = std::min(stretch.length_m, until_bent_m(stretch, begins));
    if (follows_m < stretch.length_m && follows_m < kLeastPart_m) break;
    out.line.push_back(stretch);
    out.line.back().length_m = follows_m;
    before = end_of(out.line.back());
    out.bent = std::max(out.bent, std::min(kBent, turned(before, begins)));
    if (follows_m < stretch.length_m) break;
    ++out.whole;
  }
  out.to_end = out.whole == line.size();
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
    const Pose before = run.whole == 0 ? rest.front().start : end_of(rest[run.whole - 1]);
    const SteeredStretch& bend = rest[run.whole];
    double begins_m = run.begins_m + bend.length_m;
    for (const SteeredStretch& followed : rest.first(run.whole)) begins_m += followed.length_m;
    rest = rest.subspan(run.whole + 1);
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
