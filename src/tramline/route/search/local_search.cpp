#include "tramline/route/search/local_search.h"

#include <algorithm>

#include "tramline/route/search/three_opt.h"
#include "tramline/route/search/two_opt.h"
#include "tramline/route/tolerances.h"

namespace tramline::order {
namespace {

/// Moves made one after the other, of which only all together gain.
constexpr int kMostMoves = 2;
/// Ends tried for the third connection of a move.
constexpr std::size_t kThirdEnds = 4;

}  // namespace

LocalSearch::LocalSearch(ClosedTour& tour, const Neighbours& neighbours)
    : tour_(tour), near_(neighbours.size()), waits_(tour.lines(), false) {
  for (End end = 0; end < near_.size(); ++end) {
    near_[end].reserve(neighbours[end].size() + 2);
    for (const End near : neighbours[end]) add_near(end, near);
    for (const End outside : {tour_.start(), tour_.finish()})
      if (line_of(end) != line_of(outside)) add_near(end, outside);
  }
}

/// Behind those that cost no more.
void LocalSearch::add_near(End end, End near) {
  const NearEnd added{near, tour_.between(end, near)};
  const auto place = std::ranges::upper_bound(near_[end], added.cost_s, {}, &NearEnd::cost_s);
  near_[end].insert(place, added);
}

void LocalSearch::wait(End end) {
  if (waits_[line_of(end)]) return;
  waits_[line_of(end)] = true;
  waiting_.push_back(line_of(end));
}

double LocalSearch::run() {
  double gained = 0;
  std::size_t next = 0;
  while (next < waiting_.size()) {
    const std::size_t line = waiting_[next++];
    waits_[line] = false;
    for (const End end : {2 * line, 2 * line + 1})
      while (const double gain = improve_at(end)) gained += gain;
  }
  waiting_.clear();
  return gained;
}

/// The best move that takes away the connection of the end and connects it with one near it; where none
/// gains, the one that is farthest ahead is made and followed by another (Lin and Kernighan 1973). Its gain,
/// s; 0 if none gains: then the tour is what it was.
double LocalSearch::improve_at(End end) {
  const std::size_t changes = tour_.changes();
  const End a = tour_.mate(end);
  double ahead_s = tour_.mate_s(end);
  for (int moves = 0; moves < kMostMoves; ++moves) {
    best_ = {kSameTime_s};
    farthest_ = {kSameTime_s};
    look_from(a, ahead_s);
    if (best_.rate_s > kSameTime_s) {
      apply(best_);
      for (const End changed : tour_.changed_since(changes)) wait(changed);
      return best_.rate_s;
    }
    if (farthest_.rate_s <= kSameTime_s) break;
    apply(farthest_);
    ahead_s = farthest_.rate_s;
  }
  tour_.undo_to(changes);
  return 0;
}

void LocalSearch::apply(const RatedMove& move) {
  if (move.c)
    ThreeOpt(tour_, move.a, move.b, *move.c).apply(tour_);
  else
    TwoOpt(tour_, tour_.mate(move.a), move.b).apply(tour_);
}

/// Moves that take away the connection of a. Of what was taken away and added before, that one counted,
/// `ahead_s` remains.
void LocalSearch::look_from(End a, double ahead_s) {
  for (const NearEnd& near : near_[tour_.mate(a)]) {
    if (ahead_s - near.cost_s <= kSameTime_s) break;
    if (near.end != a) look_past(a, near.end, ahead_s - near.cost_s + tour_.mate_s(near.end));
  }
}

/// Moves that take away the connections of a and b and connect the mate of a with b.
void LocalSearch::look_past(End a, End b, double ahead_s) {
  const End mate_of_b = tour_.mate(b);
  if (tour_.may_exchange(tour_.mate(a), b)) {
    const double gain = ahead_s - tour_.between(a, mate_of_b);
    if (gain > best_.rate_s) best_ = {gain, a, b, {}};
  }
  const std::vector<NearEnd>& near = near_[mate_of_b];
  for (std::size_t i = 0; i < std::min(near.size(), kThirdEnds); ++i) {
    if (ahead_s - near[i].cost_s <= kSameTime_s) break;
    look_past(a, b, near[i].end, ahead_s - near[i].cost_s + tour_.mate_s(near[i].end));
  }
}

void LocalSearch::look_past(End a, End b, End c, double ahead_s) {
  if (ahead_s <= std::min(best_.rate_s, farthest_.rate_s)) return;
  if (line_of(a) == line_of(tour_.mate(c))) return;  // a line has no connection with itself
  const double gain = ahead_s - tour_.between(a, tour_.mate(c));
  if (gain <= best_.rate_s && ahead_s <= farthest_.rate_s) return;
  if (!ThreeOpt(tour_, a, b, c).is_valid()) return;
  if (gain > best_.rate_s) best_ = {gain, a, b, c};
  if (ahead_s > farthest_.rate_s) farthest_ = {ahead_s, a, b, c};
}

}  // namespace tramline::order
