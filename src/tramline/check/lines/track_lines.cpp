#include "tramline/check/lines/track_lines.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tramline/check/measure/plan_facts.h"
#include "tramline/check/measure/sound_path.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// Whether parallels can be made of the path: sound, no tighter than tracks, without kinks.
bool can_be_followed(const Path& reference, double least_radius_m) {
  if (!fault_of(reference).empty() || smallest_radius(reference) < least_radius_m * (1 - kRadiusShare))
    return false;
  for (std::size_t i = 0; i + 1 < reference.size(); ++i)
    if (distance(direction_at_end(reference[i]), direction_at_start(reference[i + 1])) > kSameHeading)
      return false;
  return true;
}

/// Sampling positions: ends and middles of all segments, and positions a quarter of the width apart, or as
/// close as their largest number allows.
std::vector<double> looks_along(const Path& reference, double width_m) {
  constexpr double kMost = 1e6;
  const double step_m = std::max(0.25 * width_m, length(reference) / kMost);
  std::vector<double> out{0};
  double from_m = 0;
  for (const PathSegment& segment : reference) {
    const double length_m = length(segment);
    const int parts = 2 * std::max(1, static_cast<int>(std::ceil(0.5 * length_m / step_m)));
    for (int k = 1; k < parts; ++k) out.push_back(from_m + length_m * k / parts);
    from_m += length_m;
    out.push_back(from_m);
  }
  return out;
}

}  // namespace

TrackLines::TrackLines(const Path& reference, const Machine& machine)
    : width_m_(machine.width_m), least_radius_m_(check::least_radius_m(machine)) {
  if (reference.empty() || !can_be_followed(reference, least_radius_m_)) return;
  for (const Path& line : {reference, reversed(reference)}) {
    sides_.emplace_back(line);
    looks_m_.push_back(looks_along(line, width_m_));
  }
}

double TrackLines::off_m(int track) const { return std::abs(track + 0.5) * width_m_; }

ParallelLine TrackLines::line(int track) const {
  assert(known());
  return {side_of(track), looks_m_[track < 0 ? 1 : 0], off_m(track), width_m_, least_radius_m_};
}

std::vector<int> TrackLines::tracks_near(Point p) const {
  assert(known());
  const Foot foot = sides_.front().foot_of(p);
  // In the middle of the sharpest corner the arc is half its radius farther off.
  const double least_m = foot.off_m - 0.5 * least_radius_m_ - kLengthTolerance_m;
  std::vector<int> out;
  for (int k = static_cast<int>(std::floor((foot.off_m + kLengthTolerance_m) / width_m_ - 0.5));
       k >= 0 && (k + 0.5) * width_m_ >= least_m; --k)
    out.push_back(foot.on_right ? k : -1 - k);
  return out;
}

PlanLines::PlanLines(const Plan& plan) : lines_(1), by_subfield_(plan.subfields.size(), 0) {
  std::vector<bool> curved(plan.subfields.size(), false);
  for (const TrackPiece& piece : plan.pieces)
    if (!piece.curve.empty() && piece.subfield < plan.subfields.size()) curved[piece.subfield] = true;
  for (std::size_t i = 0; i < plan.subfields.size(); ++i) {
    if (!curved[i]) continue;
    const Path& reference = plan.subfields[i].reference;
    for (std::size_t before = 0; before < i && by_subfield_[i] == 0; ++before)
      if (curved[before] && plan.subfields[before].reference == reference)
        by_subfield_[i] = by_subfield_[before];
    if (by_subfield_[i] != 0) continue;
    by_subfield_[i] = lines_.size();
    lines_.emplace_back(reference, plan.machine);
  }
}

const TrackLines& PlanLines::of(std::size_t subfield) const {
  return lines_[subfield < by_subfield_.size() ? by_subfield_[subfield] : 0];
}

std::optional<TrackLine> PlanLines::along(const TrackPiece& piece) const {
  if (piece.curve.empty()) {
    const Point way = piece.end - piece.start;
    return TrackLine(StraightLine(piece.start, (1 / length(way)) * way));
  }
  const TrackLines& lines = of(piece.subfield);
  return lines.known() ? std::optional(TrackLine(lines.line(piece.track))) : std::nullopt;
}

bool holds(const Path& path, Point p) {
  return std::any_of(path.begin(), path.end(), [p](const PathSegment& segment) {
    return distance_to_edge(segment, p, p) <= kLengthTolerance_m;
  });
}

}  // namespace tramline::check
