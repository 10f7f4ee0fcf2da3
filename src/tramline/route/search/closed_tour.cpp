#include "tramline/route/search/closed_tour.h"

#include <cassert>

namespace tramline::order {

ClosedTour::ClosedTour(const Tour& tour, ClosedCosts& costs)
    : costs_(costs),
      entered_(tour),
      place_(costs.lines()),
      mate_(2 * costs.lines()),
      mate_s_(2 * costs.lines()) {
  assert(tour.size() + 1 == costs.lines());
  entered_.push_back(costs_.finish());
  for (std::size_t at = 0; at < lines(); ++at) place_[line_of(entered_[at])] = at;
  for (std::size_t at = 0; at < lines(); ++at) connect(left(at), entered(next(at)));
}

void ClosedTour::connect(End a, End b) {
  const double cost = lines() > 1 ? between(a, b) : 0;
  mate_[a] = b;
  mate_[b] = a;
  mate_s_[a] = mate_s_[b] = cost;
}

void ClosedTour::exchange(End a, End b) {
  assert(may_exchange(a, b));
  changes_.push_back({a, b, mate(a), mate(b)});
  change(a, b);
}

void ClosedTour::undo_to(std::size_t changes) {
  while (changes_.size() > changes) {
    // What is now connected is a with b, and their former mates.
    change(changes_.back().a, changes_.back().mate_of_a);
    changes_.pop_back();
  }
}

std::vector<End> ClosedTour::changed_since(std::size_t change) const {
  std::vector<End> out;
  for (; change < changes_.size(); ++change) {
    const Change& done = changes_[change];
    out.insert(out.end(), {done.a, done.b, done.mate_of_a, done.mate_of_b});
  }
  return out;
}

void ClosedTour::change(End a, End b) {
  const End mate_of_a = mate(a), mate_of_b = mate(b);
  if (is_left(a))
    turn(next(place(a)), place(b));
  else
    turn(place(a), previous(place(b)));
  connect(a, b);
  connect(mate_of_a, mate_of_b);
}

/// Turns the run of lines from the first place to the last round, or all others, whichever are fewer: the
/// ring is the same.
void ClosedTour::turn(std::size_t first, std::size_t last) {
  std::size_t count = (last + lines() - first) % lines() + 1;
  if (2 * count > lines()) {
    const std::size_t was_first = first;
    first = next(last);
    last = previous(was_first);
    count = lines() - count;
  }
  const auto put = [this](std::size_t at, End end) {
    entered_[at] = end;
    place_[line_of(end)] = at;
  };
  for (; count > 1; count -= 2) {
    const End from_first = left(first), from_last = left(last);
    put(first, from_last);
    put(last, from_first);
    first = next(first);
    last = previous(last);
  }
  if (count == 1) put(first, left(first));
}

Tour ClosedTour::open() const {
  const std::size_t outside = place(start());
  const bool forward = is_left(start());
  Tour out;
  for (std::size_t at = outside; out.size() + 1 < lines();) {
    at = forward ? next(at) : previous(at);
    out.push_back(forward ? entered(at) : left(at));
  }
  return out;
}

}  // namespace tramline::order
