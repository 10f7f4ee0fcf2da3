#include "tramline/planner/curved_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tramline/cost/curved_tally.h"
#include "tramline/cost/worked_bands.h"
#include "tramline/geometry/boolean.h"
#include "tramline/geometry/extended.h"
#include "tramline/geometry/shifted.h"
#include "tramline/geometry/smoothed.h"
#include "tramline/planner/finished_plan.h"
#include "tramline/planner/reference_chains.h"
#include "tramline/planner/warnings.h"

namespace tramline {
namespace {

TrackLimits limits_of(const Machine& machine) {
  TrackLimits limits;
  limits.radius_m = machine.radius_m;
  limits.width_m = machine.width_m;
  return limits;
}

/// What no swath enters: passable obstacles, too, since the work is interrupted there.
Region kept_off(const SearchTask& task) {
  Region out = task.ground.hard;
  for (const Region* more : {&task.ground.passable, &task.ground.beyond})
    if (!more->empty()) out = unite(out, *more);
  return out;
}

/// Without a headland before it a hard boundary is where swaths end.
Region fence(const SearchTask& task) {
  const bool hard = task.settings.boundary == EdgeKind::kHard;
  return hard ? Region{{task.field.outer, {}}} : Region{};
}

Region workable(const SearchTask& task) {
  return task.ground.passable.empty() ? task.ground.plannable
                                      : difference(task.ground.plannable, task.ground.passable);
}

/// Is there land that swaths end before, but not as at an obstacle?
bool has_ends_without_stop(const SearchTask& task) {
  return !task.ground.passable.empty() || !task.ground.beyond.empty();
}

/// Does anything of the region lie within the first millimetres beyond the end of a swath?
bool lies_ahead(const Region& region, Point end, Point heading, double width_m) {
  constexpr double kAhead = 2e-3;
  const Ring ahead = band(straight_path(end, end + kAhead * heading), width_m);
  return area(intersection(region, {{ahead, {}}})) > 0.5 * kAhead * kWidthTolerance;
}

/// Before passable land work is interrupted, and before land given up in a headland it ends with the body:
/// neither is a stop.
void keep_stops_at(const Region& hard, double width_m, CurvedTracks& tracks) {
  for (CurvedPiece& piece : tracks.pieces) {
    const PathSegment &first = piece.path.front(), &last = piece.path.back();
    if (piece.stop_at_from)
      piece.stop_at_from = lies_ahead(hard, first.from, -1 * direction_at_start(first), width_m);
    if (piece.stop_at_to) piece.stop_at_to = lies_ahead(hard, last.to, direction_at_end(last), width_m);
  }
}

/// Of a reference that goes round the ground, anticlockwise as outer rings do.
TrackRange tracks_inside(const Box& reach, double width_m) {
  const double across = std::hypot(reach.width(), reach.height());
  return {-static_cast<int>(std::ceil(0.5 * across / width_m)) - 1, 0};
}

/// What a family costs at least, while its tracks are laid one after another.
class FamilyBound {
 public:
  FamilyBound(const SearchTask& task, const Path& reference, const TrackRange& range)
      : task_(task), reference_(reference), range_(range) {}

  /// With the tracks up to this number, in the order of visit_family().
  double after(int index, const CurvedTracks& tracks) {
    for (; seen_ < tracks.pieces.size(); ++seen_) {
      const CurvedPiece& piece = tracks.pieces[seen_];
      inside_m2_ += piece.inside_m2;
      overlap_m2_ += task_.machine.width_m * piece.length_m - piece.inside_m2;
      // Which ends are stops after all is told later.
      if (!has_ends_without_stop(task_)) stops_ += (piece.stop_at_from ? 1 : 0) + (piece.stop_at_to ? 1 : 0);
    }
    const Objective& price = task_.objective;
    const double sure =
        price.overlap * overlap_m2_ + price.stop * stops_ + price.turn * (static_cast<double>(seen_) - 1);
    return (sure + least_for_the_rest(index)) * (1 - kRounding) - kRounding;
  }

 private:
  static constexpr double kRounding = 1e-9;
  /// By how much discs rolled round corners might lengthen a track, and more than that.
  static constexpr double kLonger = 1.5;

  /// All of the body that is not worked yet is left, or worked by tracks that take a turn each.
  double least_for_the_rest(int index) const {
    const double width_m = task_.machine.width_m;
    double longest_m = 0;
    const auto look = [&](int k) {
      longest_m = std::max(longest_m, uncut_length(reference_, (k + 0.5) * width_m));
    };
    // A sum of convex functions of the distance is greatest at one end.
    if (index < 0) {
      look(index);
      look(range_.first);
    }
    look(std::max(index, 0));
    look(range_.last);
    const Objective& price = task_.objective;
    const double rate = std::min(price.uncovered, price.turn / (width_m * kLonger * longest_m));
    return rate * std::max(0.0, task_.body_m2 - inside_m2_);
  }

  const SearchTask& task_;
  const Path& reference_;
  TrackRange range_;
  std::size_t seen_ = 0;
  double inside_m2_ = 0, overlap_m2_ = 0;
  int stops_ = 0;
};

/// The part of the ground a piece lies in.
int subfield_of(const Region& parts, const CurvedPiece& piece, double width_m) {
  if (parts.size() == 1) return 0;
  const Path half = path_between(piece.path, 0, 0.5 * piece.length_m);
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (contains(parts[i], half.back().to)) return static_cast<int>(i);
  // Along an edge most of the swath may lie outside, its middle with it.
  int best = 0;
  double most_m2 = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const PathProfile inside = path_profile(EdgeIndex({parts[i]}), piece.path, width_m);
    const double inside_m2 = area_between(inside, 0, inside.length());
    if (inside_m2 <= most_m2) continue;
    most_m2 = inside_m2;
    best = static_cast<int>(i);
  }
  return best;
}

/// Swaths of one family have no ground in common: what they overlap is what lies outside the body.
TrackPiece forwards(const CurvedPiece& piece, int subfield, double width_m) {
  TrackPiece out;
  out.start = piece.path.front().from;
  out.end = piece.path.back().to;
  out.subfield = subfield;
  out.track = piece.track;
  out.stop_at_start = piece.stop_at_from;
  out.stop_at_end = piece.stop_at_to;
  out.curve = piece.path;
  out.overlap_m2 = std::max(0.0, width_m * piece.length_m - piece.inside_m2);
  return out;
}

TrackPiece backwards(TrackPiece piece) {
  std::swap(piece.start, piece.end);
  std::swap(piece.stop_at_start, piece.stop_at_end);
  piece.curve = reversed(piece.curve);
  return piece;
}

/// Track by track, each the other way; each part of the ground by itself.
std::vector<TrackPiece> up_and_down(const CurvedTracks& tracks, const Region& parts, double width_m) {
  std::vector<int> subfields;
  for (const CurvedPiece& piece : tracks.pieces) subfields.push_back(subfield_of(parts, piece, width_m));
  std::vector<TrackPiece> out;
  for (int part = 0; part < static_cast<int>(parts.size()); ++part) {
    std::vector<TrackPiece> track;
    bool back = false;
    const auto drive = [&] {
      if (back) std::reverse(track.begin(), track.end());
      for (TrackPiece& piece : track) out.push_back(back ? backwards(std::move(piece)) : std::move(piece));
      if (!track.empty()) back = !back;
      track.clear();
    };
    for (std::size_t i = 0; i < subfields.size(); ++i) {
      if (subfields[i] != part) continue;
      if (!track.empty() && track.back().track != tracks.pieces[i].track) drive();
      track.push_back(forwards(tracks.pieces[i], part, width_m));
    }
    drive();
  }
  return out;
}

/// Those that lie not wholly inside the body.
Region reaching_out(const Region& parts, const EdgeIndex& body) {
  Region out;
  for (const Polygon& part : parts) {
    bool meets = !body.contains(part.outer.front());
    body.grid().each_meeting(bounds(part), [&meets](std::size_t) { meets = true; });
    if (meets) out.push_back(part);
  }
  return out;
}

/// The layers of overlap and uncovered land, without the slivers between chords where they stand for one
/// arc in two polygons.
void add_layers(Plan& plan) {
  const EdgeIndex body(plan.body);
  plan.uncovered = plan.body;
  for (const Region& ground :
       worked_bands(plan.reference, plan.pieces, plan.machine.width_m, kLayerSagitta)) {
    plan.uncovered = difference(plan.uncovered, ground);
    for (Polygon& part : difference(reaching_out(ground, body), plan.body))
      plan.overlap.push_back(std::move(part));
  }
  std::erase_if(plan.uncovered,
                [](const Polygon& part) { return area(part) < 0.5 * kLayerSagitta * perimeter(part.outer); });
  plan.overlap = unite(plan.overlap);
}

}  // namespace

Reference reference_along(const SearchTask& task, const std::vector<Point>& line, double tolerance_m) {
  Smoothed smooth = smoothed(line, limits_of(task.machine).least_radius_m(), tolerance_m);
  return {std::move(smooth.path), smooth.deviation_m, distance(line.front(), line.back()) <= 2 * kSeam_m};
}

CurvedGround curved_ground(const SearchTask& task) {
  return {EdgeIndex(workable(task)), EdgeIndex(kept_off(task)), EdgeIndex(fence(task))};
}

CurvedCandidate curved_along(const SearchTask& task, const Reference& reference, double right_m) {
  return curved_along(task, curved_ground(task), reference, right_m, std::numeric_limits<double>::infinity());
}

CurvedCandidate curved_along(const SearchTask& task, const CurvedGround& ground, const Reference& reference,
                             double right_m, double no_more_than) {
  const TrackLimits limits = limits_of(task.machine);
  const double width_m = task.machine.width_m;
  CurvedCandidate out;
  const std::optional<Path> line = shifted(reference.path, right_m, limits.least_radius_m());
  if (!line) return out;
  const Box reach = bounds(task.ground.plannable);
  out.reference = reference.round ? *line : extended(*line, reach.grown(width_m)).path;
  const TrackRange range =
      reference.round ? tracks_inside(reach, width_m) : tracks_over(out.reference, reach, width_m);
  const EndCriterion criterion = end_criterion(task.settings.end_rule, task.objective, width_m);
  FamilyBound bound(task, out.reference, range);
  bool hopeful = true;
  visit_family(out.reference, range.first, range.last, limits, [&](int index, auto tracks) {
    append_curved_pieces(index, std::move(tracks), width_m, ground, criterion, min_length_m(task.machine),
                         out.tracks);
    hopeful = bound.after(index, out.tracks) <= no_more_than;
    return hopeful;
  });
  if (!hopeful) {
    out.tracks = {};
    return out;
  }
  for (std::vector<CurvedPiece>* pieces : {&out.tracks.pieces, &out.tracks.dropped})
    std::stable_sort(pieces->begin(), pieces->end(),
                     [](const CurvedPiece& a, const CurvedPiece& b) { return a.track < b.track; });
  if (has_ends_without_stop(task)) keep_stops_at(task.ground.hard, width_m, out.tracks);
  out.tally = curved_tally(out.tracks, width_m, task.body_m2);
  out.cost = cost(task.objective, out.tally);
  return out;
}

Plan finished_plan(const SearchTask& task, const CurvedCandidate& candidate) {
  require_tracks(task, candidate.tally);
  Plan plan = bare_plan(task);
  const Path& line = candidate.reference;
  const Point half_way = path_between(line, 0, 0.5 * length(line)).back().to;
  const Direction whole = Direction::along(line.front().from, half_way);
  for (const Polygon& part : task.ground.plannable) plan.subfields.push_back({part, whole});
  plan.reference = candidate.reference;
  plan.pieces = up_and_down(candidate.tracks, task.ground.plannable, task.machine.width_m);
  for (const CurvedPiece& piece : candidate.tracks.dropped)
    plan.dropped.push_back({piece.path.front().from, piece.path.back().to,
                            subfield_of(task.ground.plannable, piece, task.machine.width_m)});
  plan.tally = candidate.tally;
  plan.cost = candidate.cost;
  plan.directions_tried = 1;
  add_layers(plan);
  plan.warnings = warnings_about(plan);
  return plan;
}

}  // namespace tramline
