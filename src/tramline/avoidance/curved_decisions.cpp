#include "tramline/avoidance/curved_decisions.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tramline/avoidance/decision_rounds.h"
#include "tramline/geometry/path_between.h"

namespace tramline {
namespace {

/// What begins or ends at the seam of a closed track does so up to this, m.
constexpr double kAtSeam = 1e-3;

/// What driving pieces of a curved track costs.
class CurvedCosts : public PieceCosts {
 public:
  CurvedCosts(const BlockedTrack& blocked, const Track& track, const Objective& objective, double width_m,
              double least_m)
      : blocked_(blocked), track_(track), objective_(objective), width_m_(width_m), least_m_(least_m) {}

  StretchCost of(const JoinedStretch& joined) const override {
    LaidTracks laid;
    append_joined(track_, joined, least_m_, laid);
    StretchCost out;
    for (const LaidPiece& piece : laid.pieces) out.sum += of_piece(piece);
    out.driven = !laid.pieces.empty();
    // It goes on behind the seam: one piece with what ends there.
    if (track_.closed && out.driven && joined.whole.from <= kAtSeam &&
        joined.whole.to < track_.length_m - kAtSeam)
      out.sum -= objective_.turn;
    return out;
  }

  double of_option(const TrackOption& option) const override {
    const double longer = option.way.detour.length_m - kept_length(option.straight);
    return objective_.overlap * width_m_ * longer -
           (objective_.overlap + objective_.uncovered) * option.gain_m2();
  }

  double counted_too_often() const override { return blocked_.only_one_driven ? objective_.turn : 0; }

 private:
  double of_piece(const LaidPiece& piece) const {
    double useful = piece.inside_m2;
    for (const TrackDetour& detour : piece.detours) useful += useful_of(detour);
    const int stops = (piece.stop_at_from ? 1 : 0) + (piece.stop_at_to ? 1 : 0);
    return objective_.overlap * (width_m_ * piece.length_m - useful) - objective_.uncovered * useful +
           objective_.turn * (piece.after_crossing ? 0 : 1) + objective_.stop * stops;
  }

  double useful_of(const TrackDetour& detour) const {
    for (const TrackOption& option : blocked_.options)
      if (option.way.detour.path == detour.path) return option.gain_m2() + option.profile_m2;
    return 0;
  }

  double kept_length(const Interval& range) const {
    double sum = 0;
    for (const Interval& part : common(track_.stretches, {range})) sum += part.length();
    return sum;
  }

  const BlockedTrack& blocked_;
  const Track& track_;
  const Objective& objective_;
  double width_m_;
  double least_m_;
};

constexpr std::size_t kNoPart = static_cast<std::size_t>(-1);

std::size_t part_with(const Region& ground, Point p) {
  for (std::size_t i = 0; i < ground.size(); ++i)
    if (contains(ground[i], p)) return i;
  return kNoPart;
}

/// A piece belongs to one part of the ground.
bool leads_to_another_part(const Region& ground, const TrackDetour& detour) {
  const std::size_t first = part_with(ground, detour.path.front().from);
  const std::size_t last = part_with(ground, detour.path.back().to);
  return first != last && first != kNoPart && last != kNoPart;
}

Box reach_between(const Track& track, const Interval& range, double width_m) {
  return reach_of(path_between(track.path, range.from, range.to), width_m);
}

}  // namespace

CurvedDecisions::CurvedDecisions(const CurvedAvoidanceTask& task)
    : task_(task),
      width_m_(task.machine.width_m),
      least_m_(min_length_m(task.machine)),
      around_(turned_surroundings(task.ground, task.field.outer, task.settings.boundary == EdgeKind::kHard,
                                  task.family.grid.frame)),
      body_(rings_of(task.ground.body)),
      cover_(task.family.tracks.size()),
      driven_(task.family.tracks.size(), false) {
  for (std::size_t i = 0; i < task.family.tracks.size(); ++i) {
    work(i, {});
    BlockedTrack blocked;
    blocked.strip = i;
    blocked.gaps = hard_gaps(task.family.tracks[i]);
    if (blocked.gaps.empty()) continue;
    add_options(blocked);
    decisions_.push_back({std::move(blocked), {}});
  }
}

void CurvedDecisions::add_options(BlockedTrack& blocked) {
  if (task_.settings.avoid != Avoidance::kCheapest) {
    const char* why = task_.settings.avoid == Avoidance::kPaper
                          ? "S1 passes obstacles on straight tracks only"
                          : "all tracks were to be cut";
    for (const std::size_t gap : blocked.gaps)
      for (const Passing side : {Passing::kLeft, Passing::kRight})
        blocked.refused.push_back({gap, side, why});
    return;
  }
  const Track& track = task_.family.tracks[blocked.strip];
  for (const Passing side : {Passing::kLeft, Passing::kRight}) {
    std::vector<WayRound> alone;
    for (const std::size_t gap : blocked.gaps) {
      WayRound way = way_past_gaps(track, gap, gap, side);
      if (way.possible())
        alone.push_back(way);
      else
        blocked.refused.push_back({gap, side, way.why_not});
      add_option(blocked, std::move(way));
    }
    for (const GapRow& row : rows_to_join(alone))
      add_option(blocked, way_past_gaps(track, row.first, row.last, side));
  }
  std::stable_sort(
      blocked.options.begin(), blocked.options.end(),
      [](const TrackOption& a, const TrackOption& b) { return a.way.first_gap < b.way.first_gap; });
}

WayRound CurvedDecisions::way_past_gaps(const Track& track, std::size_t first, std::size_t last,
                                        Passing side) const {
  WayRound way = way_round({task_.family.grid, track, first, task_.machine.radius_m, last}, side, around_);
  if (way.possible() && leads_to_another_part(task_.ground.plannable, way.detour))
    way.why_not = "it would lead to another part of the ground";
  return way;
}

void CurvedDecisions::add_option(BlockedTrack& blocked, WayRound way) {
  if (!way.possible() || has_option(blocked, way)) return;
  const Track& track = task_.family.tracks[blocked.strip];
  TrackOption option;
  option.straight = {way.detour.from, way.detour.to};
  way.detour.obstacles = obstacles_near(track, option.straight);
  option.reaches = reaches_of(way.detour.path, width_m_);
  option.reach = reach_of(way.detour.path, width_m_);
  option.reach.extend(reach_between(track, option.straight, width_m_));
  option.way = std::move(way);
  blocked.options.push_back(std::move(option));
}

/// Those in the way of the track itself, seen from the field: nearer to it than its swath and the clearance.
std::vector<int> CurvedDecisions::obstacles_near(const Track& track, Interval range) const {
  const Path line = path_between(track.path, range.from, range.to);
  const SwathLine reaching(line, width_m_ + 2 * task_.settings.clearance_m);
  std::vector<int> out;
  for (std::size_t i = 0; i < task_.field.obstacles.size(); ++i) {
    const Obstacle& obstacle = task_.field.obstacles[i];
    if (obstacle.kind != ObstacleKind::kObstacle) continue;
    if (runs_into(reaching, {obstacle.shape.outer, bounds(obstacle.shape), {}}))
      out.push_back(static_cast<int>(i));
  }
  return out;
}

void CurvedDecisions::work(std::size_t track, const std::vector<TrackDetour>& detours) {
  LaidTracks laid;
  append_pieces(task_.family.tracks[track], detours, least_m_, laid);
  std::vector<Path> kept;
  std::vector<TrackDetour> driven;
  for (const LaidPiece& piece : laid.pieces) {
    for (const Interval& part : parts_on_track(piece))
      kept.push_back(path_along(task_.family.tracks[track], part.from, part.to));
    driven.insert(driven.end(), piece.detours.begin(), piece.detours.end());
  }
  cover_.set(track, kept, driven, width_m_);
  if (driven_[track] == !laid.pieces.empty()) return;
  driven_[track] = !laid.pieces.empty();
  for (Decision& decision : decisions_) decision.track.stale = true;
}

void CurvedDecisions::choose(Decision& decision, std::vector<TrackDetour> detours) {
  if (same_detours(decision.chosen, detours)) return;
  const Track& track = track_of(decision);
  for (const std::vector<TrackDetour>* some : {&std::as_const(decision.chosen), &std::as_const(detours)})
    for (const TrackDetour& detour : *some) {
      Box changed = reach_of(detour.path, width_m_);
      changed.extend(reach_between(track, {detour.from, detour.to}, width_m_));
      for (const Interval& stretch : track.stretches)
        if (stretch.length() < least_m_ && stretch.to >= detour.from && stretch.from <= detour.to)
          changed.extend(reach_between(track, stretch, width_m_));
      for (Decision& other : decisions_)
        if (&other != &decision)
          for (TrackOption& option : other.track.options)
            if (intersects(option.reach, changed)) option.stale = other.track.stale = true;
    }
  decision.chosen = std::move(detours);
  work(decision.track.strip, decision.chosen);
}

/// What the track covers alone where it keeps to its line.
double CurvedDecisions::kept_alone(const Decision& decision, const Interval& range) const {
  const Track& track = track_of(decision);
  double sum = 0;
  for (const Interval& part : common(track.stretches, {range})) {
    const Path path = path_between(track.path, part.from, part.to);
    if (path.empty()) continue;
    const bool alone = !cover_.detours_near(reach_of(path, width_m_), decision.track.strip);
    sum += alone ? inside_between(track, part.from, part.to)
                 : new_area_of(path, width_m_, body_, cover_, decision.track.strip);
  }
  return sum;
}

void CurvedDecisions::value(Decision& decision) {
  BlockedTrack& blocked = decision.track;
  const auto others = std::count(driven_.begin(), driven_.end(), true) - (driven_[blocked.strip] ? 1 : 0);
  blocked.only_one_driven = others == 0;
  const Track& track = track_of(decision);
  for (TrackOption& option : blocked.options) {
    if (!option.stale) continue;
    option.useful_m2 = new_area_of(option.way.detour.path, width_m_, body_, cover_, blocked.strip);
    option.replaced_m2 = kept_alone(decision, option.straight);
    option.profile_m2 = 0;
    for (const Interval& part : common(track.stretches, {option.straight}))
      option.profile_m2 += inside_between(track, part.from, part.to);
    option.stale = false;
  }
  blocked.stale = false;
}

double CurvedDecisions::saving_of(Decision& decision, std::vector<TrackDetour>* best_detours) {
  value(decision);
  const Track& track = track_of(decision);
  const CurvedCosts costs(decision.track, track, task_.objective, width_m_, least_m_);
  const auto best = cheapest_choice(decision.track, track.stretches, costs);
  if (!best || same_detours(best->detours, decision.chosen)) return 0;
  if (best_detours != nullptr) *best_detours = best->detours;
  return track_cost(track.stretches, costs, decision.chosen) - best->cost;
}

bool CurvedDecisions::improve() {
  const auto saving = [this](Decision& decision, std::vector<TrackDetour>* best) {
    return saving_of(decision, best);
  };
  const auto chosen = [this](Decision& decision, std::vector<TrackDetour> detours) {
    choose(decision, std::move(detours));
  };
  return improve_one_by_one(by_saving(decisions_, saving), saving, chosen);
}

void CurvedDecisions::take(const std::vector<std::vector<TrackDetour>>& detours) {
  for (Decision& decision : decisions_) choose(decision, detours[decision.track.strip]);
}

std::vector<std::vector<TrackDetour>> CurvedDecisions::detours() const {
  std::vector<std::vector<TrackDetour>> out(task_.family.tracks.size());
  for (const Decision& decision : decisions_) out[decision.track.strip] = decision.chosen;
  return out;
}

std::vector<CurvedEncounter> CurvedDecisions::encounters() {
  std::vector<CurvedEncounter> out;
  for (Decision& decision : decisions_) {
    value(decision);
    for (const std::size_t gap : decision.track.gaps) out.push_back(encounter_at(decision, gap));
  }
  return out;
}

CurvedEncounter CurvedDecisions::encounter_at(Decision& decision, std::size_t gap) {
  const Track& track = track_of(decision);
  CurvedEncounter out;
  out.branch = track.branch;
  out.between = {track.stretches[gap - 1].to, track.stretches[gap].from};
  const double middle = 0.5 * (out.between.from + out.between.to);
  Encounter& encounter = out.encounter;
  encounter.track = track.index;
  encounter.at = path_between(track.path, 0, middle).back().to;
  encounter.obstacles = obstacles_near(track, out.between);
  for (const TrackDetour& detour : decision.chosen)
    if (detour.from <= middle && detour.to >= middle) encounter.chosen = detour.side;
  const CurvedCosts costs(decision.track, track, task_.objective, width_m_, least_m_);
  const auto choice = [&](Passing side) {
    return cheapest_choice(decision.track, track.stretches, costs, Forced{gap, side});
  };
  const double cost_of_cut = choice(Passing::kCut)->cost;
  const auto past = [&](Passing side) {
    return way_past(decision.track, {gap, side}, choice(side), cost_of_cut,
                    "detours beside it are in the way");
  };
  encounter.left = past(Passing::kLeft);
  encounter.right = past(Passing::kRight);
  return out;
}

}  // namespace tramline
