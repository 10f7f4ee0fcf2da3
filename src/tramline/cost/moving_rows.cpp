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
  const double step = std::max(0.5 * farthest(from, to, terms), terms.width_m / 32);
  const int steps = std::max(1, static_cast<int>(std::ceil(change / step)));
  AffineBound sum;
  for (int i = 0; i < steps; ++i) {
    const double low = from + (to - from) * i / steps, high = from + (to - from) * (i + 1) / steps;
    sum += along_chord(low, high, inside(low), inside(high), sense, terms);
  }
  return sum;
}

}  // namespace

AffineBound& AffineBound::operator+=(const AffineBound& other) {
  constant += other.constant;
  per_shift += other.per_shift;
  per_turn += other.per_turn;
  return *this;
}

double AffineBound::least(double shift, double turn) const {
  return constant - shift * std::abs(per_shift) - turn * std::abs(per_turn);
}

double spared_rows(const std::vector<Slab>& slabs, double from, double to, double shift,
                   const MovingTerms& terms) {
  double sum = 0;
  for (const Slab& slab : slabs) {
    const double low = std::max(slab.from, from), high = std::min(slab.to, to);
    if (low >= high) continue;
    const double m0 = slab.width_at(low), m1 = slab.width_at(high);
    if (std::abs(m1 - m0) > 1e-9 * terms.width_m)
      sum += (high - low) * (spared_up_to(m1, shift, terms) - spared_up_to(m0, shift, terms)) / (m1 - m0);
    else
      sum += (high - low) * std::max(0.0, std::min(terms.over_price * (terms.width_m - shift - m0),
                                                   terms.under_price * (m0 - shift)));
  }
  return sum;
}

AffineBound moving_rows(std::span<const BoundaryPart> parts, const std::vector<Slab>& slabs,
                        const MovingTerms& terms) {
  thread_local std::vector<double> rows;
  thread_local std::vector<const BoundaryPart*> active;
  rows.clear();
  active.clear();
  for (const BoundaryPart& part : parts) {
    rows.push_back(part.from.y);
    rows.push_back(part.to.y);
  }
  std::sort(rows.begin(), rows.end());
  AffineBound sum;
  auto next = parts.begin();  // from low to high
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    const double from = rows[i], to = rows[i + 1];
    if (!(from < to)) continue;
    std::erase_if(active, [&](const BoundaryPart* part) { return part->highest() <= from; });
    for (; next != parts.end() && next->lowest() <= from; ++next)
      if (next->highest() > from) active.push_back(&*next);
    if (active.size() == 1)
      sum += along_part(*active.front(), from, to, terms);
    else
      sum.constant += spared_rows(slabs, from, to, farthest(from, to, terms), terms);
  }
  return sum;
}

}  // namespace tramline
