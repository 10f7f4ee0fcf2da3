#include "tramline/planner/curved_plan.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "tramline/cost/recursive_tally.h"
#include "tramline/cost/worked_regions.h"
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

/// Without a headland before it a hard boundary is where swaths end.
Region fence(const SearchTask& task) {
  const bool hard = task.settings.boundary == EdgeKind::kHard;
  return hard ? Region{{task.field.outer, {}}} : Region{};
}

/// Of a reference that goes round the ground, anticlockwise as outer rings do.
TrackRange tracks_inside(const Box& reach, double width_m) {
  const double across = std::hypot(reach.width(), reach.height());
  return {-static_cast<int>(std::ceil(0.5 * across / width_m)) - 1, 0};
}

/// Land given up within the headland stops no track: there the machine turns.
struct HardLand {
  Region before_tracks;
  Region elsewhere;
};

HardLand hard_land(const SearchTask& task) {
  const Region& headland = task.headland.ground;
  HardLand out{task.ground.hard, task.ground.beyond};
  if (headland.empty() || out.before_tracks.empty()) return out;
  const Region in_headland = intersection(out.before_tracks, headland);
  if (in_headland.empty()) return out;
  out.before_tracks = difference(out.before_tracks, headland);
  out.elsewhere = unite(out.elsewhere, in_headland);
  return out;
}

/// Of a candidate's reference.
std::vector<CurvedTrack> tracks_of(const SearchTask& task, const CurvedCandidate& candidate) {
  const TrackLimits limits = limits_of(task.machine);
  const double width_m = task.machine.width_m;
  const Box reach = bounds(task.ground.plannable);
  const TrackRange range =
      candidate.round ? tracks_inside(reach, width_m) : tracks_over(candidate.reference, reach, width_m);
  const HardLand hard = hard_land(task);
  const CurvedGround ground{EdgeIndex(task.ground.plannable), EdgeIndex(hard.before_tracks),
                            EdgeIndex(fence(task)), EdgeIndex(task.ground.passable),
                            EdgeIndex(hard.elsewhere)};
  return curved_tracks(parallel_family(candidate.reference, range.first, range.last, limits), width_m, ground,
                       end_criterion(task.settings.end_rule, task.objective, width_m));
}

CurvedAvoidanceTask avoidance_task(const SearchTask& task, const std::vector<CurvedTrack>& tracks) {
  return {task.field, task.ground, task.machine, task.objective, task.settings, tracks, task.body_m2};
}

/// The part of the ground a piece lies in.
int subfield_of(const Region& parts, const CurvedPiece& piece, double width_m) {
  const Path half = path_between(piece.path, 0, 0.5 * piece.length_m);
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (contains(parts[i], half.back().to)) return static_cast<int>(i);
  // Along an edge most of the swath may lie outside, its middle with it.
  const Region swath = made_valid({band(piece.path, width_m, kLayerSagitta), {}});
  int best = 0;
  double most_m2 = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double inside_m2 = area(intersection(swath, {parts[i]}));
    if (inside_m2 <= most_m2) continue;
    most_m2 = inside_m2;
    best = static_cast<int>(i);
  }
  return best;
}

TrackPiece forwards(const CurvedPiece& piece, int subfield, bool curved) {
  TrackPiece out;
  out.start = piece.path.front().from;
  out.end = piece.path.back().to;
  out.subfield = subfield;
  out.track = piece.track;
  out.stop_at_start = piece.stop_at_from;
  out.stop_at_end = piece.stop_at_to;
  out.after_crossing = piece.after_crossing;
  for (const StripDetour& detour : piece.detours)
    out.detours.push_back({detour.path, detour.side, detour.obstacles});
  if (curved) out.curve = piece.path;
  return out;
}

/// Precondition: not a cut.
Passing other_side(Passing side) { return side == Passing::kLeft ? Passing::kRight : Passing::kLeft; }

TrackPiece backwards(TrackPiece piece) {
  std::swap(piece.start, piece.end);
  std::swap(piece.stop_at_start, piece.stop_at_end);
  piece.curve = reversed(piece.curve);
  std::reverse(piece.detours.begin(), piece.detours.end());
  for (Detour& detour : piece.detours) {
    detour.path = reversed(detour.path);
    detour.side = other_side(detour.side);
  }
  return piece;
}

/// The pieces of one track the other way round: what came after a crossing comes before it.
std::vector<TrackPiece> backwards(std::vector<TrackPiece> track) {
  std::reverse(track.begin(), track.end());
  for (std::size_t i = track.size(); i-- > 0;) {
    track[i] = backwards(std::move(track[i]));
    track[i].after_crossing = i > 0 && track[i - 1].after_crossing;
  }
  return track;
}

/// The part of the ground each piece lies in. What crossings join lies in one.
std::vector<int> subfields_of(const Region& parts, const std::vector<CurvedPiece>& pieces, double width_m) {
  std::vector<int> out;
  for (const CurvedPiece& piece : pieces)
    out.push_back(piece.after_crossing ? out.back() : subfield_of(parts, piece, width_m));
  return out;
}

/// The tracks as driven, and of every piece of them the part of the ground it lies in and whether it is
/// driven against the reference.
struct Driven {
  std::vector<TrackPiece> pieces;
  std::vector<int> subfields;
  std::vector<bool> back;
};

/// Track by track, each the other way; each part of the ground by itself.
Driven up_and_down(const CurvedTracks& tracks, const Region& parts, double width_m, bool curved) {
  Driven out{{}, subfields_of(parts, tracks.pieces, width_m), std::vector<bool>(tracks.pieces.size(), false)};
  for (int part = 0; part < static_cast<int>(parts.size()); ++part) {
    std::vector<TrackPiece> track;
    bool back = false;
    const auto drive = [&] {
      if (track.empty()) return;
      if (back) track = backwards(std::move(track));
      std::move(track.begin(), track.end(), std::back_inserter(out.pieces));
      back = !back;
      track.clear();
    };
    for (std::size_t i = 0; i < tracks.pieces.size(); ++i) {
      if (out.subfields[i] != part) continue;
      if (!track.empty() && track.back().track != tracks.pieces[i].track) drive();
      out.back[i] = back;
      track.push_back(forwards(tracks.pieces[i], part, curved));
    }
    drive();
  }
  return out;
}

/// How far the piece is from what blocks its track.
double off_by(const CurvedPiece& piece, const Interval& between) {
  return std::max({0.0, piece.from - between.to, between.from - piece.to});
}

/// In the words of the plan: sides are seen in driving direction, and the subfield is that of the piece of
/// the track that is next to the place.
std::vector<Encounter> encounters_as_driven(const SearchTask& task, const CurvedCandidate& candidate,
                                            const Driven& driven) {
  std::vector<Encounter> out;
  for (const CurvedEncounter& one : candidate.encounters) {
    Encounter encounter = one.encounter;
    double nearest = std::numeric_limits<double>::infinity();
    bool back = false;
    const auto look_at = [&](const CurvedPiece& piece, auto subfield, bool driven_back) {
      if (piece.track != encounter.track || piece.branch != one.branch) return;
      const double off = off_by(piece, one.between);
      if (off >= nearest) return;
      nearest = off;
      encounter.subfield = subfield();
      back = driven_back;
    };
    for (std::size_t i = 0; i < candidate.tracks.pieces.size(); ++i)
      look_at(
          candidate.tracks.pieces[i], [&] { return driven.subfields[i]; }, driven.back[i]);
    for (const CurvedPiece& piece : candidate.tracks.dropped)
      look_at(
          piece, [&] { return subfield_of(task.ground.plannable, piece, task.machine.width_m); }, back);
    if (back) {
      std::swap(encounter.left, encounter.right);
      if (encounter.chosen != Passing::kCut) encounter.chosen = other_side(encounter.chosen);
    }
    out.push_back(std::move(encounter));
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Encounter& a, const Encounter& b) { return a.subfield < b.subfield; });
  return out;
}

void append_swath(const Path& path, double width_m, Region& out) {
  Polygon swath{band(path, width_m, kLayerSagitta), {}};
  // Round arcs of half the width the inner edge shrinks to a point, and chords may fold there.
  if (!find_invalidity(swath))
    out.push_back(std::move(swath));
  else
    for (Polygon& part : made_valid(swath)) out.push_back(std::move(part));
}

/// The swaths of every other track, the rest, and the detours. No part of them folds over itself.
std::vector<Region> worked_grounds(const Plan& plan) {
  const double width_m = plan.machine.width_m;
  std::vector<Region> out(3);
  for (const TrackPiece& piece : plan.pieces) {
    for (const Path& part : parts_on_track(piece))
      append_swath(part, width_m, out[piece.track % 2 == 0 ? 0 : 1]);
    for (const Detour& detour : piece.detours) append_swath(detour.path, width_m, out[2]);
  }
  return out;
}

/// Slivers between the chords of swaths that share an arc.
bool is_sliver(const Polygon& part) { return area(part) < 0.5 * kLayerSagitta * perimeter(part.outer); }

/// The parts of a path whose swaths reach into a box.
std::vector<Path> runs_near(const Path& path, double width_m, const Box& window) {
  const std::vector<Box> reaches = reaches_of(path, width_m);
  std::vector<Path> out;
  bool goes_on = false;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool is_near = intersects(reaches[i], window);
    if (is_near && !goes_on) out.emplace_back();
    if (is_near) out.back().push_back(path[i]);
    goes_on = is_near;
  }
  return out;
}

void append_common(const Region& a, const Region& b, Region& out) {
  for (const Polygon& one : a)
    for (const Polygon& other : b) {
      if (!intersects(bounds(one), bounds(other))) continue;
      for (Polygon& both : intersection({one}, {other}))
        if (!is_sliver(both)) out.push_back(std::move(both));
    }
}

/// What detours work that other swaths do, too. Tracks are long, and a detour meets little of them.
Region doubled_by_detours(const Plan& plan) {
  const double width_m = plan.machine.width_m;
  Region out, before;
  for (const TrackPiece& with : plan.pieces)
    for (const Detour& detour : with.detours) {
      Region swath;
      append_swath(detour.path, width_m, swath);
      append_common(swath, before, out);
      const Box window = reach_of(detour.path, width_m);
      for (const TrackPiece& piece : plan.pieces)
        for (const Path& part : parts_on_track(piece))
          for (const Path& run : runs_near(part, width_m, window)) {
            Region other;
            append_swath(run, width_m, other);
            append_common(swath, other, out);
          }
      before.insert(before.end(), swath.begin(), swath.end());
    }
  return out;
}

/// The layers of overlap and uncovered land, without slivers.
void add_layers(Plan& plan) {
  plan.uncovered = plan.body;
  const std::vector<Region> grounds = worked_grounds(plan);
  for (const Region& swaths : grounds) {
    const Region ground = unite(swaths);
    plan.uncovered = difference(plan.uncovered, ground);
    for (Polygon& part : difference(ground, plan.body)) plan.overlap.push_back(std::move(part));
  }
  std::erase_if(plan.uncovered, is_sliver);
  for (Polygon& part : doubled_by_detours(plan)) plan.overlap.push_back(std::move(part));
  plan.overlap = unite(plan.overlap);
}

void add_layers_of_kinked(Plan& plan, const CurvedCandidate& candidate) {
  WorkedRegions found = worked_regions(
      plan.body, kinked_swaths(candidate.tracks.pieces, plan.machine.width_m), {candidate.worked});
  plan.overlap = std::move(found.overlap);
  plan.uncovered = std::move(found.uncovered);
}

}  // namespace

Reference reference_along(const SearchTask& task, const std::vector<Point>& line, double tolerance_m) {
  Smoothed smooth = smoothed(line, limits_of(task.machine).least_radius_m(), tolerance_m);
  return {line, std::move(smooth.path), smooth.deviation_m,
          distance(line.front(), line.back()) <= 2 * kSeam_m};
}

CurvedCandidate curved_along(const SearchTask& task, const Reference& reference, double right_m) {
  CurvedCandidate out;
  out.line = reference.line;
  const std::optional<Path> line = shifted(reference.path, right_m, limits_of(task.machine).least_radius_m());
  if (!line) return out;
  const Box reach = bounds(task.ground.plannable).grown(task.machine.width_m);
  out.reference = reference.round ? *line : extended(*line, reach).path;
  out.round = reference.round;
  const std::vector<CurvedTrack> tracks = tracks_of(task, out);
  CurvedAvoided cut = all_cut(avoidance_task(task, tracks));
  out.tracks = std::move(cut.tracks);
  out.tally = cut.tally;
  out.cost = cut.cost;
  return out;
}

CurvedCandidate with_detours(const SearchTask& task, CurvedCandidate candidate) {
  if (candidate.tally.pieces == 0) return candidate;
  const std::vector<CurvedTrack> tracks = tracks_of(task, candidate);
  const CurvedAvoidanceTask avoidance = avoidance_task(task, tracks);
  CurvedAvoided avoided = choose_detours(avoidance);
  candidate.encounters = encounters_in(avoidance, avoided);
  candidate.tracks = std::move(avoided.tracks);
  candidate.tally = avoided.tally;
  candidate.cost = avoided.cost;
  return candidate;
}

Plan finished_plan(const SearchTask& task, const CurvedCandidate& candidate) {
  require_tracks(task, candidate.tally);
  Plan plan = bare_plan(task);
  const Path& line = candidate.reference;
  const Point half_way = path_between(line, 0, 0.5 * length(line)).back().to;
  const Direction whole = Direction::along(line.front().from, half_way);
  for (const Polygon& part : task.ground.plannable) plan.subfields.push_back({part, whole});
  plan.reference = candidate.reference;
  const bool curved = line.size() > 1 || !line.front().straight();
  Driven driven = up_and_down(candidate.tracks, task.ground.plannable, task.machine.width_m,
                              curved || task.settings.tracks != TrackConstruction::kPaper);
  plan.encounters = encounters_as_driven(task, candidate, driven);
  plan.pieces = std::move(driven.pieces);
  for (const CurvedPiece& piece : candidate.tracks.dropped)
    plan.dropped.push_back({piece.path.front().from, piece.path.back().to,
                            subfield_of(task.ground.plannable, piece, task.machine.width_m)});
  plan.tally = candidate.tally;
  plan.cost = candidate.cost;
  plan.directions_tried = 1;
  if (task.settings.tracks == TrackConstruction::kPaper)
    add_layers_of_kinked(plan, candidate);
  else
    add_layers(plan);
  plan.warnings = warnings_about(plan);
  return plan;
}

}  // namespace tramline
