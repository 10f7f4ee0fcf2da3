#include "tramline/planner/repair/gap_lines.h"

#include <algorithm>
#include <utility>

#include "tramline/planner/tolerances.h"
#include "tramline/tracks/end_rule.h"

namespace tramline {
namespace {

/// The saving of a piece less its cost, on a line with others.
double worth_of_piece(const LaidPiece& piece, const RepairTerms& terms) {
  const Objective& objective = terms.objective;
  const double width_m = terms.machine.width_m;
  const double overlap_m2 = width_m * std::max(piece.to - piece.from, width_m) - piece.inside_m2;
  const int stops = (piece.stop_at_from ? 1 : 0) + (piece.stop_at_to ? 1 : 0);
  return objective.uncovered * piece.inside_m2 - objective.overlap * overlap_m2 - objective.stop * stops;
}

/// The stretches within one stretch of open land, with short breaks worked through.
Intervals stretches_in(const Interval& room, const Intervals& wanted) {
  Intervals out;
  for (const Interval& stretch : common(wanted, {room})) {
    if (stretch.length() < kNoPiece_m) continue;
    if (!out.empty() && stretch.from - out.back().to < kLeastBreak_m)
      out.back().to = stretch.to;
    else
      out.push_back(stretch);
  }
  return out;
}

LaidPiece piece_over(const Track& strip, const Interval& stretch) {
  LaidPiece out;
  out.track = strip.index;
  out.from = stretch.from;
  out.to = stretch.to;
  out.length_m = stretch.length();
  out.stop_at_from = stops_at(strip, stretch.from, -1);
  out.stop_at_to = stops_at(strip, stretch.to, +1);
  out.inside_m2 = strip.subfield.area_between(stretch.from, stretch.to);
  return out;
}

void append(LaidPiece piece, GapLine& line) {
  piece.after_crossing = !line.pieces.empty();
  line.length_m += piece.to - piece.from;
  line.covered_m2 += piece.inside_m2;
  line.stops += (piece.stop_at_from ? 1 : 0) + (piece.stop_at_to ? 1 : 0);
  line.pieces.push_back(std::move(piece));
}

}  // namespace

std::vector<GapLine> lines_on(const Track& strip, const Intervals& open, const RepairTerms& terms,
                              WantedPieces wanted) {
  const double width_m = terms.machine.width_m;
  EndCriterion criterion = end_criterion(terms.end_rule, terms.objective, width_m);
  criterion.least_width_m = std::max(criterion.least_width_m, kTail_m);
  const Intervals allowed = allowed_by(criterion, strip.subfield);
  std::vector<GapLine> out;
  for (const Interval& room : open) {
    if (room.length() < width_m) continue;
    GapLine line;
    for (const Interval& stretch : stretches_in(room, allowed)) {
      const LaidPiece piece = piece_over(strip, stretch);
      if (wanted == WantedPieces::kAll || worth_of_piece(piece, terms) > 0) append(piece, line);
    }
    if (!line.pieces.empty() && line.length_m >= terms.machine.min_length_m) out.push_back(std::move(line));
  }
  return out;
}

double price_of(const GapLine& line, const RepairTerms& terms) {
  const double width_m = terms.machine.width_m;
  double priced_m = 0;
  for (const LaidPiece& piece : line.pieces) priced_m += std::max(piece.to - piece.from, width_m);
  priced_m = std::max(priced_m, 2 * width_m);
  return terms.objective.stop * line.stops + terms.objective.overlap * (width_m * priced_m - line.covered_m2);
}

double worth_of(const GapLine& line, double covered_m2, const RepairTerms& terms) {
  const double more_overlap_m2 = line.covered_m2 - covered_m2;
  return terms.objective.uncovered * covered_m2 - price_of(line, terms) -
         terms.objective.overlap * more_overlap_m2;
}

}  // namespace tramline
