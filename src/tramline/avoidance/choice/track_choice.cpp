#include "tramline/avoidance/choice/track_choice.h"

#include <algorithm>
#include <array>
#include <limits>

#include "tramline/avoidance/tolerances.h"

namespace tramline {
namespace {

constexpr double kImpossible = std::numeric_limits<double>::infinity();
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// The cost of one stretch, or of several joined.
struct StretchCost {
  double sum = 0;
  bool driven = false;  ///< false: too short
};

/// The costs of driving pieces of one track.
class PieceCost {
 public:
  PieceCost(const BlockedTrack& blocked, const Track& track, double width_m, const Objective& objective,
            double min_length_m)
      : blocked_(blocked),
        track_(track),
        width_m_(width_m),
        objective_(objective),
        min_length_m_(min_length_m) {}

  StretchCost of(const JoinedStretch& joined) const {
    LaidTracks laid{{TrackFrame(), 0, width_m_}, {}, {}};
    append_joined(track_, joined, min_length_m_, laid);
    StretchCost out;
    for (const LaidPiece& piece : laid.pieces) out.sum += of_piece(piece);
    out.driven = !laid.pieces.empty();
    // A closed track goes on behind its beginning: one piece with the stretch that ends there.
    if (track_.closed && out.driven && joined.whole.from <= kNoPiece_m &&
        joined.whole.to < track_.length_m - kNoPiece_m)
      out.sum -= objective_.turn;
    return out;
  }

  /// What the first piece adds to the cost of the plan besides its own. Every piece counts a turn, and a plan
  /// with any piece has one turn less; a subfield costs something from its first piece on, but for the first
  /// of all.
  double of_first() const {
    if (blocked_.only_one_driven) return -objective_.turn;
    return blocked_.only_one_of_subfield ? objective_.subfield : 0;
  }

  /// Cost that an option adds to a piece that is driven in any case.
  double of_option(const TrackOption& option) const {
    const double longer = option.way.detour.length_m - kept_length(option.replaced);
    return objective_.overlap * width_m_ * longer -
           (objective_.overlap + objective_.uncovered) * option.gain_m2();
  }

 private:
  double of_piece(const LaidPiece& piece) const {
    double useful = piece.inside_m2;
    for (const TrackDetour& detour : piece.detours) useful += useful_of(detour);
    for (std::size_t i = 0; i < track_.stretches.size(); ++i)
      if (track_.stretches[i].from >= piece.from && track_.stretches[i].to <= piece.to)
        useful += blocked_.correction_m2[i];
    const int stops = (piece.stop_at_from ? 1 : 0) + (piece.stop_at_to ? 1 : 0);
    return objective_.overlap * (width_m_ * piece.length_m - useful) - objective_.uncovered * useful +
           objective_.turn * (piece.after_crossing ? 0 : 1) + objective_.stop * stops;
  }

  double useful_of(const TrackDetour& detour) const {
    for (const TrackOption& option : blocked_.options)
      if (option.way.detour.from == detour.from && option.way.detour.to == detour.to &&
          option.way.detour.side == detour.side && option.way.detour.path == detour.path)
        return option.gain_m2() + option.profile_m2;
    return 0;
  }

  double kept_length(const Interval& range) const {
    double sum = 0;
    for (const Interval& part : common(track_.stretches, {range})) sum += part.length();
    return sum;
  }

  const BlockedTrack& blocked_;
  const Track& track_;
  double width_m_;
  const Objective& objective_;
  double min_length_m_;
};

/// Chains of options that join the stretches first … last without a cut.
class Chains {
 public:
  Chains(const BlockedTrack& track, const PieceCost& cost, std::size_t first, std::optional<Forced> forced)
      : track_(track),
        first_(first),
        sums_(track.options.size(), kImpossible),
        before_(track.options.size(), kNone) {
    for (std::size_t i = 0; i < track.options.size(); ++i)
      if (allowed(track.options[i], forced)) extend_to(i, cost.of_option(track.options[i]));
  }

  /// The cheapest chain that ends with stretch `last`; empty where there is none.
  std::vector<TrackDetour> to(std::size_t last) const {
    std::size_t best = kNone;
    for (std::size_t i = 0; i < sums_.size(); ++i)
      if (sums_[i] < kImpossible && track_.options[i].way.last_gap == last &&
          (best == kNone || sums_[i] < sums_[best]))
        best = i;
    std::vector<TrackDetour> out;
    for (std::size_t i = best; i != kNone; i = before_[i]) out.push_back(track_.options[i].way.detour);
    std::reverse(out.begin(), out.end());
    return out;
  }

 private:
  static bool allowed(const TrackOption& option, std::optional<Forced> forced) {
    if (!forced || forced->gap < option.way.first_gap || forced->gap > option.way.last_gap) return true;
    return forced->way == option.way.detour.side;
  }

  void extend_to(std::size_t i, double cost) {
    const WayRound& way = track_.options[i].way;
    if (way.first_gap == first_ + 1) sums_[i] = cost;
    for (std::size_t j = 0; j < i; ++j) {
      const WayRound& previous = track_.options[j].way;
      if (previous.last_gap + 1 != way.first_gap || previous.detour.to > way.detour.from) continue;
      if (sums_[j] + cost < sums_[i]) {
        sums_[i] = sums_[j] + cost;
        before_[i] = j;
      }
    }
  }

  const BlockedTrack& track_;
  std::size_t first_;
  std::vector<double> sums_;
  std::vector<std::size_t> before_;
};

/// The best choices for the first stretches of a track: those that drive none of them, and those that do.
using Choices = std::array<TrackChoice, 2>;

void add(Choices& choices, const Choices& before, const std::vector<TrackDetour>& detours,
         const StretchCost& cost) {
  for (const bool driven_before : {false, true}) {
    const TrackChoice& start = before[driven_before ? 1 : 0];
    TrackChoice& best = choices[driven_before || cost.driven ? 1 : 0];
    if (!(start.cost + cost.sum < best.cost)) continue;
    best = {start.detours, start.cost + cost.sum};
    best.detours.insert(best.detours.end(), detours.begin(), detours.end());
  }
}

}  // namespace

double track_cost(const BlockedTrack& blocked, const Track& track, double width_m,
                  const std::vector<TrackDetour>& detours, const Objective& objective, double min_length_m) {
  const PieceCost cost(blocked, track, width_m, objective, min_length_m);
  StretchCost all;
  for (const JoinedStretch& joined : joined_stretches(track.stretches, detours)) {
    const StretchCost one = cost.of(joined);
    all.sum += one.sum;
    all.driven = all.driven || one.driven;
  }
  return all.driven ? all.sum + cost.of_first() : all.sum;
}

std::optional<TrackChoice> cheapest_choice(const BlockedTrack& blocked, const Track& track, double width_m,
                                           const Objective& objective, double min_length_m,
                                           std::optional<Forced> forced) {
  const PieceCost cost(blocked, track, width_m, objective, min_length_m);
  const Intervals& stretches = track.stretches;
  const std::size_t count = stretches.size();
  // best[j]: stretches before j are decided, and the track is cut before stretch j.
  std::vector<Choices> best(count + 1, {TrackChoice{{}, kImpossible}, TrackChoice{{}, kImpossible}});
  best[0][0].cost = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const bool may_cut = i == 0 || !forced || forced->gap != i || forced->way == Passing::kCut;
    if (!may_cut || std::min(best[i][0].cost, best[i][1].cost) == kImpossible) continue;
    const Chains chains(blocked, cost, i, forced);
    for (std::size_t last = i; last < count; ++last) {
      const std::vector<TrackDetour> detours = last == i ? std::vector<TrackDetour>{} : chains.to(last);
      if (last > i && detours.empty()) continue;
      add(best[last + 1], best[i], detours, cost.of({{stretches[i].from, stretches[last].to}, detours}));
    }
  }
  auto& [not_driven, driven] = best[count];
  driven.cost += cost.of_first();
  TrackChoice& least = not_driven.cost < driven.cost ? not_driven : driven;
  if (least.cost == kImpossible) return std::nullopt;
  return std::move(least);
}

}  // namespace tramline
