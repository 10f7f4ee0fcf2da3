#include "tramline/route/search/first_tours.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>

namespace tramline::order {
namespace {

struct CheapPair {
  double cost = 0;
  End a = 0, b = 0;
  friend bool operator<(const CheapPair& x, const CheapPair& y) {
    return std::tie(x.cost, x.a, x.b) < std::tie(y.cost, y.a, y.b);
  }
};

std::vector<CheapPair> near_pairs(const EndCosts& costs, const Neighbours& neighbours) {
  std::vector<CheapPair> out;
  for (End a = 0; a < neighbours.size(); ++a)
    for (const End b : neighbours[a]) {
      const std::vector<End>& back = neighbours[b];
      if (a < b || std::find(back.begin(), back.end(), a) == back.end())
        out.push_back({costs.between(a, b), std::min(a, b), std::max(a, b)});
    }
  std::sort(out.begin(), out.end());
  return out;
}

/// Pieces of a tour that grow together.
class TourPieces {
 public:
  explicit TourPieces(std::size_t lines) : mate_(2 * lines), far_end_(2 * lines) {
    for (End end = 0; end < far_end_.size(); ++end) far_end_[end] = other_end(end);
  }

  /// Connects two loose ends of different pieces; otherwise nothing.
  void join(End a, End b) {
    if (mate_[a] || mate_[b] || far_end_[a] == b) return;
    mate_[a] = b;
    mate_[b] = a;
    const End from = far_end_[a], to = far_end_[b];
    far_end_[from] = to;
    far_end_[to] = from;
  }

  bool loose(End end) const { return !mate_[end]; }
  /// The other loose end of the piece that this loose end belongs to.
  End far_end(End end) const { return far_end_[end]; }
  /// Drives the piece from a loose end on.
  void drive(End entered, Tour& tour) const {
    for (std::optional<End> end = entered; end; end = mate_[other_end(*end)]) tour.push_back(*end);
  }

 private:
  std::vector<std::optional<End>> mate_;
  std::vector<End> far_end_;  ///< of loose ends
};

/// Costs and the prices of the ends besides.
class PricedCosts final : public EndCosts {
 public:
  PricedCosts(const EndCosts& costs, const std::vector<double>& prices_s)
      : costs_(costs), prices_s_(prices_s) {}

  std::size_t lines() const override { return costs_.lines(); }
  double between(End a, End b) const override { return costs_.between(a, b) + prices_s_[a] + prices_s_[b]; }
  double at_start(End entered) const override { return costs_.at_start(entered) + prices_s_[entered]; }
  double at_finish(End left) const override { return costs_.at_finish(left) + prices_s_[left]; }

 private:
  const EndCosts& costs_;
  const std::vector<double>& prices_s_;
};

/// The loose end at which the next piece is entered most cheaply; `last`: the end that was left, if any.
End cheapest_entry(const std::vector<End>& loose, std::optional<End> last, const EndCosts& costs) {
  End best = loose.front();
  double least = std::numeric_limits<double>::max();
  for (const End end : loose) {
    const double cost = last ? costs.between(*last, end) : costs.at_start(end);
    if (cost >= least) continue;
    least = cost;
    best = end;
  }
  return best;
}

}  // namespace

Tour greedy_tour(const EndCosts& costs, const Neighbours& neighbours) {
  assert(neighbours.size() == 2 * costs.lines());
  TourPieces pieces(costs.lines());
  for (const CheapPair& pair : near_pairs(costs, neighbours)) pieces.join(pair.a, pair.b);
  std::vector<End> loose;
  for (End end = 0; end < neighbours.size(); ++end)
    if (pieces.loose(end)) loose.push_back(end);
  Tour out;
  std::optional<End> last;
  while (!loose.empty()) {
    const End entered = cheapest_entry(loose, last, costs);
    pieces.drive(entered, out);
    last = pieces.far_end(entered);
    std::erase(loose, entered);
    std::erase(loose, *last);
  }
  return out;
}

Tour greedy_tour(const EndCosts& costs, const Neighbours& neighbours, const std::vector<double>& prices_s) {
  assert(prices_s.size() >= 2 * costs.lines());
  return greedy_tour(PricedCosts(costs, prices_s), neighbours);
}

Tour entered_best(const std::vector<std::size_t>& order, const EndCosts& costs) {
  assert(order.size() == costs.lines());
  if (order.empty()) return {};
  // By line in this order and side at which it is entered: the cost up to there, and the side of the one
  // before.
  std::array<double, 2> cost{costs.at_start(2 * order[0]), costs.at_start(2 * order[0] + 1)};
  std::vector<std::array<std::size_t, 2>> before(order.size());
  for (std::size_t i = 1; i < order.size(); ++i) {
    const std::array<double, 2> was = cost;
    for (std::size_t side = 0; side < 2; ++side) {
      const End entered = 2 * order[i] + side;
      const double after_start = was[0] + costs.between(2 * order[i - 1] + 1, entered);
      const double after_end = was[1] + costs.between(2 * order[i - 1], entered);
      before[i][side] = after_start <= after_end ? 0 : 1;
      cost[side] = std::min(after_start, after_end);
    }
  }
  const End last = 2 * order.back();
  std::size_t side = cost[0] + costs.at_finish(last + 1) <= cost[1] + costs.at_finish(last) ? 0 : 1;
  Tour out(order.size());
  for (std::size_t i = order.size(); i-- > 0; side = before[i][side]) out[i] = 2 * order[i] + side;
  return out;
}

}  // namespace tramline::order
