#include "tramline/planner/whole/shorter_ends.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <utility>

#include "tramline/headland/path_stretch.h"
#include "tramline/model/manoeuvre.h"
#include "tramline/planner/candidate/candidate.h"
#include "tramline/planner/whole/leg_prices.h"
#include "tramline/route/axle/axle_path.h"
#include "tramline/route/turning/planned_turns.h"
#include "tramline/turns/manoeuvres/dubins.h"

namespace tramline {
namespace {

/// Less is not worth leaving the end of a track unworked, EUR.
constexpr double kLeastSavedByEnds = 0.1;

bool is_worth_shortening(double saved, double lost) { return saved >= std::max(kLeastSavedByEnds, lost); }

/// Ends are shorter by these, m, beyond what makes them level, and then by as little as halving shows.
constexpr std::array kShorter_m = {0.0, 0.005, 0.02, 0.05, 0.1, 0.2, 0.35,
                                   0.5, 0.75,  1.0,  1.5,  2.0, 3.0, 4.0};
constexpr int kHalvingsOfEnds = 4;

/// Headings whose cosine is below this are opposite: the ends of such pieces may be made level.
constexpr double kOpposite = -0.9;

/// By how much the one piece ends early and the next one begins late, m.
struct Cut {
  double end_m = 0, start_m = 0;
};

/// The piece from `start_m` to `end_m` before its end. Detours stay: it is cut in the parts on its track.
TrackPiece cut(TrackPiece piece, double start_m, double end_m) {
  if (!piece.curve.empty()) {
    piece.curve = stretch_of(piece.curve, start_m, length(piece.curve) - end_m);
    piece.start = piece.curve.front().from;
    piece.end = piece.curve.back().to;
    return piece;
  }
  const Point back = parts_on_track(piece).back().front().from - piece.end;
  const Point on = parts_on_track(piece).front().back().to - piece.start;
  piece.end = piece.end + end_m / distance(back, {}) * back;
  piece.start = piece.start + start_m / distance(on, {}) * on;
  return piece;
}

/// The tracks that the pieces of a plan were cut from.
class TracksOfPieces {
 public:
  /// Curved tracks that were laid with their pieces are laid again.
  explicit TracksOfPieces(const HeadlandTrial& trial)
      : trial_(trial), laid_again_(trial.found.best.families.size()) {
    const Candidate& candidate = trial.found.best;
    const std::vector<LinedSubfield> ground = lined_subfields_of(candidate);
    for (std::size_t i = 0; i < laid_again_.size(); ++i)
      if (candidate.families[i].tracks.empty())
        laid_again_[i] = tracks_on(SearchTask(trial.problem, trial.prepared), ground[i]);
  }

  /// nullptr where it is not known.
  const Track* track(std::size_t driven) const {
    const LaidPiece& laid = laid_piece(trial_, driven);
    const std::size_t subfield = trial_.draft.driven.laid[driven].subfield;
    const TrackFamily& family =
        laid_again_[subfield] ? *laid_again_[subfield] : trial_.found.best.families[subfield];
    const auto found = std::ranges::find_if(family.tracks, [&](const Track& track) {
      return track.index == laid.track && track.branch == laid.branch;
    });
    if (found == family.tracks.end() || !begins_on(*found, laid)) return nullptr;
    return &*found;
  }

 private:
  /// Of tracks that were laid again.
  static bool begins_on(const Track& track, const LaidPiece& laid) {
    constexpr double kSamePlace_m = 1e-3;
    if (laid.path.empty() || is_straight(track)) return laid.path.empty() == is_straight(track);
    const Path along = path_along(track, laid.from, laid.to);
    return !along.empty() && distance(along.front().from, laid.path.front().from) < kSamePlace_m;
  }

  const HeadlandTrial& trial_;
  std::vector<std::optional<TrackFamily>> laid_again_;  ///< by subfield
};

bool is_driven_to(const HeadlandTrial& trial, std::size_t piece, bool at_end) {
  return at_end != trial.draft.driven.back[piece];
}

/// The ways between pieces that follow one another on a route.
class WaysOnRoute {
 public:
  /// The plan, with its route, outlives it.
  explicit WaysOnRoute(const Plan& plan) : plan_(plan), prices_(plan.machine), spent_(plan.pieces.size()) {
    std::optional<std::size_t> last;
    double since = 0;
    for (const RouteLeg& leg : plan_.route.legs) {
      if (!leg.work) {
        since += prices_.of(leg);
        continue;
      }
      if (last && leg.piece == *last + 1) spent_[*last] = since;
      last = leg.piece;
      since = 0;
    }
  }

  std::size_t count() const { return spent_.empty() ? 0 : spent_.size() - 1; }

  const std::optional<double>& spent(std::size_t before) const { return spent_[before]; }

  /// What is spent on the way from a piece to the next one beyond a shortest one between level ends, EUR.
  double may_save(std::size_t before) const {
    if (!spent_[before] || plan_.pieces[before + 1].after_crossing) return 0;
    Hop hop = hop_between(plan_.pieces[before], plan_.pieces[before + 1]);
    if (far_apart(hop, plan_.machine)) return 0;
    const Cut by = level(before);
    hop = {moved_on(hop.end, -by.end_m), moved_on(hop.start, by.start_m)};
    const SteeredPath shortest = shortest_dubins(hop.end, hop.start, plan_.machine.radius_m).path;
    return *spent_[before] - prices_.idle(length(shortest) / plan_.machine.turning.turning_speed_mps);
  }

  /// Pieces side by side end where the one of them does that ends first.
  Cut level(std::size_t before) const {
    const Hop hop = hop_between(plan_.pieces[before], plan_.pieces[before + 1]);
    const Point out = hop.end.heading.unit();
    if (dot(out, hop.start.heading.unit()) > kOpposite) return {};
    const double farther_m = dot(hop.start.at - hop.end.at, out);
    return {std::max(0.0, -farther_m), std::max(0.0, farther_m)};
  }

 private:
  const Plan& plan_;
  LegPrices prices_;
  std::vector<std::optional<double>> spent_;  ///< by piece: on the way to the next one, with no work between
};

/// The search for shorter ends.
class EndSearch {
 public:
  explicit EndSearch(const HeadlandTrial& trial)
      : trial_(trial),
        plan_(trial.draft.plan),
        land_(*trial.prepared.turning_land),
        prices_(plan_.machine),
        ways_(plan_),
        tracks_(trial) {}

  std::size_t count() const { return ways_.count(); }

  bool stays_long_enough(std::size_t piece, double shorter_m) const {
    return laid_piece(trial_, piece).length_m - shorter_m >= min_length_m(plan_.machine);
  }

  /// The ends of most gain at which a turn has room.
  std::optional<ShorterEnds> best_ends(std::size_t before) const {
    if (!is_worth_shortening(ways_.may_save(before), 0)) return std::nullopt;
    std::optional<ShorterEnds> best;
    const Cut from = ways_.level(before);
    for (const Cut& by : {Cut{1, 1}, Cut{1, 0}, Cut{0, 1}})
      if (auto found = least_cut(before, from, by); found && (!best || found->saved > best->saved))
        best = found;
    return best;
  }

 private:
  /// In the part on its track with which a piece begins or ends, if it does not end on a detour.
  bool may_cut(std::size_t piece, double by_m, bool at_end) const {
    const Track* const track = tracks_.track(piece);
    if (track == nullptr || track->closed || !stays_long_enough(piece, by_m)) return false;
    const std::vector<Path> parts = parts_on_track(plan_.pieces[piece]);
    if (parts.empty()) return false;
    const bool on_track = at_end ? parts.back().back().to == plan_.pieces[piece].end
                                 : parts.front().front().from == plan_.pieces[piece].start;
    return on_track && by_m < length(at_end ? parts.back() : parts.front());
  }

  bool may_cut(std::size_t before, const Cut& by) const {
    return may_cut(before, by.end_m, true) && may_cut(before + 1, by.start_m, false);
  }

  Hop hop_with(std::size_t before, const Cut& by) const {
    return hop_between(cut(plan_.pieces[before], 0, by.end_m), cut(plan_.pieces[before + 1], by.start_m, 0));
  }

  /// What the land is worth by which a piece is shorter at its driven end or beginning, less what it works
  /// again there, EUR.
  double worth_of(std::size_t piece, double shorter_m, bool at_end) const {
    if (!(shorter_m > 0)) return 0;
    const LaidPiece& laid = laid_piece(trial_, piece);
    const double from = is_driven_to(trial_, piece, at_end) ? laid.to - shorter_m : laid.from;
    const double inside_m2 = inside_between(*tracks_.track(piece), from, from + shorter_m);
    const double again_m2 = plan_.machine.width_m * shorter_m - inside_m2;
    return prices_.missed(inside_m2) - prices_.overlap(std::max(0.0, again_m2));
  }

  double worth_of(std::size_t before, const Cut& by) const {
    return worth_of(before, by.end_m, true) + worth_of(before + 1, by.start_m, false);
  }

  std::optional<double> turned_s(std::size_t before, const Cut& by) const {
    const auto turn = turn_before_ends(hop_with(before, by), land_, plan_.machine, {});
    if (!turn) return std::nullopt;
    return seconds(*turn, plan_.machine);
  }

  /// The least that both ends have to be shorter, `by` for each metre, beyond `from`.
  std::optional<ShorterEnds> least_cut(std::size_t before, const Cut& from, const Cut& by) const {
    const auto shorter = [&](double m) {
      return Cut{from.end_m + m * by.end_m, from.start_m + m * by.start_m};
    };
    const double may_save = ways_.may_save(before);
    double without_room_m = 0;
    for (const double step_m : kShorter_m) {
      if (!may_cut(before, shorter(step_m))) return std::nullopt;
      const double worth = worth_of(before, shorter(step_m));
      if (!is_worth_shortening(may_save - worth, worth)) return std::nullopt;
      if (!turned_s(before, shorter(step_m))) {
        without_room_m = step_m;
        continue;
      }
      double with_room_m = step_m;
      for (int i = 0; i < kHalvingsOfEnds && with_room_m > 0; ++i) {
        const double middle_m = 0.5 * (without_room_m + with_room_m);
        (turned_s(before, shorter(middle_m)) ? with_room_m : without_room_m) = middle_m;
      }
      return ends(before, shorter(with_room_m));
    }
    return std::nullopt;
  }

  std::optional<ShorterEnds> ends(std::size_t before, const Cut& by) const {
    const double worth = worth_of(before, by);
    const double saved = *ways_.spent(before) - prices_.idle(*turned_s(before, by)) - worth;
    if (!is_worth_shortening(saved, worth)) return std::nullopt;
    return ShorterEnds{before, by.end_m, by.start_m, saved};
  }

  const HeadlandTrial& trial_;
  const Plan& plan_;
  const AllowedLand& land_;
  LegPrices prices_;
  WaysOnRoute ways_;
  TracksOfPieces tracks_;
};

}  // namespace

double most_saved_by_shorter_ends(const HeadlandTrial& trial) {
  assert(trial.draft.plan.route.planned());
  const WaysOnRoute ways(trial.draft.plan);
  double out = 0;
  for (std::size_t i = 0; i < ways.count(); ++i)
    if (const double saved = ways.may_save(i); is_worth_shortening(saved, 0)) out += saved;
  return out;
}

std::vector<ShorterEnds> ends_worth_shortening(const HeadlandTrial& trial) {
  assert(trial.draft.plan.route.planned());
  if (trial.problem.settings.tracks != TrackConstruction::kParallel) return {};
  const EndSearch search(trial);
  std::vector<ShorterEnds> out;
  for (std::size_t i = 0; i < search.count(); ++i) {
    const auto ends = search.best_ends(i);
    if (!ends) continue;
    // A piece that is cut at both ends must not get too short.
    const bool both = !out.empty() && out.back().before + 1 == i;
    if (both && !search.stays_long_enough(i, out.back().start_m + ends->end_m)) continue;
    out.push_back(*ends);
  }
  return out;
}

HeadlandTrial shortened(const std::vector<ShorterEnds>& ends, HeadlandTrial trial) {
  const TracksOfPieces tracks(trial);
  Candidate& candidate = trial.found.best;
  const auto shorten = [&](std::size_t piece, double by_m, bool at_end) {
    if (!(by_m > 0)) return;
    const LaidIndex index = trial.draft.driven.laid[piece];
    const bool at_to = is_driven_to(trial, piece, at_end);
    const Track* const track = tracks.track(piece);
    assert(track != nullptr);
    LaidPiece& laid = candidate.avoided.tracks[index.subfield].pieces[index.piece];
    laid = cut_to(*track, laid, at_to ? laid.from : laid.from + by_m, at_to ? laid.to - by_m : laid.to);
  };
  for (const ShorterEnds& one : ends) {
    shorten(one.before, one.end_m, true);
    shorten(one.before + 1, one.start_m, false);
  }
  settle_cost(SearchTask(trial.problem, trial.prepared), candidate);
  return trial;
}

HeadlandTrial with_shorter_ends(HeadlandTrial trial) {
  for (int i = 0; i < kTimesShortened; ++i) {
    const std::vector<ShorterEnds> ends = ends_worth_shortening(trial);
    if (ends.empty()) break;
    HeadlandTrial shorter = shortened(ends, trial);
    shorter.draft = drafted(SearchTask(shorter.problem, shorter.prepared), shorter.found);
    if (whole_cost(shorter.draft.plan).euros() >= whole_cost(trial.draft.plan).euros()) break;
    trial = std::move(shorter);
  }
  return trial;
}

}  // namespace tramline
