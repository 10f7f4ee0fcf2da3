#include "tramline/cost/moving_rows.h"

#include <algorithm>
#include <cmath>

namespace tramline {
namespace {

/// min(λo·(w − m), λu·m), nothing outside [0, w].
double row_cost(double m, const MovingTerms& terms) {
  return std::max(0.0, std::min(terms.over_price * (terms.width_m - m), terms.under_price * m));
}

double farthest(double from, double to, const MovingTerms& terms) {
  const double along = std::max(std::abs(from - terms.pivot_along), std::abs(to - terms.pivot_along));
  return terms.shift + terms.turn * along;
}

/// ∫ max(0, min(λo·(w − s − m), λu·(m − s))) dm from 0 to m.
double spared_up_to(double m, double shift, const MovingTerms& terms) {
  const double low = shift, high = terms.width_m - shift;
  const double both = terms.over_price + terms.under_price;
  if (!(low < high) || both <= 0) return 0;
  const double peak = low + (high - low) * terms.over_price / both;
  const double rising = std::clamp(m, low, peak) - low;
  const double falling = high - std::clamp(m, peak, high);
  return 0.5 * (terms.under_price * rising * rising +
                terms.over_price * ((high - peak) * (high - peak) - falling * falling));
}

/// Rows from `from` to `to` in which m goes from m0 to m1 and grows with the shift by `sense`: charged along
/// one chord of the cost.
AffineBound along_chord(double from, double to, double m0, double m1, int sense, const MovingTerms& terms) {
  const double shift = farthest(from, to, terms);
  const double low = std::clamp(std::min(m0, m1) - shift, 0.0, terms.width_m);
  const double high = std::clamp(std::max(m0, m1) + shift, 0.0, terms.width_m);
  if (high <= low) return {};
  const double at_low = row_cost(low, terms), slope = (row_cost(high, terms) - at_low) / (high - low);
  const double length = to - from, middle = 0.5 * (from + to);
  return {(at_low + slope * (0.5 * (m0 + m1) - low)) * length, sense * slope * length,
          sense * slope * length * (middle - terms.pivot_along)};
}

/// The same in steps, so that a chord spans little more than the shift.
AffineBound along_part(const BoundaryPart& part, double from, double to, const MovingTerms& terms) {
  const double slope = (part.to.x - part.from.x) / (part.to.y - part.from.y);
  const int sense = part.to.y > part.from.y ? 1 : -1;  // what lies to the left is inside
  const auto inside = [&](double along) {
    const double x = part.from.x + slope * (along - part.from.y);
    return sense > 0 ? x : terms.width_m - x;
  };
  const double change = std::abs(inside(to) - inside(from));
  const double step = std::max(0.5 * farthest(from, to, terms), terms.width_m / 8);
  const int steps = std::max(1, static_cast<int>(std::ceil(change / step)));
  AffineBound sum;
  for (int i = 0; i < steps; ++i) {
    const double low = from + (to - from) * i / steps, high = from + (to - from) * (i + 1) / steps;
    sum += along_chord(low, high, inside(low), inside(high), sense, terms);
  }
  return sum;
}

double at(const BoundaryPart& part, double along) {
  return part.from.x + (part.to.x - part.from.x) * ((along - part.from.y) / (part.to.y - part.from.y));
}

/// Does the land to the right of all parts that pass a row lie inside?
bool right_inside(const std::vector<const BoundaryPart*>& active, double along) {
  const auto rightmost = std::max_element(
      active.begin(), active.end(),
      [&](const BoundaryPart* a, const BoundaryPart* b) { return at(*a, along) < at(*b, along); });
  return (*rightmost)->to.y < (*rightmost)->from.y;
}

/// How much of a row lies inside, from all the parts that pass it.
double inside_width(const std::vector<const BoundaryPart*>& active, double along, double width_m,
                    bool right) {
  double sum = right ? width_m : 0;
  for (const BoundaryPart* part : active)
    sum += (part->to.y > part->from.y ? 1 : -1) * std::clamp(at(*part, along), 0.0, width_m);
  return sum;
}

/// ∫ max(0, min(λo·(w − s − m), λu·(m − s))) over rows in which m goes from m0 to m1.
double spared(double length, double m0, double m1, double shift, const MovingTerms& terms) {
  if (std::abs(m1 - m0) > 1e-9 * terms.width_m)
    return length * (spared_up_to(m1, shift, terms) - spared_up_to(m0, shift, terms)) / (m1 - m0);
  return length * std::max(0.0, std::min(terms.over_price * (terms.width_m - shift - m0),
                                         terms.under_price * (m0 - shift)));
}

/// Where the set of parts in a row changes, or one of them passes a line of the strip.
void list_rows(std::span<const BoundaryPart> parts, double width_m, std::vector<double>& out) {
  out.clear();
  for (const BoundaryPart& part : parts) {
    out.push_back(part.from.y);
    out.push_back(part.to.y);
    for (const double line : {0.0, width_m})
      if ((part.from.x < line) != (part.to.x < line))
        out.push_back(part.from.y +
                      (part.to.y - part.from.y) * ((line - part.from.x) / (part.to.x - part.from.x)));
  }
  std::sort(out.begin(), out.end());
}

}  // namespace

AffineBound& AffineBound::operator+=(const AffineBound& other) {
  constant += other.constant;
  per_shift += other.per_shift;
  per_turn += other.per_turn;
  return *this;
}

AffineBound& AffineBound::operator-=(const AffineBound& other) {
  return *this += {-other.constant, -other.per_shift, -other.per_turn};
}

double AffineBound::most(double shift, double turn) const {
  return constant + shift * std::abs(per_shift) + turn * std::abs(per_turn);
}

double AffineBound::least(double shift, double turn) const {
  return constant - shift * std::abs(per_shift) - turn * std::abs(per_turn);
}

namespace {

/// Calls row(from, to, m0, m1, active) for all stretches of rows through which the same parts pass, m0 and
/// m1 being how much lies inside at either end.
template <class Row>
void for_each_row(std::span<const BoundaryPart> parts, const MovingTerms& terms, const Row& row) {
  thread_local std::vector<double> rows;
  thread_local std::vector<const BoundaryPart*> active;
  list_rows(parts, terms.width_m, rows);
  active.clear();
  auto next = parts.begin();
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    const double from = rows[i], to = rows[i + 1], middle = 0.5 * (from + to);
    if (!(from < to)) continue;
    std::erase_if(active, [&](const BoundaryPart* part) { return part->highest() <= middle; });
    for (; next != parts.end() && next->lowest() <= from; ++next)
      if (next->highest() > middle) active.push_back(&*next);
    if (active.empty()) continue;
    const bool right = right_inside(active, middle);
    row(from, to, inside_width(active, from, terms.width_m, right),
        inside_width(active, to, terms.width_m, right), active);
  }
}

}  // namespace

double inside_rows(std::span<const BoundaryPart> parts, const MovingTerms& terms) {
  double sum = 0;
  for_each_row(parts, terms, [&](double from, double to, double m0, double m1, const auto&) {
    const double shift = farthest(from, to, terms);
    sum += (to - from) * std::max({0.0, 0.5 * (m0 + m1) - shift});
  });
  return sum;
}

RowBounds moving_rows(std::span<const BoundaryPart> parts, const MovingTerms& terms) {
  RowBounds sum;
  for_each_row(parts, terms, [&](double from, double to, double m0, double m1, const auto& active) {
    const double least = spared(to - from, m0, m1, farthest(from, to, terms), terms);
    sum.apart += least;
    if (active.size() == 1)
      sum.together += along_part(*active.front(), from, to, terms);
    else
      sum.together.constant += least;
  });
  return sum;
}

}  // namespace tramline
