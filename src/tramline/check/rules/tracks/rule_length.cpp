#include <fmt/format.h>

#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {

namespace {

/// Those that are said to be too short.
void check_dropped(const Plan& plan, double least_m, Violations& out) {
  for (const DroppedPiece& piece : plan.dropped) {
    const double length_m = distance(piece.start, piece.end);
    if (piece.why != DroppedFor::kShort || length_m <= least_m + kLengthTolerance_m) continue;
    out.push_back(
        {Rule::kLength,
         fmt::format("a dropped piece is {:.3f} m long, not shorter than the {:.3f} m worth driving",
                     length_m, least_m),
         midpoint(piece.start, piece.end), length_m - least_m});
  }
}

}  // namespace

void check_length(const Case& c, Violations& out) {
  const auto& pieces = c.plan.pieces;
  const double least_m = min_length_m(c.plan.machine);
  check_dropped(c.plan, least_m, out);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const bool crosses = pieces[i].after_crossing || (i + 1 < pieces.size() && pieces[i + 1].after_crossing);
    const double length_m = length(pieces[i]);
    if (crosses || length_m >= least_m - kLengthTolerance_m) continue;
    out.push_back({Rule::kLength,
                   fmt::format("{} is {:.3f} m long, less than the {:.3f} m worth driving", piece_name(i),
                               length_m, least_m),
                   midpoint(pieces[i].start, pieces[i].end), least_m - length_m});
  }
}

}  // namespace tramline::check
