#include "tramline/avoidance/detour_decisions.h"

#include <algorithm>
#include <utility>

#include "tramline/avoidance/decision_rounds.h"
#include "tramline/avoidance/goes_round.h"
#include "tramline/avoidance/paper_way.h"

namespace tramline {
namespace {

constexpr const char* kFarTooDear = "it would cost far more than a cut";

StripRange range_of(const Strips& strips) {
  if (strips.strips.empty()) return {};
  return {strips.strips.front().index, strips.strips.back().index};
}

StripWork work_of(const Strip& strip, const std::vector<StripDetour>& detours, double least_m) {
  SubfieldTracks out{{TrackFrame(Direction::clockwise_from_north(Angle::degrees(0))), 0, 1}, {}, {}};
  append_pieces(strip, detours, least_m, out);
  StripWork work;
  for (const StripPiece& piece : out.pieces) {
    for (const Interval& part : straight_parts(piece)) work.straight.push_back(part);
    for (const StripDetour& detour : piece.detours) work.detours.push_back(detour);
  }
  return work;
}

bool is_driven(const StripWork& work) { return !work.straight.empty() || !work.detours.empty(); }

Obstruction obstruction(const Strips& strips, const Strip& strip, std::size_t gap, const Machine& machine) {
  return {strips.grid, strip, gap, machine.width_m, machine.radius_m};
}

/// Where the field's obstacles lie along a grid.
std::vector<Interval> extents_along(const Field& field, const TrackFrame& frame) {
  std::vector<Interval> out;
  for (const Obstacle& obstacle : field.obstacles) {
    const Box box = bounds(frame.to_track(obstacle.shape.outer));
    out.push_back({box.min_y, box.max_y});
  }
  return out;
}

/// Of two ascending lists.
void keep_common(std::vector<int>& some, const std::vector<int>& others) {
  std::erase_if(some, [&](int x) { return !std::binary_search(others.begin(), others.end(), x); });
}

bool share_a_hazard(const BlockedTrack& a, const BlockedTrack& b) {
  for (const TrackOption& mine : a.options)
    for (const TrackOption& theirs : b.options)
      for (const std::size_t hazard : mine.way.hazards)
        if (std::find(theirs.way.hazards.begin(), theirs.way.hazards.end(), hazard) !=
            theirs.way.hazards.end())
          return true;
  return false;
}

}  // namespace

DetourDecisions::DetourDecisions(const AvoidanceTask& task, WaysPast ways)
    : task_(task), ways_(ways), width_m_(task.machine.width_m), least_m_(min_length_m(task.machine)) {
  const bool hard = task.settings.boundary == EdgeKind::kHard;
  for (std::size_t i = 0; i < task.strips.size(); ++i) {
    const Strips& strips = task.strips[i];
    around_.push_back(turned_surroundings(task.ground, task.field.outer, hard, strips.grid.frame));
    obstacles_.push_back(extents_along(task.field, strips.grid.frame));
    body_.emplace_back();
    for (const Ring& ring : rings_of(task.ground.body))
      body_.back().push_back(strips.grid.frame.to_track(ring));
    ground_.add_subfield(strips.grid, range_of(strips));
    for (const Strip& strip : strips.strips) work(i, strip, {});
  }
  for (std::size_t i = 0; i < task.strips.size(); ++i) add_tracks(i);
}

void DetourDecisions::add_tracks(std::size_t subfield) {
  const Strips& strips = task_.strips[subfield];
  for (std::size_t i = 0; i < strips.strips.size(); ++i) {
    BlockedTrack track;
    track.subfield = subfield;
    track.strip = i;
    track.gaps = hard_gaps(strips.strips[i]);
    if (track.gaps.empty()) continue;
    track.correction_m2.assign(strips.strips[i].stretches.size(), 0);
    add_options(track);
    tracks_.push_back({std::move(track), {}});
    if (ways_ != WaysPast::kPaper) drop_dear_options(tracks_.back());
  }
}

TrackTerms DetourDecisions::terms_of(const BlockedTrack& track) const {
  return {track.subfield, task_.strips[track.subfield].strips[track.strip], task_.objective, width_m_,
          least_m_};
}

/// While all tracks are cut. S1's ways stay: its plan is to be compared with.
void DetourDecisions::drop_dear_options(Decision& decision) {
  value(decision);
  BlockedTrack& track = decision.track;
  std::erase_if(track.options, [&](const TrackOption& option) {
    if (option.of_paper || !far_too_dear(option, terms_of(track))) return false;
    for (std::size_t gap = option.way.first_gap; gap <= option.way.last_gap; ++gap)
      track.refused.push_back({gap, option.way.detour.side, kFarTooDear});
    return true;
  });
}

void DetourDecisions::add_options(BlockedTrack& track) {
  if (ways_ != WaysPast::kPaper)
    for (const Passing side : {Passing::kLeft, Passing::kRight}) {
      std::vector<WayRound> alone;
      for (const std::size_t gap : track.gaps) {
        WayRound way = way_past_gaps(track, gap, gap, side);
        if (way.possible())
          alone.push_back(way);
        else
          track.refused.push_back({gap, side, way.why_not});
        add_option(track, std::move(way));
      }
      for (const GapRow& row : rows_to_join(alone))
        add_option(track, way_past_gaps(track, row.first, row.last, side));
    }
  if (ways_ != WaysPast::kOwn)
    for (const std::size_t gap : track.gaps) add_paper_option(track, gap);
  std::stable_sort(
      track.options.begin(), track.options.end(),
      [](const TrackOption& a, const TrackOption& b) { return a.way.first_gap < b.way.first_gap; });
}

WayRound DetourDecisions::way_past_gaps(const BlockedTrack& track, std::size_t first, std::size_t last,
                                        Passing side) const {
  const Strips& strips = task_.strips[track.subfield];
  Obstruction gaps = obstruction(strips, strips.strips[track.strip], first, task_.machine);
  gaps.last_gap = last;
  return way_round(gaps, side, around_[track.subfield]);
}

/// Unless it is known, cannot be driven, or cannot pay.
void DetourDecisions::add_option(BlockedTrack& track, WayRound way) {
  if (!way.possible() || has_option(track, way)) return;
  const Strips& strips = task_.strips[track.subfield];
  TrackOption option = option_of(named(track.subfield, way), strips.grid, strips.strips[track.strip].index);
  if (!hopeless(option, terms_of(track), task_.strips, ground_)) {
    track.options.push_back(std::move(option));
    return;
  }
  for (std::size_t gap = way.first_gap; gap <= way.last_gap; ++gap)
    track.refused.push_back({gap, way.detour.side, kFarTooDear});
}

void DetourDecisions::add_paper_option(BlockedTrack& track, std::size_t gap) {
  const Strips& strips = task_.strips[track.subfield];
  const double threshold = task_.settings.avoid_threshold_m;
  WayRound way = paper_way(obstruction(strips, strips.strips[track.strip], gap, task_.machine),
                           threshold < 0 ? width_m_ : threshold, around_[track.subfield]);
  if (!way.possible()) {
    if (ways_ == WaysPast::kPaper)
      for (const Passing side : {Passing::kLeft, Passing::kRight})
        track.refused.push_back({gap, side, way.why_not});
    return;
  }
  for (TrackOption& option : track.options)
    if (same_drive(option.way, way)) {
      option.of_paper = true;
      return;
    }
  track.options.push_back(
      option_of(named(track.subfield, way), strips.grid, strips.strips[track.strip].index));
  track.options.back().of_paper = true;
}

WayRound DetourDecisions::named(std::size_t subfield, WayRound way) const {
  const TrackFrame& frame = task_.strips[subfield].grid.frame;
  way.detour.obstacles = obstacles_along(subfield, way.hazards, {way.detour.from, way.detour.to});
  std::erase_if(way.detour.obstacles, [&](int obstacle) {
    const Polygon& shape = task_.field.obstacles[static_cast<std::size_t>(obstacle)].shape;
    return !goes_round(way.detour, frame.to_track(shape.outer));
  });
  return way;
}

/// Land given up may join a hazard's obstacles to others far away: those are neither met nor passed here.
std::vector<int> DetourDecisions::obstacles_along(std::size_t subfield,
                                                  const std::vector<std::size_t>& hazards,
                                                  Interval range) const {
  constexpr double kRounding = 1e-6;
  std::vector<int> out;
  for (const std::size_t hazard : hazards)
    for (const int obstacle : task_.ground.hazards[hazard].obstacles) {
      const Interval extent = obstacles_[subfield][static_cast<std::size_t>(obstacle)];
      if (extent.from < range.to - kRounding && extent.to > range.from + kRounding) out.push_back(obstacle);
    }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

void DetourDecisions::work(std::size_t subfield, const Strip& strip,
                           const std::vector<StripDetour>& detours) {
  const bool was_driven = is_driven(ground_.at(subfield, strip.index));
  ground_.set(subfield, strip.index, work_of(strip, detours, least_m_));
  const int change = (is_driven(ground_.at(subfield, strip.index)) ? 1 : 0) - (was_driven ? 1 : 0);
  driven_ += change;
  // From none to one or from one to two, or back: another track may now be the only one.
  if (change == 0 || std::max(driven_, driven_ - change) > 2) return;
  for (Decision& decision : tracks_) decision.track.stale = true;
}

void DetourDecisions::choose(Decision& decision, std::vector<StripDetour> detours) {
  if (same_detours(decision.chosen, detours)) return;
  mark_stale_near(decision, decision.chosen);
  mark_stale_near(decision, detours);
  decision.chosen = std::move(detours);
  work(decision.track.subfield, strip_of(decision), decision.chosen);
}

/// What others are worth depends on where this track's detours are, and on what they leave of its
/// straight parts.
void DetourDecisions::mark_stale_near(const Decision& decision, const std::vector<StripDetour>& detours) {
  const StripGrid& grid = strips_of(decision).grid;
  for (const StripDetour& detour : detours) {
    Box changed = detour_box(detour, grid.width_m);
    changed.extend(straight_box(grid, strip_of(decision).index, {detour.from, detour.to}));
    // A short stretch may be driven only because the detour joins it to another.
    for (const Interval& stretch : strip_of(decision).stretches)
      if (stretch.length() < least_m_ && stretch.to >= detour.from && stretch.from <= detour.to)
        changed.extend(straight_box(grid, strip_of(decision).index, stretch));
    for (Decision& other : tracks_) {
      if (&other == &decision) continue;
      if (other.track.subfield == decision.track.subfield)
        mark_stale(other.track, strips_of(other), changed);
      else
        mark_all_stale(other.track);
    }
  }
}

bool DetourDecisions::take_paper_ways() {
  bool any = false;
  for (Decision& decision : tracks_) {
    std::vector<StripDetour> detours;
    for (const TrackOption& option : decision.track.options) {
      if (!option.of_paper) continue;
      // Two that run into each other on one track: the first is driven, S1 knows no more.
      if (!detours.empty() && detours.back().to > option.way.detour.from) continue;
      detours.push_back(option.way.detour);
    }
    any = any || !detours.empty();
    choose(decision, std::move(detours));
  }
  return any;
}

void DetourDecisions::take_from(const std::vector<SubfieldTracks>& tracks) {
  for (Decision& decision : tracks_) {
    std::vector<StripDetour> detours;
    for (const StripPiece& piece : tracks[decision.track.subfield].pieces)
      if (piece.strip == strip_of(decision).index)
        detours.insert(detours.end(), piece.detours.begin(), piece.detours.end());
    choose(decision, std::move(detours));
  }
}

void DetourDecisions::value(Decision& decision) {
  const StripWork& own = ground_.at(decision.track.subfield, strip_of(decision).index);
  decision.track.only_one_driven = driven_ == (is_driven(own) ? 1 : 0);
  value_options(decision.track, strips_of(decision), body_[decision.track.subfield], ground_, least_m_);
}

/// What the track's best choice saves against what it does now.
double DetourDecisions::saving_of(Decision& decision, std::vector<StripDetour>* best_detours) {
  value(decision);
  const Strip& strip = strip_of(decision);
  const auto best = cheapest_choice(decision.track, strip, width_m_, task_.objective, least_m_);
  if (!best || same_detours(best->detours, decision.chosen)) return 0;
  if (best_detours != nullptr) *best_detours = best->detours;
  return track_cost(decision.track, strip, width_m_, decision.chosen, task_.objective, least_m_) - best->cost;
}

bool DetourDecisions::improve() {
  const auto saving = [this](Decision& decision, std::vector<StripDetour>* best) {
    return saving_of(decision, best);
  };
  const auto chosen = [this](Decision& decision, std::vector<StripDetour> detours) {
    choose(decision, std::move(detours));
  };
  const std::vector<Decision*> order = by_saving(tracks_, saving);
  const bool singly = improve_one_by_one(order, saving, chosen);
  if (!improve_pairs()) return singly;
  improve_one_by_one(order, saving, chosen);
  return true;
}

/// A pole on the line between two tracks: what suits either while the other stays need not be what suits
/// both.
bool DetourDecisions::improve_pairs() {
  const auto one_pole = [this](std::size_t i, std::size_t j) {
    if (j >= tracks_.size()) return false;
    const BlockedTrack &a = tracks_[i].track, &b = tracks_[j].track;
    return a.subfield == b.subfield && b.strip == a.strip + 1 && a.gaps.size() == 1 && b.gaps.size() == 1 &&
           share_a_hazard(a, b);
  };
  bool any = false;
  for (std::size_t i = 0; i + 1 < tracks_.size(); ++i) {
    if (!one_pole(i, i + 1) || one_pole(i + 1, i + 2) || (i > 0 && one_pole(i - 1, i))) continue;
    any = improve_pair(tracks_[i], tracks_[i + 1]) || any;
  }
  return any;
}

/// Every choice for the first with the best one for the second.
bool DetourDecisions::improve_pair(Decision& first, Decision& second) {
  const std::vector<StripDetour> first_now = first.chosen, second_now = second.chosen;
  std::vector<std::vector<StripDetour>> choices{{}};
  for (const TrackOption& option : first.track.options) choices.push_back({option.way.detour});
  const auto cost_of = [this](Decision& decision, const std::vector<StripDetour>& detours) {
    value(decision);
    return track_cost(decision.track, strip_of(decision), width_m_, detours, task_.objective, least_m_);
  };
  double most_saved = kWorthIt;
  std::vector<StripDetour> best_first, best_second;
  for (const std::vector<StripDetour>& choice : choices) {
    if (same_detours(choice, first_now)) continue;
    double saved = cost_of(first, first_now) - cost_of(first, choice);
    choose(first, choice);
    saved += cost_of(second, second_now);
    const auto answer = cheapest_choice(second.track, strip_of(second), width_m_, task_.objective, least_m_);
    if (answer && saved - answer->cost > most_saved) {
      most_saved = saved - answer->cost;
      best_first = choice;
      best_second = answer->detours;
    }
    choose(first, first_now);
  }
  if (most_saved <= kWorthIt) return false;
  choose(first, std::move(best_first));
  choose(second, std::move(best_second));
  return true;
}

std::vector<SubfieldTracks> DetourDecisions::tracks() const {
  std::vector<SubfieldTracks> out;
  std::size_t next = 0;
  for (std::size_t i = 0; i < task_.strips.size(); ++i) {
    const Strips& strips = task_.strips[i];
    SubfieldTracks laid{strips.grid, {}, {}};
    for (std::size_t k = 0; k < strips.strips.size(); ++k) {
      const bool decided =
          next < tracks_.size() && tracks_[next].track.subfield == i && tracks_[next].track.strip == k;
      append_pieces(strips.strips[k], decided ? tracks_[next].chosen : std::vector<StripDetour>{}, least_m_,
                    laid);
      if (decided) ++next;
    }
    out.push_back(std::move(laid));
  }
  return out;
}

std::vector<Encounter> DetourDecisions::encounters() {
  std::vector<Encounter> out;
  for (Decision& decision : tracks_) {
    value(decision);
    for (const std::size_t gap : decision.track.gaps) out.push_back(encounter_at(decision, gap));
  }
  return out;
}

Encounter DetourDecisions::encounter_at(Decision& decision, std::size_t gap) {
  const Strips& strips = strips_of(decision);
  const Strip& strip = strip_of(decision);
  const Interval between{strip.stretches[gap - 1].to, strip.stretches[gap].from};
  const double middle = 0.5 * (between.from + between.to);
  Encounter out;
  out.subfield = static_cast<int>(decision.track.subfield);
  out.track = strip.index;
  out.at = strips.grid.frame.to_field({strips.grid.centre(strip.index), middle});
  const std::size_t subfield = decision.track.subfield;
  out.obstacles =
      obstacles_along(subfield, hazards_in(strips.grid, strip, between, around_[subfield]), between);
  for (const StripDetour& detour : decision.chosen)
    if (detour.from <= middle && detour.to >= middle) {
      out.chosen = detour.side;
      keep_common(out.obstacles, detour.obstacles);
    }
  const auto choice = [&](Passing side) {
    return cheapest_choice(decision.track, strip, width_m_, task_.objective, least_m_, Forced{gap, side});
  };
  const double cost_of_cut = choice(Passing::kCut)->cost;
  const auto past = [&](Passing side) {
    return way_past(decision.track, {gap, side}, choice(side), cost_of_cut, "S1 passes on the other side");
  };
  out.left = past(Passing::kLeft);
  out.right = past(Passing::kRight);
  return out;
}

}  // namespace tramline
