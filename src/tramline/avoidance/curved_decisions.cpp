#include "tramline/avoidance/curved_decisions.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace tramline {
namespace {

/// Smaller savings are rounding.
constexpr double kWorthIt = 1e-9;
/// What begins or ends at the seam of a closed track does so up to this, m.
constexpr double kAtSeam = 1e-3;

bool same_detours(const std::vector<StripDetour>& a, const std::vector<StripDetour>& b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(),
                    [](const StripDetour& x, const StripDetour& y) { return x.path == y.path; });
}

bool same_drive(const WayRound& a, const WayRound& b) {
  constexpr double kSame = 1e-9;
  return a.detour.side == b.detour.side && a.first_gap == b.first_gap && a.last_gap == b.last_gap &&
         std::abs(a.detour.from - b.detour.from) < kSame && std::abs(a.detour.to - b.detour.to) < kSame &&
         std::abs(a.detour.length_m - b.detour.length_m) < kSame;
}

/// What driving pieces of a curved track costs.
class CurvedCosts : public PieceCosts {
 public:
  CurvedCosts(const BlockedTrack& blocked, const CurvedTrack& track, const Objective& objective,
              double width_m, double least_m)
      : blocked_(blocked), track_(track), objective_(objective), width_m_(width_m), least_m_(least_m) {}

  StretchCost of(const JoinedStretch& joined) const override {
    CurvedTracks laid;
    append_joined(track_, joined, least_m_, laid);
    StretchCost out;
    for (const CurvedPiece& piece : laid.pieces) out.sum += of_piece(piece);
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
  double of_piece(const CurvedPiece& piece) const {
    double useful = piece.inside_m2;
    for (const StripDetour& detour : piece.detours) useful += useful_of(detour);
    const int stops = (piece.stop_at_from ? 1 : 0) + (piece.stop_at_to ? 1 : 0);
    return objective_.overlap * (width_m_ * piece.length_m - useful) - objective_.uncovered * useful +
           objective_.turn * (piece.after_crossing ? 0 : 1) + objective_.stop * stops;
  }

  double useful_of(const StripDetour& detour) const {
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
  const CurvedTrack& track_;
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
bool leads_to_another_part(const Region& ground, const StripDetour& detour) {
  const std::size_t first = part_with(ground, detour.path.front().from);
  const std::size_t last = part_with(ground, detour.path.back().to);
  return first != last && first != kNoPart && last != kNoPart;
}

Box reach_between(const CurvedTrack& track, const Interval& range, double width_m) {
  return reach_of(path_between(track.path, range.from, range.to), width_m);
}

}  // namespace

std::vector<std::size_t> hard_gaps(const CurvedTrack& track) {
  std::vector<std::size_t> out;
  for (std::size_t gap = 1; gap < track.stretches.size(); ++gap)
    if (!common(track.by_hard, {{track.stretches[gap - 1].to, track.stretches[gap].from}}).empty())
      out.push_back(gap);
  return out;
}

CurvedDecisions::CurvedDecisions(const CurvedAvoidanceTask& task)
    : task_(task),
      width_m_(task.machine.width_m),
      least_m_(min_length_m(task.machine)),
      around_(field_surroundings(task.ground, task.field.outer, task.settings.boundary == EdgeKind::kHard)),
      body_(rings_of(task.ground.body)),
      cover_(task.tracks.size()),
      driven_(task.tracks.size(), false) {
  for (std::size_t i = 0; i < task.tracks.size(); ++i) {
    work(i, {});
    BlockedTrack blocked;
    blocked.strip = i;
    blocked.gaps = hard_gaps(task.tracks[i]);
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
  const CurvedTrack& track = task_.tracks[blocked.strip];
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
    add_joint_options(blocked, alone);
  }
  std::stable_sort(
      blocked.options.begin(), blocked.options.end(),
      [](const TrackOption& a, const TrackOption& b) { return a.way.first_gap < b.way.first_gap; });
}

/// As for straight tracks: two detours that would run into each other, three, and the whole row.
void CurvedDecisions::add_joint_options(BlockedTrack& blocked, const std::vector<WayRound>& alone) {
  for (std::size_t i = 0; i < alone.size(); ++i) {
    std::size_t end = i;
    while (end + 1 < alone.size() && alone[end + 1].detour.from < alone[end].detour.to) ++end;
    for (const std::size_t last : std::set{std::min(i + 1, end), std::min(i + 2, end), end})
      if (last > i)
        add_option(blocked, way_past_gaps(task_.tracks[blocked.strip], alone[i].first_gap,
                                          alone[last].last_gap, alone[i].detour.side));
  }
}

WayRound CurvedDecisions::way_past_gaps(const CurvedTrack& track, std::size_t first, std::size_t last,
                                        Passing side) const {
  WayRound way = curved_way_round({track, first, width_m_, task_.machine.radius_m, last}, side, around_);
  if (way.possible() && leads_to_another_part(task_.ground.plannable, way.detour))
    way.why_not = "it would lead to another part of the ground";
  return way;
}

void CurvedDecisions::add_option(BlockedTrack& blocked, WayRound way) {
  if (!way.possible()) return;
  const bool known = std::any_of(blocked.options.begin(), blocked.options.end(),
                                 [&way](const TrackOption& option) { return same_drive(option.way, way); });
  if (known) return;
  const CurvedTrack& track = task_.tracks[blocked.strip];
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
std::vector<int> CurvedDecisions::obstacles_near(const CurvedTrack& track, Interval range) const {
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

void CurvedDecisions::work(std::size_t track, const std::vector<StripDetour>& detours) {
  CurvedTracks laid;
  append_pieces(task_.tracks[track], detours, least_m_, laid);
  std::vector<Path> kept;
  std::vector<StripDetour> driven;
  for (const CurvedPiece& piece : laid.pieces) {
    for (const Interval& part : parts_on_track(piece))
      kept.push_back(path_along(task_.tracks[track], part.from, part.to));
    driven.insert(driven.end(), piece.detours.begin(), piece.detours.end());
  }
  cover_.set(track, kept, driven, width_m_);
  if (driven_[track] == !laid.pieces.empty()) return;
  driven_[track] = !laid.pieces.empty();
  for (Decision& decision : decisions_) decision.track.stale = true;
}

void CurvedDecisions::choose(Decision& decision, std::vector<StripDetour> detours) {
  if (same_detours(decision.chosen, detours)) return;
  const CurvedTrack& track = track_of(decision);
  for (const std::vector<StripDetour>* some : {&std::as_const(decision.chosen), &std::as_const(detours)})
    for (const StripDetour& detour : *some) {
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
  const CurvedTrack& track = track_of(decision);
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
  const CurvedTrack& track = track_of(decision);
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

double CurvedDecisions::saving_of(Decision& decision, std::vector<StripDetour>* best_detours) {
  value(decision);
  const CurvedTrack& track = track_of(decision);
  const CurvedCosts costs(decision.track, track, task_.objective, width_m_, least_m_);
  const auto best = cheapest_choice(decision.track, track.stretches, costs);
  if (!best || same_detours(best->detours, decision.chosen)) return 0;
  if (best_detours != nullptr) *best_detours = best->detours;
  return track_cost(track.stretches, costs, decision.chosen) - best->cost;
}

/// Those that save most come first. Every change saves, so the rounds come to an end.
bool CurvedDecisions::improve() {
  std::vector<std::pair<double, Decision*>> order;
  for (Decision& decision : decisions_) order.emplace_back(saving_of(decision, nullptr), &decision);
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  bool any = false;
  for (bool first_round = true, changed = true; changed; first_round = false) {
    changed = false;
    for (const auto& [saving, decision] : order) {
      if (!first_round && !decision->track.stale) continue;
      std::vector<StripDetour> detours;
      if (saving_of(*decision, &detours) <= kWorthIt) continue;
      choose(*decision, std::move(detours));
      changed = true;
    }
    any = any || changed;
  }
  return any;
}

void CurvedDecisions::take(const std::vector<std::vector<StripDetour>>& detours) {
  for (Decision& decision : decisions_) choose(decision, detours[decision.track.strip]);
}

std::vector<std::vector<StripDetour>> CurvedDecisions::detours() const {
  std::vector<std::vector<StripDetour>> out(task_.tracks.size());
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
  const CurvedTrack& track = track_of(decision);
  CurvedEncounter out;
  out.branch = track.branch;
  out.between = {track.stretches[gap - 1].to, track.stretches[gap].from};
  const double middle = 0.5 * (out.between.from + out.between.to);
  Encounter& encounter = out.encounter;
  encounter.track = track.index;
  encounter.at = path_between(track.path, 0, middle).back().to;
  encounter.obstacles = obstacles_near(track, out.between);
  for (const StripDetour& detour : decision.chosen)
    if (detour.from <= middle && detour.to >= middle) encounter.chosen = detour.side;
  const CurvedCosts costs(decision.track, track, task_.objective, width_m_, least_m_);
  const auto cut = cheapest_choice(decision.track, track.stretches, costs, Forced{gap, Passing::kCut});
  encounter.left = way_past(decision, gap, Passing::kLeft, cut->cost);
  encounter.right = way_past(decision, gap, Passing::kRight, cut->cost);
  return out;
}

WayPast CurvedDecisions::way_past(const Decision& decision, std::size_t gap, Passing side,
                                  double cost_of_cut) const {
  const CurvedTrack& track = track_of(decision);
  const CurvedCosts costs(decision.track, track, task_.objective, width_m_, least_m_);
  const auto choice = cheapest_choice(decision.track, track.stretches, costs, Forced{gap, side});
  if (choice) return {true, choice->cost - cost_of_cut, ""};
  for (const RefusedWay& refused : decision.track.refused)
    if (refused.gap == gap && refused.side == side) return {false, 0, refused.why};
  return {false, 0, "detours beside it are in the way"};
}

}  // namespace tramline
