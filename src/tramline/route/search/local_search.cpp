#include "tramline/route/search/local_search.h"

#include <algorithm>

#include "tramline/route/search/three_opt.h"
#include "tramline/route/search/two_opt.h"
#include "tramline/route/tolerances.h"

namespace tramline::order {
namespace {

/// Ends tried for the third connection of a move.
constexpr std::size_t kThirdEnds = 6;

}  // namespace

LocalSearch::LocalSearch(ClosedTour& tour, const Neighbours& neighbours)
    : tour_(tour), near_(neighbours.size()), waits_(tour.lines(), false) {
  for (End end = 0; end < near_.size(); ++end) {
    for (const End near : neighbours[end]) near_[end].push_back({near, tour_.between(end, near)});
    for (const End outside : {tour_.start(), tour_.finish()})
      if (line_of(end) != line_of(outside)) near_[end].push_back({outside, tour_.between(end, outside)});
    std::stable_sort(near_[end].begin(), near_[end].end(),
                     [](const NearEnd& x, const NearEnd& y) { return x.cost_s < y.cost_s; });
  }
}

void LocalSearch::wait(End end) {
  if (waits_[line_of(end)]) return;
  waits_[line_of(end)] = true;
  waiting_.push_back(line_of(end));
}

double LocalSearch::run() {
  double gained = 0;
  for (std::size_t next = 0; next < waiting_.size(); ++next) {
    const std::size_t line = waiting_[next];
    waits_[line] = false;
    for (const End end : {2 * line, 2 * line + 1})
      while (const double gain = improve_at(end)) gained += gain;
  }
  waiting_.clear();
  return gained;
}

/// The best move that takes away the connection of the end and connects it with one near it. Its gain, s; 0
/// if none gains.
double LocalSearch::improve_at(End end) {
  best_ = {};
  best_.gain = kSameTime_s;
  const End a = tour_.mate(end);
  for (const NearEnd& near : near_[end]) {
    const double ahead_s = tour_.mate_s(end) - near.cost_s;
    if (ahead_s <= kSameTime_s) break;
    if (near.end != a) look_past(a, near.end, ahead_s + tour_.mate_s(near.end));
  }
  if (best_.gain <= kSameTime_s) return 0;
  const std::size_t changes = tour_.changes();
  if (best_.three)
    ThreeOpt(tour_, best_.a, best_.b, best_.c).apply(tour_);
  else
    TwoOpt(tour_, best_.a, best_.b).apply(tour_);
  for (const End changed : tour_.changed_since(changes)) wait(changed);
  return best_.gain;
}

/// Moves that take away the connections of a and b and connect the mate of a with b; so far they are ahead,
/// the connection of b counted.
void LocalSearch::look_past(End a, End b, double ahead_s) {
  const End mate_of_a = tour_.mate(a), mate_of_b = tour_.mate(b);
  if (tour_.may_exchange(mate_of_a, b)) {
    const double gain = ahead_s - tour_.between(a, mate_of_b);
    if (gain > best_.gain) best_ = {gain, mate_of_a, b, 0, false};
  }
  const std::vector<NearEnd>& near = near_[mate_of_b];
  for (std::size_t i = 0; i < std::min(near.size(), kThirdEnds); ++i) {
    const End c = near[i].end;
    const double further_s = ahead_s - near[i].cost_s;
    if (further_s <= kSameTime_s) break;
    const double most = further_s + tour_.mate_s(c);
    if (most <= best_.gain) continue;
    look_past(a, b, c, most);
  }
}

void LocalSearch::look_past(End a, End b, End c, double ahead_s) {
  const double gain = ahead_s - tour_.between(a, tour_.mate(c));
  if (gain > best_.gain && ThreeOpt(tour_, a, b, c).is_valid()) best_ = {gain, a, b, c, true};
}

}  // namespace tramline::order
