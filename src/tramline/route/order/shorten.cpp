#include "tramline/route/order/shorten.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "tramline/route/order/point_grid.h"
#include "tramline/route/tolerances.h"

namespace tramline::order {
namespace {

constexpr std::size_t kNear = 10;  ///< ends looked at from each end
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// Ways of putting two neighbouring parts A and B of a tour back between what comes before and after.
enum class Exchange { kTurnedTogether, kTurnedEach, kSwapped, kSwappedFirstTurned, kSwappedSecondTurned };

/// Hops are numbered by the position of the stretch they lead to: hop p comes before the stretch at position
/// p, hop 0 before the first and hop n after the last; these two cost nothing.
struct Move {
  std::size_t p = 0, q = 0, r = 0;  ///< A is in the places p … q − 1, B in q … r − 1
  Exchange exchange = Exchange::kTurnedTogether;
  double gain = 0;
};

/// The two ends that a new hop joins; kNone: the beginning or the end of the tour.
struct Join {
  std::size_t from = kNone, to = kNone;
};

class Shortening {
 public:
  Shortening(StretchTour& tour, const std::vector<Stretch>& stretches, const NearEnds& near, HopCosts& costs)
      : tour_(tour),
        stretches_(stretches),
        near_(near),
        costs_(costs),
        place_(tour.size()),
        hop_m_(tour.size() + 1, 0) {
    for (std::size_t p = 0; p < tour_.size(); ++p) place_[tour_[p] / 2] = p;
    for (std::size_t p = 1; p < tour_.size(); ++p) hop_m_[p] = cost({before(p), after(p)});
  }

  void run() {
    // Exchanges end by themselves, since each gains; the bound keeps the effort fixed.
    std::size_t left = 40 * tour_.size() + 1000;
    std::vector<std::size_t> waiting(tour_.size());
    std::vector<bool> waits(tour_.size(), true);
    for (std::size_t p = 0; p < tour_.size(); ++p) waiting[p] = tour_[p] / 2;
    for (std::size_t next = 0; next < waiting.size() && left > 0; ++next, --left) {
      const std::size_t stretch = waiting[next];
      waits[stretch] = false;
      while (const std::optional<Move> move = best_about(stretch)) {
        apply(*move);
        for (const std::size_t hop : {move->p, move->q, move->r})
          for (const std::size_t end : {before(hop), after(hop)})
            if (end != kNone && !waits[end / 2]) {
              waits[end / 2] = true;
              waiting.push_back(end / 2);
            }
      }
    }
  }

 private:
  End line_end(std::size_t end) const { return stretches_[end / 2].ends[end % 2]; }
  std::size_t before(std::size_t hop) const { return hop == 0 ? kNone : tour_[hop - 1] ^ 1U; }
  std::size_t after(std::size_t hop) const { return hop == tour_.size() ? kNone : tour_[hop]; }
  std::size_t hop_of(std::size_t end) const {
    const std::size_t p = place_[end / 2];
    return tour_[p] == end ? p : p + 1;
  }

  double least(Join join) const {
    return join.from == kNone || join.to == kNone ? 0 : costs_.least(line_end(join.from), line_end(join.to));
  }
  double cost(Join join) {
    return join.from == kNone || join.to == kNone ? 0 : costs_.cost(line_end(join.from), line_end(join.to));
  }

  /// The best exchange of a hop to or from the stretch.
  std::optional<Move> best_about(std::size_t stretch) {
    best_ = {};
    best_.gain = kLeastGain_m;
    const std::size_t p = place_[stretch];
    for (const std::size_t hop : {p, p + 1}) look_at(hop);
    if (best_.gain <= kLeastGain_m) return std::nullopt;
    return best_;
  }

  /// Exchanges that begin by joining one end of the hop to an end near by, and stay ahead so far.
  void look_at(std::size_t hop) {
    for (const std::size_t end : {before(hop), after(hop)}) {
      if (end == kNone) continue;
      for (const std::size_t other : near_[end]) {
        const double ahead = hop_m_[hop] - least({end, other});
        if (ahead <= kLeastGain_m) continue;
        const std::size_t second = hop_of(other);
        if (second == hop) continue;
        try_two(hop, second);
        look_further(hop, second, before(second) == other ? after(second) : before(second),
                     ahead + hop_m_[second]);
      }
    }
    for (const std::size_t outer : {std::size_t{0}, tour_.size()}) {
      if (outer == hop) continue;
      try_two(hop, outer);
      for (const std::size_t end : {before(hop), after(hop)}) look_further(hop, outer, end, hop_m_[hop]);
    }
  }

  void look_further(std::size_t hop, std::size_t second, std::size_t end, double ahead) {
    for (const std::size_t outer : {std::size_t{0}, tour_.size()}) try_three(hop, second, outer);
    if (end == kNone) return;
    for (const std::size_t other : near_[end])
      if (least({end, other}) < ahead - kLeastGain_m) try_three(hop, second, hop_of(other));
  }

  void try_two(std::size_t p, std::size_t r) {
    if (p > r) std::swap(p, r);
    try_joins({p, p, r, Exchange::kTurnedTogether, hop_m_[p] + hop_m_[r]},
              {Join{before(p), before(r)}, Join{after(p), after(r)}, Join{}});
  }

  void try_three(std::size_t one, std::size_t two, std::size_t three) {
    std::array<std::size_t, 3> hops{one, two, three};
    std::sort(hops.begin(), hops.end());
    const auto [p, q, r] = hops;
    if (p == q || q == r) return;
    const double old = hop_m_[p] + hop_m_[q] + hop_m_[r];
    const std::size_t a = after(p), a_end = before(q), b = after(q), b_end = before(r);
    const std::size_t from = before(p), to = after(r);
    try_joins({p, q, r, Exchange::kTurnedEach, old}, {Join{from, a_end}, Join{a, b_end}, Join{b, to}});
    try_joins({p, q, r, Exchange::kSwapped, old}, {Join{from, b}, Join{b_end, a}, Join{a_end, to}});
    try_joins({p, q, r, Exchange::kSwappedFirstTurned, old},
              {Join{from, b}, Join{b_end, a_end}, Join{a, to}});
    try_joins({p, q, r, Exchange::kSwappedSecondTurned, old},
              {Join{from, b_end}, Join{b, a}, Join{a_end, to}});
  }

  /// `move.gain` is the cost of the old hops.
  void try_joins(Move move, const std::array<Join, 3>& joins) {
    double gain = move.gain;
    for (const Join& join : joins) gain -= least(join);
    // The exact costs of new hops are computed last, and only as many as are needed to decide.
    for (const Join& join : joins) {
      if (gain <= best_.gain) return;
      gain -= cost(join) - least(join);
    }
    if (gain <= best_.gain) return;
    move.gain = gain;
    best_ = move;
  }

  void apply(const Move& move) {
    const auto at = [this](std::size_t p) { return tour_.begin() + static_cast<std::ptrdiff_t>(p); };
    StretchTour first(at(move.p), at(move.q)), second(at(move.q), at(move.r));
    const auto turn = [](StretchTour& part) {
      std::reverse(part.begin(), part.end());
      for (std::size_t& entered : part) entered ^= 1U;
    };
    if (move.exchange == Exchange::kTurnedEach || move.exchange == Exchange::kSwappedFirstTurned) turn(first);
    if (move.exchange != Exchange::kSwapped && move.exchange != Exchange::kSwappedFirstTurned) turn(second);
    if (move.exchange != Exchange::kTurnedTogether && move.exchange != Exchange::kTurnedEach)
      std::swap(first, second);
    std::copy(second.begin(), second.end(), std::copy(first.begin(), first.end(), at(move.p)));
    for (std::size_t p = move.p; p < move.r; ++p) place_[tour_[p] / 2] = p;
    for (std::size_t p = move.p; p <= move.r; ++p) hop_m_[p] = cost({before(p), after(p)});
  }

  StretchTour& tour_;
  const std::vector<Stretch>& stretches_;
  const NearEnds& near_;
  HopCosts& costs_;
  std::vector<std::size_t> place_;  ///< in the tour, by stretch
  std::vector<double> hop_m_;       ///< by hop
  Move best_;
};

}  // namespace

NearEnds near_ends(const std::vector<Stretch>& stretches, const HopCosts& costs) {
  std::vector<Point> points;
  for (const Stretch& stretch : stretches)
    for (const End end : stretch.ends) points.push_back(costs.at(end));
  const PointGrid grid(points);
  NearEnds out(points.size());
  for (std::size_t end = 0; end < points.size(); ++end)
    for (const std::size_t other : grid.nearest(points[end], kNear + 2))
      if (other / 2 != end / 2) out[end].push_back(other);
  return out;
}

void shorten(StretchTour& tour, const std::vector<Stretch>& stretches, const NearEnds& near,
             HopCosts& costs) {
  if (tour.size() > 1) Shortening(tour, stretches, near, costs).run();
}

}  // namespace tramline::order
