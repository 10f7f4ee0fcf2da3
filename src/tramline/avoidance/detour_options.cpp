// Which ways each track has past what is in its way.

#include <algorithm>
#include <utility>

#include "tramline/avoidance/detour_decisions.h"
#include "tramline/avoidance/goes_round.h"
#include "tramline/avoidance/paper_way.h"

namespace tramline {
namespace {

constexpr const char* kFarTooDear = "it would cost far more than a cut";

Obstruction obstruction(const TrackFamily& family, const Track& strip, std::size_t gap,
                        const Machine& machine) {
  return {family.grid, strip, gap, machine.radius_m};
}

}  // namespace

void DetourDecisions::add_tracks(std::size_t subfield) {
  const TrackFamily& family = task_.families[subfield];
  for (std::size_t i = 0; i < family.tracks.size(); ++i) {
    BlockedTrack track;
    track.subfield = subfield;
    track.strip = i;
    track.gaps = hard_gaps(family.tracks[i]);
    if (track.gaps.empty()) continue;
    track.correction_m2.assign(family.tracks[i].stretches.size(), 0);
    add_options(track);
    tracks_.push_back({std::move(track), {}});
    if (ways_ != WaysPast::kPaper) drop_dear_options(tracks_.back());
  }
}

TrackTerms DetourDecisions::terms_of(const BlockedTrack& track) const {
  return {track.subfield, task_.families[track.subfield].tracks[track.strip], task_.objective, width_m_,
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
        add_option(track, way);
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
  const TrackFamily& family = task_.families[track.subfield];
  Obstruction gaps = obstruction(family, family.tracks[track.strip], first, task_.machine);
  gaps.last_gap = last;
  return way_round(gaps, side, around_[track.subfield]);
}

/// Unless it is known, cannot be driven, or cannot pay.
void DetourDecisions::add_option(BlockedTrack& track, const WayRound& way) {
  if (!way.possible() || has_option(track, way)) return;
  const TrackFamily& family = task_.families[track.subfield];
  TrackOption option = option_of(named(track.subfield, way), family.grid, family.tracks[track.strip].index);
  if (!hopeless(option, terms_of(track), task_.families, ground_)) {
    track.options.push_back(std::move(option));
    return;
  }
  for (std::size_t gap = way.first_gap; gap <= way.last_gap; ++gap)
    track.refused.push_back({gap, way.detour.side, kFarTooDear});
}

void DetourDecisions::add_paper_option(BlockedTrack& track, std::size_t gap) {
  const TrackFamily& family = task_.families[track.subfield];
  const double threshold = task_.settings.avoid_threshold_m;
  WayRound way = paper_way(obstruction(family, family.tracks[track.strip], gap, task_.machine),
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
      option_of(named(track.subfield, way), family.grid, family.tracks[track.strip].index));
  track.options.back().of_paper = true;
}

WayRound DetourDecisions::named(std::size_t subfield, WayRound way) const {
  const TrackFrame& frame = task_.families[subfield].grid.frame;
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

}  // namespace tramline
