#include "tramline/cost/bound/row_cost_bound.h"

#include <algorithm>
#include <cmath>

#include "tramline/cost/bound/part_rows.h"
#include "tramline/cost/tolerances.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

/// min(λo·(w − m), λu·m), nothing outside [0, w].
double row_cost(double m, const RowBoundTerms& terms) {
  return std::max(0.0, std::min(terms.over_price * (terms.width_m - m), terms.under_price * m));
}

/// ∫ max(0, min(λo·(w − s − m), λu·(m − s))) dm from 0 to m.
double least_cost_up_to(double m, double shift, const RowBoundTerms& terms) {
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
AffineBound along_chord(double from, double to, double m0, double m1, int sense, const RowBoundTerms& terms) {
  const double shift = most_shift(from, to, terms);
  const double low = std::clamp(std::min(m0, m1) - shift, 0.0, terms.width_m);
  const double high = std::clamp(std::max(m0, m1) + shift, 0.0, terms.width_m);
  if (high <= low) return {};
  const double at_low = row_cost(low, terms), slope = (row_cost(high, terms) - at_low) / (high - low);
  const double length = to - from, middle = 0.5 * (from + to);
  return {(at_low + slope * (0.5 * (m0 + m1) - low)) * length, sense * slope * length,
          sense * slope * length * (middle - terms.pivot_along)};
}

/// Whether the length inside grows with the shift (1) or shrinks (−1).
int sense_of(const BoundaryPart& part) { return rises(part) ? 1 : -1; }

/// Length inside of a row that only this part passes: negative, or more than the width, where it passes
/// beside the strip.
double inside_of(const BoundaryPart& part, double along, double width_m) {
  return rises(part) ? x_at(part, along) : width_m - x_at(part, along);
}

/// Rows through which one part passes, in steps so that a chord spans little more than the shift.
AffineBound along_part(const PartRow& row, const RowBoundTerms& terms) {
  const BoundaryPart& part = *row.parts.front();
  const double from = inside_of(part, row.from, terms.width_m), to = inside_of(part, row.to, terms.width_m);
  const double step = std::max(0.5 * most_shift(row.from, row.to, terms), terms.width_m / 8);
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / step)));
  AffineBound sum;
  for (int i = 0; i < steps; ++i) {
    const double low = static_cast<double>(i) / steps, high = static_cast<double>(i + 1) / steps;
    sum += along_chord(row.from + (row.to - row.from) * low, row.from + (row.to - row.from) * high,
                       from + (to - from) * low, from + (to - from) * high, sense_of(part), terms);
  }
  return sum;
}

/// Least cost of rows, ∫ max(0, min(λo·(w − s − m), λu·(m − s))) over them.
double least_cost_of(const PartRow& row, const RowBoundTerms& terms) {
  const double length = row.to - row.from, shift = most_shift(row.from, row.to, terms);
  const double m0 = row.inside_from, m1 = row.inside_to;
  if (std::abs(m1 - m0) > kRounding_share * terms.width_m)
    return length * (least_cost_up_to(m1, shift, terms) - least_cost_up_to(m0, shift, terms)) / (m1 - m0);
  return length * std::max(0.0, std::min(terms.over_price * (terms.width_m - shift - m0),
                                         terms.under_price * (m0 - shift)));
}

/// Cost of rows that are not driven, each at its least.
double undriven_cost(const PartRow& row, const RowBoundTerms& terms) {
  const double inside = 0.5 * (row.inside_from + row.inside_to);
  return (row.to - row.from) * terms.under_price *
         std::max(0.0, inside - most_shift(row.from, row.to, terms));
}

/// The same rows moved at once, where the row cannot become wider than the strip.
AffineBound undriven_together(const PartRow& row, double least, const RowBoundTerms& terms) {
  const BoundaryPart& part = *row.parts.front();
  const double from = inside_of(part, row.from, terms.width_m), to = inside_of(part, row.to, terms.width_m);
  if (std::max(from, to) + most_shift(row.from, row.to, terms) > terms.width_m) return {least, 0, 0};
  const double length = row.to - row.from, per_shift = sense_of(part) * terms.under_price * length;
  return {terms.under_price * length * 0.5 * (from + to), per_shift,
          per_shift * (0.5 * (row.from + row.to) - terms.pivot_along)};
}

}  // namespace

double most_shift(double from, double to, const RowBoundTerms& terms) {
  const double along = std::max(std::abs(from - terms.pivot_along), std::abs(to - terms.pivot_along));
  return terms.shift + terms.turn * along;
}

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

double inside_rows(std::span<const BoundaryPart> parts, const RowBoundTerms& terms) {
  thread_local PartRows rows;
  double sum = 0;
  rows.for_each(parts, terms.width_m, {}, [&](const PartRow& row) {
    const double inside = 0.5 * (row.inside_from + row.inside_to);
    sum += (row.to - row.from) * std::max(0.0, inside - most_shift(row.from, row.to, terms));
  });
  return sum;
}

RowBounds row_cost_bound(std::span<const BoundaryPart> parts, const RowBoundTerms& terms,
                         std::span<const Interval> undriven) {
  thread_local PartRows rows;
  thread_local std::vector<double> cuts;
  cuts.clear();
  for (const Interval& stretch : undriven) cuts.insert(cuts.end(), {stretch.from, stretch.to});
  auto next = undriven.begin();
  RowBounds sum;
  rows.for_each(parts, terms.width_m, cuts, [&](const PartRow& row) {
    while (next != undriven.end() && next->to <= row.from) ++next;
    const bool is_undriven = next != undriven.end() && next->from <= row.from;
    const double least = is_undriven ? undriven_cost(row, terms) : least_cost_of(row, terms);
    sum.apart += least;
    if (row.parts.size() != 1)
      sum.together.constant += least;
    else
      sum.together += is_undriven ? undriven_together(row, least, terms) : along_part(row, terms);
  });
  return sum;
}

}  // namespace tramline
