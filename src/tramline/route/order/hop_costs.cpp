#include "tramline/route/order/hop_costs.h"

#include <algorithm>
#include <cstdlib>

namespace tramline::order {

HopCosts::HopCosts(const std::vector<WorkedLine>& lines, const HopGround& ground) : ground_(ground) {
  for (const WorkedLine& line : lines) {
    ends_.push_back(line.front().start);
    ends_.push_back(line.back().end);
    tracks_.push_back({line.front().subfield, line.front().track});
  }
}

const Hop& HopCosts::hop(End a, End b) {
  if (b < a) std::swap(a, b);
  const auto [found, unknown] = known_.try_emplace(std::uint64_t{a} * ends_.size() + b);
  if (unknown) found->second = ground_.hop(ends_[a], ends_[b]);
  return found->second;
}

double HopCosts::least(End a, End b) const {
  const TrackNumber &from = tracks_[line_of(a)], &to = tracks_[line_of(b)];
  const bool beside = from.subfield == to.subfield && std::abs(from.track - to.track) == 1;
  return distance_m(a, b) + (beside ? 0 : prices_.leaving_m);
}

double HopCosts::cost(End a, End b) {
  const double least_m = least(a, b);
  if (!prices_.way_round) return least_m;
  const Hop& known = hop(a, b);
  return least_m + (known.way_round_m - known.length_m) + (known.barred ? prices_.barred_m : 0);
}

double cost(const Tour& tour, HopCosts& costs) {
  double out = 0;
  for (std::size_t i = 1; i < tour.size(); ++i) out += costs.cost(other_end(tour[i - 1]), tour[i]);
  return out;
}

double length_m(const Tour& tour, const HopCosts& costs) {
  double out = 0;
  for (std::size_t i = 1; i < tour.size(); ++i) out += costs.distance_m(other_end(tour[i - 1]), tour[i]);
  return out;
}

int barred_hops(const Tour& tour, HopCosts& costs) {
  int out = 0;
  for (std::size_t i = 1; i < tour.size(); ++i) out += costs.barred(other_end(tour[i - 1]), tour[i]) ? 1 : 0;
  return out;
}

}  // namespace tramline::order
