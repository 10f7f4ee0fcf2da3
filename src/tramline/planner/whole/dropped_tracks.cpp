#include "tramline/planner/whole/dropped_tracks.h"

#include <algorithm>
#include <cassert>
#include <functional>

#include "tramline/planner/candidate/candidate.h"
#include "tramline/planner/whole/leg_prices.h"
#include "tramline/route/connection/least_seconds.h"

namespace tramline {
namespace {

constexpr std::size_t kLongestRun = 8;

/// Less is not worth leaving land unworked, EUR.
constexpr double kLeastSaved = 0.5;

bool is_worth_leaving(double saved, double lost) { return saved >= std::max(kLeastSaved, lost); }

/// The legs over pieces of a route and between them.
class PiecesOnRoute {
 public:
  explicit PiecesOnRoute(const HeadlandTrial& trial)
      : trial_(trial), plan_(trial.draft.plan), prices_(plan_.machine), least_(plan_.machine) {
    const std::vector<RouteLeg>& legs = plan_.route.legs;
    before_.push_back(0);
    for (const RouteLeg& leg : legs) before_.push_back(before_.back() + prices_.of(leg));
    at_.assign(plan_.pieces.size(), legs.size());
    for (std::size_t i = 0; i < legs.size(); ++i)
      if (legs[i].work && legs[i].piece) at_[*legs[i].piece] = i;
  }

  /// What is spent on the way past these pieces and on them, but for the shortest way past them.
  double spent_on(std::size_t first, std::size_t count) const {
    const std::vector<RouteLeg>& legs = plan_.route.legs;
    const std::size_t from = at_[first], to = at_[first + count - 1];
    if (to >= legs.size() || from > to) return 0;
    std::size_t previous = from, next = to + 1;
    while (previous > 0 && !legs[previous - 1].work) --previous;
    while (next < legs.size() && !legs[next].work) ++next;
    const double spent = before_[next] - before_[previous];
    if (previous == 0 || next == legs.size()) return spent;
    const Pose left = end_of(legs[previous - 1].path.back()), entered = legs[next].path.front().start;
    return spent - prices_.idle(least_.between(left, entered));
  }

  /// What the land of a piece is worth, less what it works again.
  double worth_of(std::size_t piece) const {
    const LaidPiece& laid = laid_piece(trial_, piece);
    const double again_m2 = plan_.machine.width_m * laid.length_m - laid.inside_m2;
    return prices_.missed(laid.inside_m2) - prices_.overlap(std::max(0.0, again_m2));
  }

  bool may_go(std::size_t piece) const {
    const std::vector<TrackPiece>& pieces = plan_.pieces;
    return !pieces[piece].after_crossing && !(piece + 1 < pieces.size() && pieces[piece + 1].after_crossing);
  }

 private:
  const HeadlandTrial& trial_;
  const Plan& plan_;
  LegPrices prices_;
  LeastSeconds least_;
  std::vector<double> before_{};   ///< what all legs before one cost
  std::vector<std::size_t> at_{};  ///< by piece: its leg
};

bool apart(const PieceRun& a, const PieceRun& b) {
  return a.first + a.count < b.first || b.first + b.count < a.first;
}

}  // namespace

std::vector<PieceRun> not_worth_their_ways(const HeadlandTrial& trial) {
  assert(trial.draft.plan.route.planned());
  const PiecesOnRoute route(trial);
  const std::size_t pieces = trial.draft.plan.pieces.size();
  std::vector<PieceRun> runs;
  for (std::size_t first = 0; first < pieces; ++first) {
    double worth = 0;
    for (std::size_t count = 1; count <= kLongestRun && first + count <= pieces && count < pieces; ++count) {
      if (!route.may_go(first + count - 1)) break;
      worth += route.worth_of(first + count - 1);
      const double saved = route.spent_on(first, count) - worth;
      if (is_worth_leaving(saved, worth)) runs.push_back({first, count, saved});
    }
  }
  std::ranges::stable_sort(runs, [](const PieceRun& a, const PieceRun& b) { return a.saved > b.saved; });
  std::vector<PieceRun> out;
  for (const PieceRun& run : runs)
    if (std::ranges::all_of(out, [&](const PieceRun& other) { return apart(run, other); }))
      out.push_back(run);
  return out;
}

bool is_worth_dropping(const Plan& with, const Plan& without) {
  const WholeCost before = whole_cost(with), after = whole_cost(without);
  return is_worth_leaving(before.euros() - after.euros(), after.missed - before.missed);
}

HeadlandTrial without(const std::vector<PieceRun>& runs, HeadlandTrial trial) {
  Candidate& candidate = trial.found.best;
  std::vector<LaidIndex> gone;
  for (const PieceRun& run : runs)
    for (std::size_t i = run.first; i < run.first + run.count; ++i)
      gone.push_back(trial.draft.driven.laid[i]);
  assert(gone.size() < trial.draft.plan.pieces.size());
  // From the last of each subfield on, so that the others keep their places.
  std::ranges::sort(gone, std::greater<>(), &LaidIndex::piece);
  for (const LaidIndex& index : gone) {
    LaidTracks& tracks = candidate.avoided.tracks[index.subfield];
    const auto piece = tracks.pieces.begin() + static_cast<std::ptrdiff_t>(index.piece);
    tracks.dropped.push_back(std::move(*piece));
    tracks.pieces.erase(piece);
  }
  settle_cost(SearchTask(trial.problem, trial.prepared), candidate);
  return trial;
}

}  // namespace tramline
