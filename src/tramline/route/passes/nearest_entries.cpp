#include "tramline/route/passes/nearest_entries.h"

#include <cassert>

namespace tramline {
namespace {

/// Slightly less than the straight line takes: no more than the bound in spite of rounding.
double crude_s(const Pose& left, const EntryChoice& choice, const LeastSeconds& least) {
  constexpr double kLess = 1 - 1e-9;
  return kLess * least.crude(left, choice.entry->entered);
}

}  // namespace

NearestEntries::NearestEntries(const Pose& left, const LeastSeconds& least, std::vector<EntryChoice> all,
                               Ahead ahead)
    : left_(left), least_(&least), all_(std::move(all)), ahead_(std::move(ahead)) {
  std::vector<Timed> waiting;
  waiting.reserve(all_.size());
  for (std::size_t i = 0; i < all_.size(); ++i) waiting.emplace_back(crude_s(left_, all_[i], *least_), i);
  waiting_ = Soonest({}, std::move(waiting));
}

const EntryChoice& NearestEntries::at(std::size_t rank) {
  assert(rank < size());
  while (ranked_.size() <= rank) add_next();
  return all_[ranked_[rank]];
}

void NearestEntries::add_next() {
  while (!waiting_.empty() && (measured_.empty() || waiting_.top().first <= measured_.top().first)) {
    const std::size_t i = waiting_.top().second;
    waiting_.pop();
    all_[i].least_s = least_->forward(left_, all_[i].entry->entered) + (ahead_ ? ahead_(i) : 0);
    measured_.push({all_[i].least_s, i});
  }
  ranked_.push_back(measured_.top().second);
  measured_.pop();
}

}  // namespace tramline
