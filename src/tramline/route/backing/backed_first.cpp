#include "tramline/route/backing/backed_first.h"

#include <algorithm>
#include <vector>

namespace tramline {
namespace {

/// Distances backed, m, and the least that ways take which back by one of them, s.
struct Backed {
  double from_m = 0, to_m = 0, at_least_s = 0;
};

}  // namespace

double least_backed_first_s(const BackingTerms& terms, const LineExit& exit, const LeastOnFrom& on_s) {
  const double reverse_mps = terms.turning.reverse_speed_mps, forward_mps = terms.turning.turning_speed_mps;
  const double at_once_s = on_s(exit.pose), all_along_s = on_s(backed(exit, exit.length_m));
  double found_s = std::min(at_once_s, exit.length_m / reverse_mps + all_along_s);
  const auto part = [&](double from_m, double to_m) {
    const double there_s = on_s(backed(exit, to_m));
    found_s = std::min(found_s, to_m / reverse_mps + there_s);
    return Backed{from_m, to_m, from_m / reverse_mps + there_s - (to_m - from_m) / forward_mps};
  };
  // Farther back than the line is followed it goes on in reverse, and needs no other stop for that.
  double least_s = exit.length_m / reverse_mps + std::max(0.0, all_along_s - terms.stop_s);
  std::vector<Backed> open{part(0, std::min(exit.length_m, found_s * reverse_mps))};
  while (!open.empty()) {
    const Backed all = open.back();
    open.pop_back();
    if (all.at_least_s >= found_s - less_by_dividing_s(found_s)) continue;
    if (all.to_m - all.from_m < kLeastDivided_m) {
      least_s = std::min(least_s, all.at_least_s);
      continue;
    }
    const double middle_m = 0.5 * (all.from_m + all.to_m);
    open.push_back(part(middle_m, all.to_m));
    open.push_back(part(all.from_m, middle_m));
  }
  return terms.stop_s + std::min(least_s, std::max(0.0, found_s - less_by_dividing_s(found_s)));
}

}  // namespace tramline
