#include "tramline/planner/search/grid_shortlist.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tramline {
namespace {

constexpr std::size_t kKept = 12;

}  // namespace

bool ranks_before(const FoundGrid& a, const FoundGrid& b) {
  return a.works != b.works ? a.works : a.cost < b.cost;
}

void GridShortlist::offer(const FoundGrid& found) {
  for (std::size_t i = 0; i < list_.size(); ++i) {
    if (!alike(list_[i].position, found.position)) continue;
    if (ranks_before(list_[i], found) || (!ranks_before(found, list_[i]) && !found.polished)) return;
    list_.erase(list_.begin() + static_cast<std::ptrdiff_t>(i));
    break;
  }
  const auto at = std::upper_bound(list_.begin(), list_.end(), found, ranks_before);
  list_.insert(at, found);
  if (list_.size() > kKept) list_.pop_back();
}

bool GridShortlist::alike(const GridPosition& a, const GridPosition& b) const {
  const double turn = std::abs(std::remainder(a.angle - b.angle, std::numbers::pi));
  const double shift = std::abs(std::remainder(a.offset_m - b.offset_m, width_m_));
  return turn < Angle::degrees(0.5).radians() && shift < width_m_ / 8;
}

}  // namespace tramline
