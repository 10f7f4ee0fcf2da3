#include "tramline/planner/curved_plan.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "tramline/cost/curved_tally.h"
#include "tramline/cost/gain_by_detours.h"
#include "tramline/cost/kinked_overlap.h"
#include "tramline/cost/recursive_tally.h"
#include "tramline/cost/worked_bands.h"
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

/// The numbers of the tracks that may reach the ground.
TrackRange range_of(const SearchTask& task, const CurvedCandidate& candidate) {
  const Box reach = bounds(task.ground.plannable);
  const double width_m = task.machine.width_m;
  return candidate.round ? tracks_inside(reach, width_m) : tracks_over(candidate.reference, reach, width_m);
}

EndCriterion criterion_of(const SearchTask& task) {
  return end_criterion(task.settings.end_rule, task.objective, task.machine.width_m);
}

/// Of a candidate's reference.
std::vector<CurvedTrack> tracks_of(const SearchTask& task, const CurvedGround& ground,
                                   const CurvedCandidate& candidate) {
  const TrackRange range = range_of(task, candidate);
  return curved_tracks(parallel_family(candidate.reference, range.first, range.last, limits_of(task.machine)),
                       task.machine.width_m, ground, criterion_of(task));
}

CurvedAvoidanceTask avoidance_task(const SearchTask& task, const std::vector<CurvedTrack>& tracks) {
  return {task.field, task.ground, task.machine, task.objective, task.settings, tracks, task.body_m2};
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
      stops_ += (piece.stop_at_from ? 1 : 0) + (piece.stop_at_to ? 1 : 0);
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

/// The pieces of a family without detours, laid track by track outwards from the reference; nullopt as soon
/// as it is certain to cost more than `no_more_than`.
std::optional<CurvedTracks> laid_plainly(const SearchTask& task, const CurvedGround& ground,
                                         const CurvedCandidate& candidate, double no_more_than) {
  const TrackRange range = range_of(task, candidate);
  FamilyBound bound(task, candidate.reference, range);
  CurvedTracks out;
  bool hopeful = true;
  const auto lay = [&](int index, std::vector<ParallelTrack> tracks) {
    std::vector<FamilyTrack> family;
    for (ParallelTrack& track : tracks) family.push_back({index, std::move(track)});
    CurvedTracks more =
        curved_pieces(family, task.machine.width_m, ground, criterion_of(task), min_length_m(task.machine));
    std::move(more.pieces.begin(), more.pieces.end(), std::back_inserter(out.pieces));
    std::move(more.dropped.begin(), more.dropped.end(), std::back_inserter(out.dropped));
    hopeful = bound.after(index, out) <= no_more_than;
    return hopeful;
  };
  visit_family(candidate.reference, range.first, range.last, limits_of(task.machine), lay);
  if (!hopeful) return std::nullopt;
  for (std::vector<CurvedPiece>* pieces : {&out.pieces, &out.dropped})
    std::stable_sort(pieces->begin(), pieces->end(),
                     [](const CurvedPiece& a, const CurvedPiece& b) { return a.track < b.track; });
  return out;
}

/// The part of the ground a piece lies in.
int subfield_of(const Region& parts, const CurvedPiece& piece, double width_m) {
  if (parts.size() == 1) return 0;
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

/// How pieces are written down.
struct Writing {
  double width_m = 0;
  bool curved = true;  ///< with their path, even where it is straight
};

TrackPiece forwards(const CurvedPiece& piece, int subfield, const Writing& writing) {
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
  if (writing.curved) out.curve = piece.path;
  // Where they keep to their tracks swaths of one family have no ground in common; add_overlaps() looks at
  // the rest.
  out.overlap_m2 = writing.width_m * piece.length_m - piece.inside_m2;
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
Driven up_and_down(const CurvedTracks& tracks, const Region& parts, const Writing& writing) {
  Driven out{{},
             subfields_of(parts, tracks.pieces, writing.width_m),
             std::vector<bool>(tracks.pieces.size(), false)};
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
      track.push_back(forwards(tracks.pieces[i], part, writing));
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

/// What the tracks work, and what the detours do. No part folds over itself.
std::vector<Region> worked_grounds(const Plan& plan) {
  const double width_m = plan.machine.width_m;
  std::vector<TrackPiece> on_track;
  Region by_detours;
  for (const TrackPiece& piece : plan.pieces) {
    for (Path& part : parts_on_track(piece)) {
      TrackPiece alone{part.front().from, part.back().to};
      alone.track = piece.track;
      alone.curve = std::move(part);
      on_track.push_back(std::move(alone));
    }
    for (const Detour& detour : piece.detours) append_swath(detour.path, width_m, by_detours);
  }
  std::vector<Region> out = worked_bands(plan.reference, on_track, width_m, kLayerSagitta);
  if (!by_detours.empty()) out.push_back(unite(by_detours));
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

/// Settles by how much each swath overlaps.
void add_overlaps(Plan& plan) {
  const double width_m = plan.machine.width_m;
  if (plan.settings.tracks == TrackConstruction::kPaper) {
    const std::vector<double> overlaps = overlap_by_kinked_piece(plan.body, plan.pieces, width_m);
    for (std::size_t i = 0; i < overlaps.size(); ++i) plan.pieces[i].overlap_m2 = overlaps[i];
    return;
  }
  const std::vector<double> gains = gain_by_detours_m2(plan.body, plan.pieces, width_m);
  for (std::size_t i = 0; i < gains.size(); ++i)
    plan.pieces[i].overlap_m2 = std::max(0.0, *plan.pieces[i].overlap_m2 - gains[i]);
}

/// The layers of overlap and uncovered land, without slivers.
void add_layers(Plan& plan) {
  const EdgeIndex body(plan.body);
  plan.uncovered = plan.body;
  for (const Region& ground : worked_grounds(plan)) {
    plan.uncovered = difference(plan.uncovered, ground);
    for (Polygon& part : difference(reaching_out(ground, body), plan.body))
      plan.overlap.push_back(std::move(part));
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

CurvedGround curved_ground(const SearchTask& task) {
  const HardLand hard = hard_land(task);
  return {EdgeIndex(task.ground.plannable), EdgeIndex(hard.before_tracks), EdgeIndex(fence(task)),
          EdgeIndex(task.ground.passable), EdgeIndex(hard.elsewhere)};
}

bool asks_for_detours(const SearchTask& task) {
  return !task.ground.hard.empty() || !task.ground.passable.empty();
}

CurvedCandidate curved_along(const SearchTask& task, const Reference& reference, double right_m) {
  return curved_along(task, curved_ground(task), reference, right_m, std::numeric_limits<double>::infinity());
}

CurvedCandidate curved_along(const SearchTask& task, const CurvedGround& ground, const Reference& reference,
                             double right_m, double no_more_than) {
  CurvedCandidate out;
  out.line = reference.line;
  const std::optional<Path> line = shifted(reference.path, right_m, limits_of(task.machine).least_radius_m());
  if (!line) return out;
  const Box reach = bounds(task.ground.plannable).grown(task.machine.width_m);
  out.reference = reference.round ? *line : extended(*line, reach).path;
  out.round = reference.round;
  if (asks_for_detours(task)) {
    const std::vector<CurvedTrack> tracks = tracks_of(task, ground, out);
    CurvedAvoided cut = all_cut(avoidance_task(task, tracks));
    out.tracks = std::move(cut.tracks);
    out.tally = cut.tally;
    out.cost = cut.cost;
  } else if (std::optional<CurvedTracks> tracks = laid_plainly(task, ground, out, no_more_than)) {
    out.tracks = std::move(*tracks);
    out.tally = curved_tally(out.tracks, task.machine.width_m, task.body_m2);
    out.cost = cost(task.objective, out.tally);
  }
  return out;
}

CurvedCandidate with_detours(const SearchTask& task, CurvedCandidate candidate) {
  if (candidate.tally.pieces == 0 || !asks_for_detours(task)) return candidate;
  const std::vector<CurvedTrack> tracks = tracks_of(task, curved_ground(task), candidate);
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
  const bool paper = task.settings.tracks == TrackConstruction::kPaper;
  const Writing writing{task.machine.width_m, curved || !paper};
  Driven driven = up_and_down(candidate.tracks, task.ground.plannable, writing);
  plan.encounters = encounters_as_driven(task, candidate, driven);
  plan.pieces = std::move(driven.pieces);
  add_overlaps(plan);
  for (const CurvedPiece& piece : candidate.tracks.dropped)
    plan.dropped.push_back({piece.path.front().from, piece.path.back().to,
                            subfield_of(task.ground.plannable, piece, task.machine.width_m)});
  plan.tally = candidate.tally;
  plan.cost = candidate.cost;
  plan.directions_tried = 1;
  if (paper)
    add_layers_of_kinked(plan, candidate);
  else
    add_layers(plan);
  plan.warnings = warnings_about(plan);
  return plan;
}

}  // namespace tramline
