#include "tramline/planner/search/branch_and_bound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <queue>

#include "tramline/cost/bound/best_offset.h"
#include "tramline/planner/for_each_index.h"
#include "tramline/planner/search/edge_aligned_grids.h"
#include "tramline/planner/search/grid_shortlist.h"

namespace tramline {
namespace {

constexpr double kHalfTurn = std::numbers::pi;
constexpr std::size_t kBatch = 8;            ///< boxes divided at a time, for any number of threads
constexpr double kNearBest = 0.15;           ///< small steps hardly better a grid by more
constexpr int kLookEvery = 200;              ///< boxes, after which the search gives up if …
constexpr double kLeastProgress = 0.025;     ///< … no more than this share of the gap has been closed
constexpr double kLeastWhereHindered = 0.1;  ///< … or this one where obstacles keep the bound from the cost
const Angle kFirstTurn = Angle::degrees(0.4);  ///< of the steps that better a grid …
const Angle kCoarse = Angle::degrees(0.1);     ///< … and where most of them stop
constexpr std::size_t kFollowed = 1;           ///< grids that are bettered by finer steps
constexpr double kFirstHalfAngle = kHalfTurn / 360;
constexpr double kLeastShift =
    1.0 / (1 << 18);  ///< widths by which the grids of a box differ that is not divided

struct SearchBox : PositionBox {
  double bound = 0;
};

struct LaterBox {
  bool operator()(const SearchBox& a, const SearchBox& b) const {
    if (a.bound != b.bound) return a.bound > b.bound;
    if (a.middle.angle != b.middle.angle) return a.middle.angle > b.middle.angle;
    return a.middle.offset_m > b.middle.offset_m;
  }
};

class GridSearch {
 public:
  GridSearch(const SearchTask& task, const Polygon& part, const SearchEffort& effort,
             const SearchContext& context, NearObstacles near)
      : pricing_(task, part, context, near),
        effort_(effort),
        context_(context),
        hindered_(!pricing_.tally(0).subfield().obstacles.empty()),
        list_(pricing_.width_m()),
        soft_list_(pricing_.width_m()) {}

  /// Bounds boxes only.
  ProvenBound prove(const KnownGrid& known) {
    known_ = known.cost;
    const double angle = known.direction.angle().radians();
    const GridTally tally = pricing_.tally(angle);
    const PositionBox itself{{angle, known.origin_m - pricing_.origin(tally, 0)}, 0, 0};
    reachable_ = pricing_.least(tally, itself, std::numeric_limits<double>::infinity());
    if (effort_.most_boxes > 0) branch();
    return {std::min(bound_, known.cost), boxes_};
  }

  BranchAndBoundResult run(const Rival& rival) {
    try_edges();
    if (effort_.scanned > 0) scan();
    if (!hindered_ || effort_.cut_too) polish(list_, false, effort_.polished);
    if (hindered_) polish(soft_list_, true, effort_.polished);
    if (rival) rival_ = rival(priced((hindered_ ? soft_list_ : list_).best()));
    if (effort_.most_boxes > 0) {
      branch();
      polish(list_, false, hindered_ ? effort_.polished : list_.list().size());
      if (hindered_) polish(soft_list_, true, effort_.polished);
    }
    BranchAndBoundResult out;
    out.bound = std::min(bound_, list_.best().cost);
    out.boxes = boxes_;
    for (const FoundGrid& found : list_.list()) out.grids.push_back(priced(found));
    if (hindered_)
      for (const FoundGrid& found : soft_list_.list()) out.unhindered.push_back(priced(found));
    if (effort_.exact_offset && !hindered_ && !context_.has_to_end()) refine(out.grids.front());
    return out;
  }

 private:
  PricedGrid priced(const FoundGrid& found) const { return pricing_.priced(found.position, found.cost); }
  void offer(const GridPosition& position, const GridPrices& prices) {
    list_.offer({position, prices.cut, prices.works});
    if (hindered_) soft_list_.offer({position, prices.soft, prices.works});
  }

  void try_edges() {
    const std::vector<GridPosition> flush =
        edge_aligned_grids(pricing_.part(), pricing_.bound().pivot, effort_.most_edges);
    const std::size_t count = effort_.edge_offsets;
    std::vector<GridPosition> positions(count * flush.size());
    std::vector<GridPrices> prices(positions.size());
    const std::vector<bool> made = for_each_index_until_end(flush.size(), context_, [&](std::size_t i) {
      const GridTally tally = pricing_.tally(flush[i].angle);
      const Box& reach = tally.subfield().reach;
      const double pivot = pricing_.origin(tally, 0);
      const double offsets[] = {flush[i].offset_m, reach.min_x - pivot, reach.max_x - pivot,
                                flush[i].offset_m + 0.5 * pricing_.width_m()};
      for (std::size_t k = 0; k < count; ++k) {
        positions[count * i + k] = {flush[i].angle, offsets[k]};
        prices[count * i + k] = pricing_.prices(tally, offsets[k]);
      }
    });
    for (std::size_t i = 0; i < positions.size(); ++i)
      if (made[i / count]) offer(positions[i], prices[i]);
  }

  /// Moves to better neighbours, and halves the steps where there is none.
  void polish(GridShortlist& shortlist, bool soft, std::size_t most) {
    if (most == 0 || context_.has_to_end()) return;
    std::vector<FoundGrid> found = shortlist.list();
    if (found.size() > most) found.resize(most);
    const double worth_it = found.front().cost + kNearBest * std::abs(found.front().cost);
    std::erase_if(found, [&](const FoundGrid& one) { return one.polished || one.cost > worth_it; });
    for_each_index(found.size(), context_,
                   [&](std::size_t i) { improve(found[i], soft, kFirstTurn, kCoarse); });
    // Coarse steps find out which minima are deep.
    std::stable_sort(found.begin(), found.end(), ranks_before);
    const bool finer = effort_.tolerance.radians() < kCoarse.radians();
    const std::size_t deep = finer ? std::min(found.size(), kFollowed) : 0;
    for_each_index(deep, context_, [&](std::size_t i) {
      improve(found[i], soft, kCoarse, effort_.tolerance);
      found[i].polished = true;
    });
    for (const FoundGrid& one : found) shortlist.offer(one);
  }

  /// Steps along either axis, and steps that keep a strip line on one point of the field: the cost jumps
  /// where a piece appears or vanishes, and the best grids lie along such jumps.
  std::array<GridPosition, 12> steps(double turn, double shift) const {
    const double reach = pricing_.radius_m();
    std::array<GridPosition, 12> out{GridPosition{turn, 0}, {-turn, 0}, {0, shift}, {0, -shift}};
    std::size_t i = 4;
    for (const double along : {-1.0, -0.5, 0.5, 1.0})
      for (const double sense : {turn, -turn}) out[i++] = {sense, sense * along * reach};
    return out;
  }

  /// Improves by steps that turn by less and less, from the first angle down to half the second.
  void improve(FoundGrid& best, bool soft, Angle from, Angle to) const {
    double turn = from.radians(), shift = pricing_.width_m() / 8 * (from.radians() / kFirstTurn.radians());
    while (turn > 0.5 * to.radians() && !context_.has_to_end()) {
      bool better = false;
      for (const GridPosition& step : steps(turn, shift)) {
        const GridPosition next{best.position.angle + step.angle, best.position.offset_m + step.offset_m};
        const GridPrices prices = pricing_.prices(next);
        const FoundGrid found{next, soft ? prices.soft : prices.cut, prices.works};
        if (!ranks_before(found, best)) continue;
        best = found;
        better = true;
      }
      if (better) continue;
      turn *= 0.5;
      shift *= 0.5;
    }
  }

  /// Bounds the box; prices the grid in its middle if the box may hold anything and is either one of the
  /// first or so small that its middle stands for it.
  std::optional<GridPrices> look(SearchBox& box, double target) const {
    const GridTally tally = pricing_.tally(box.middle.angle);
    box.bound = std::max(box.bound, pricing_.least(tally, box, target));
    if (known_) return std::nullopt;
    const bool between = box.half_offset_m > pricing_.width_m() / 15 && box.half_angle < kFirstHalfAngle;
    if (box.bound >= target || between) return std::nullopt;
    return pricing_.prices(tally, box.middle.offset_m);
  }

  void look_at_all(std::vector<SearchBox>& boxes) {
    std::vector<std::optional<GridPrices>> prices(boxes.size());
    const double target = this->target();
    for_each_index(boxes.size(), context_, [&](std::size_t i) { prices[i] = look(boxes[i], target); });
    boxes_ += static_cast<int>(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (prices[i]) offer(boxes[i].middle, *prices[i]);
      open_.push(boxes[i]);
    }
  }

  /// A box that cannot cost less holds nothing worth finding.
  double target() const {
    if (known_) {
      const double reachable = std::min(*known_, reachable_);
      return std::isfinite(reachable) ? reachable - effort_.gap * std::abs(reachable) : reachable;
    }
    const FoundGrid& best = list_.best();
    if (!best.works) return std::numeric_limits<double>::infinity();
    const double cheapest = std::min(best.cost, rival_);
    return cheapest - effort_.gap * std::abs(cheapest);
  }

  /// A net over all directions and offsets, so that small steps reach most minima.
  void scan() {
    constexpr std::size_t kOffsets = 5;
    const auto directions = static_cast<std::size_t>(effort_.scanned);
    std::vector<GridPosition> positions(kOffsets * directions);
    std::vector<GridPrices> prices(positions.size());
    const std::vector<bool> made = for_each_index_until_end(directions, context_, [&](std::size_t i) {
      const double angle = kHalfTurn * (static_cast<double>(i) + 0.5) / static_cast<double>(directions);
      const GridTally tally = pricing_.tally(angle);
      for (std::size_t k = 0; k < kOffsets; ++k) {
        // Staggered from one direction to the next.
        const double share =
            (static_cast<double>(k) + (i % 2 == 0 ? 0.0 : 0.5)) / static_cast<double>(kOffsets);
        positions[kOffsets * i + k] = {angle, share * pricing_.width_m()};
        prices[kOffsets * i + k] = pricing_.prices(tally, positions[kOffsets * i + k].offset_m);
      }
    });
    for (std::size_t i = 0; i < positions.size(); ++i)
      if (made[i / kOffsets]) offer(positions[i], prices[i]);
  }

  void branch() {
    if (context_.has_to_end()) return;
    const int first = static_cast<int>(std::lround(kHalfTurn / (2 * kFirstHalfAngle)));
    std::vector<SearchBox> boxes;
    for (int i = 0; i < first; ++i)
      boxes.push_back({{{(2 * i + 1) * kFirstHalfAngle, 0}, kFirstHalfAngle, 0.5 * pricing_.width_m()}, 0});
    look_at_all(boxes);
    bound_ = std::numeric_limits<double>::infinity();
    double at_last_look = open_.top().bound;
    int next_look = boxes_ + kLookEvery;
    while (!open_.empty() && open_.top().bound < target() && boxes_ < effort_.most_boxes &&
           !context_.has_to_end()) {
      if (boxes_ >= next_look) {
        if (!makes_headway(open_.top().bound - at_last_look)) break;
        at_last_look = open_.top().bound;
        next_look += kLookEvery;
      }
      boxes.clear();
      while (!open_.empty() && boxes.size() < 2 * kBatch && open_.top().bound < target()) {
        divide(open_.top(), boxes);
        open_.pop();
      }
      look_at_all(boxes);
    }
    if (!open_.empty()) bound_ = std::min(bound_, open_.top().bound);
  }

  /// Whether the bound has risen enough since the last check. It rises ever more slowly: where the remaining
  /// boxes would not close the gap even at twice the pace, the search stops.
  bool makes_headway(double closed) const {
    const double open_gap = target() - open_.top().bound;
    const double looks_left = static_cast<double>(effort_.most_boxes - boxes_) / kLookEvery;
    if (known_) return closed >= kLeastProgress * open_gap;
    return closed >= (hindered_ ? kLeastWhereHindered : kLeastProgress) * open_gap &&
           2 * closed * looks_left >= open_gap;
  }

  void divide(const SearchBox& box, std::vector<SearchBox>& out) {
    const double by_angle = box.half_angle * pricing_.radius_m();
    const double least_offset = kLeastShift * pricing_.width_m();
    const bool can_turn = by_angle > least_offset;
    if (!can_turn && box.half_offset_m <= least_offset) {
      bound_ = std::min(bound_, box.bound);
      return;
    }
    const bool turn = can_turn && (by_angle > box.half_offset_m || box.half_offset_m <= least_offset);
    SearchBox half = box;
    (turn ? half.half_angle : half.half_offset_m) *= 0.5;
    for (const int side : {-1, 1}) {
      SearchBox next = half;
      if (turn)
        next.middle.angle += side * half.half_angle;
      else
        next.middle.offset_m += side * half.half_offset_m;
      out.push_back(next);
    }
  }

  void refine(PricedGrid& grid) const {
    const GridTally tally = pricing_.tally(grid.direction.angle().radians());
    const PricedOrigin best =
        best_offset(tally, pricing_.bound(), {grid.origin_m, grid.cost}, near_enough(context_));
    grid.origin_m = best.origin_m;
    grid.cost = best.cost;
  }

  GridPricing pricing_;
  SearchEffort effort_;
  SearchContext context_;
  bool hindered_;
  double rival_ = std::numeric_limits<double>::infinity();
  double reachable_ = std::numeric_limits<double>::infinity();  ///< what bounds of the best known grid reach
  std::optional<double> known_;  ///< where nothing but the bound is wanted: the cost to compare with
  GridShortlist list_, soft_list_;
  std::priority_queue<SearchBox, std::vector<SearchBox>, LaterBox> open_;
  double bound_ = 0;
  int boxes_ = 0;
};

}  // namespace

BranchAndBoundResult branch_and_bound(const SearchTask& task, const Polygon& part, const SearchEffort& effort,
                                      const SearchContext& context, const Rival& rival) {
  return GridSearch(task, part, effort, context, NearObstacles::kNothing).run(rival);
}

ProvenBound bound_of_grids(const SearchTask& task, const Polygon& part, const SearchEffort& effort,
                           const SearchContext& context, const KnownGrid& known) {
  return GridSearch(task, part, effort, context, NearObstacles::kCharged).prove(known);
}

}  // namespace tramline
