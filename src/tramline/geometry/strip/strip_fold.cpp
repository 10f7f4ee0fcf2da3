#include "tramline/geometry/strip/strip_fold.h"

#include <algorithm>

namespace tramline {
namespace {

double along_at(Point a, Point b, double across) {
  if (across == a.x) return a.y;
  if (across == b.x) return b.y;
  const double y = a.y + (b.y - a.y) * ((across - a.x) / (b.x - a.x));
  return std::clamp(y, std::min(a.y, b.y), std::max(a.y, b.y));
}

constexpr auto kEarlier = [](const auto& a, const auto& b) { return a.along < b.along; };

}  // namespace

double StripFold::EdgePart::across_at(double along) const {
  if (along == bottom) return x_bottom;
  if (along == top) return x_top;
  return x_bottom + (x_top - x_bottom) * ((along - bottom) / (top - bottom));
}

void StripFold::fold(std::span<const Ring> rings, const StripGrid& grid, StripRange range,
                     const StripMask& wanted) {
  begin(grid, range, wanted);
  for (const Ring& ring : rings) add_ring(ring, grid, range);
  end();
}

void StripFold::fold(std::span<const Polygon> turned, const StripGrid& grid, StripRange range,
                     const StripMask& wanted) {
  begin(grid, range, wanted);
  for (const Polygon& part : turned) {
    add_ring(part.outer, grid, range);
    for (const Ring& hole : part.holes) add_ring(hole, grid, range);
  }
  end();
}

void StripFold::begin(const StripGrid& grid, StripRange range, const StripMask& wanted) {
  width_m_ = grid.width_m;
  const int strips = range.size();
  parts_.clear(static_cast<std::size_t>(strips));
  right_lines_.clear(static_cast<std::size_t>(strips));
  centre_lines_.clear(static_cast<std::size_t>(strips));
  next_wanted_.resize(static_cast<std::size_t>(strips) + 1);
  next_wanted_.back() = strips;
  for (int i = strips - 1; i >= 0; --i) {
    const auto index = static_cast<std::size_t>(i);
    next_wanted_[index] = wanted.empty() || wanted[index] ? i : next_wanted_[index + 1];
  }
}

void StripFold::add_ring(const Ring& ring, const StripGrid& grid, StripRange range) {
  if (ring.empty()) return;
  const Corner first{ring.front(), grid.strip_at(ring.front().x)};
  Corner a = first;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const Corner b{ring[i], grid.strip_at(ring[i].x)};
    add(a, b, grid, range);
    a = b;
  }
  add(a, first, grid, range);
}

void StripFold::end() {
  parts_.sort_in();
  right_lines_.sort_in();
  centre_lines_.sort_in();
}

const StripProfile& StripFold::profile(std::size_t index) {
  find_slabs(parts_.in(index), right_lines_.in(index));
  find_centre_line(centre_lines_.in(index));
  return profile_;
}

/// Points on a line count as right of it, so a strip owns [line(k), line(k + 1)).
void StripFold::add(const Corner& a, const Corner& b, const StripGrid& grid, StripRange range) {
  const bool rightward = a.at.x < b.at.x;
  const Point left = rightward ? a.at : b.at, right = rightward ? b.at : a.at;
  const int k_left = rightward ? a.strip : b.strip, k_right = rightward ? b.strip : a.strip;
  const int last = std::min(k_right, range.last) - range.first;
  const int first = std::max(k_left, range.first) - range.first;
  if (first > last) return;
  for (int i = next_wanted_[static_cast<std::size_t>(first)]; i <= last;
       i = next_wanted_[static_cast<std::size_t>(i) + 1]) {
    const auto index = static_cast<std::size_t>(i);
    const int k = range.first + i;
    const double line = grid.line(k), next_line = grid.line(k + 1);
    const Point from = k == k_left ? left : Point{line, along_at(left, right, line)};
    const Point to = k == k_right ? right : Point{next_line, along_at(left, right, next_line)};
    const int change = rightward ? +1 : -1;
    if (k < k_right) right_lines_.add(index, {to.y, change});
    const double centre = grid.centre(k);
    if (left.x < centre && right.x >= centre)
      centre_lines_.add(index, {along_at(left, right, centre), change});
    add_part(index, from, to, rightward, line);
  }
}

void StripFold::add_part(std::size_t index, Point from, Point to, bool rightward, double line) {
  if (from.y == to.y) return;
  const bool rises = from.y < to.y;
  const double sign = rises == rightward ? +1 : -1;
  if (rises)
    parts_.add(index, {from.y, to.y, from.x - line, to.x - line, sign});
  else
    parts_.add(index, {to.y, from.y, to.x - line, from.x - line, sign});
}

void StripFold::list_events(std::span<const EdgePart> parts, std::span<const Crossing> right_line) {
  events_.clear();
  for (const EdgePart& part : parts) {
    events_.push_back(part.bottom);
    events_.push_back(part.top);
  }
  for (const Crossing& crossing : right_line) events_.push_back(crossing.along);
  std::sort(events_.begin(), events_.end());
  events_.erase(std::unique(events_.begin(), events_.end()), events_.end());
}

/// m(y) = w·[right side inside] + Σ ±x_e(y) over the edges e that y meets.
void StripFold::find_slabs(std::span<EdgePart> parts, std::span<Crossing> right_line) {
  profile_.slabs.clear();
  active_.clear();
  std::sort(right_line.begin(), right_line.end(), kEarlier);
  std::sort(parts.begin(), parts.end(),
            [](const EdgePart& a, const EdgePart& b) { return a.bottom < b.bottom; });
  list_events(parts, right_line);
  std::size_t next_part = 0, next_crossing = 0;
  int right_inside = 0;
  for (std::size_t i = 0; i + 1 < events_.size(); ++i) {
    const double from = events_[i], to = events_[i + 1];
    for (; next_crossing < right_line.size() && right_line[next_crossing].along <= from; ++next_crossing)
      right_inside += right_line[next_crossing].change;
    std::erase_if(active_, [from](const EdgePart& part) { return part.top <= from; });
    for (; next_part < parts.size() && parts[next_part].bottom <= from; ++next_part)
      active_.push_back(parts[next_part]);
    Slab slab{from, to, right_inside * width_m_, right_inside * width_m_};
    for (const EdgePart& part : active_) {
      slab.width_from += part.sign * part.across_at(from);
      slab.width_to += part.sign * part.across_at(to);
    }
    slab.width_from = std::clamp(slab.width_from, 0.0, width_m_);
    slab.width_to = std::clamp(slab.width_to, 0.0, width_m_);
    if (slab.width_from > 0 || slab.width_to > 0) profile_.slabs.push_back(slab);
  }
}

void StripFold::find_centre_line(std::span<Crossing> crossings) {
  profile_.centre_line.clear();
  std::sort(crossings.begin(), crossings.end(), kEarlier);
  int inside = 0;
  double from = 0;
  for (const Crossing& crossing : crossings) {
    const int before = inside;
    inside += crossing.change;
    if (before <= 0 && inside > 0) from = crossing.along;
    if (before > 0 && inside <= 0 && crossing.along > from)
      append_joining(profile_.centre_line, {from, crossing.along});
  }
}

}  // namespace tramline
