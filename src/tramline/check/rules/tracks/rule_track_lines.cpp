#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "tramline/check/measure/bands.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// A point where a piece is off the line of its track.
struct Off {
  Point at;
  double reference_m;  ///< from there to the reference
  bool other_side;     ///< of the reference
};

std::optional<Off> off_line(const TrackLines& lines, const ParallelLine& line, int track,
                            const PathSegment& segment, double width_m) {
  const double length_m = length(segment), due_m = lines.off_m(track);
  const int looks = 2 * std::max(1, static_cast<int>(std::ceil(0.5 * length_m / width_m)));
  for (int i = 0; i <= looks; ++i) {
    const Point at = i < looks ? point_on(segment, length_m * i / looks) : segment.to;
    const Foot near = lines.side_of(track).foot_of(at, due_m + kLengthTolerance_m);
    if (std::isfinite(near.off_m) && near.on_right && near.square && near.off_m >= due_m - kLengthTolerance_m)
      continue;
    if (std::isinf(near.off_m) && line.rolls_round_corner(segment, at)) continue;
    const Foot foot = lines.side_of(track).foot_of(at);
    return Off{at, foot.off_m, !foot.on_right};
  }
  return std::nullopt;
}

}  // namespace

void check_track_lines(const Case& c, Violations& out) {
  if (is_repair(c.plan)) return;
  for (std::size_t i = 0; i < c.plan.pieces.size(); ++i) {
    const TrackPiece& piece = c.plan.pieces[i];
    const TrackLines& lines = c.lines.of(piece.subfield);
    if (!lines.known()) continue;
    const ParallelLine line = lines.line(piece.track);
    std::optional<Off> worst;
    const double due_m = lines.off_m(piece.track);
    const auto by_m = [due_m](const Off& off) { return std::abs(off.reference_m - due_m); };
    for (const Path& part : parts_on_track(piece))
      for (const PathSegment& segment : part) {
        const std::optional<Off> found = off_line(lines, line, piece.track, segment, c.plan.machine.width_m);
        if (found && (!worst || by_m(*found) > by_m(*worst))) worst = found;
      }
    if (!worst) continue;
    out.push_back(
        {Rule::kParallel,
         fmt::format("{} lies {:.4f} m from the reference line{}, and track {} runs {:.4f} m from it",
                     piece_name(i), worst->reference_m, worst->other_side ? " on the other side of it" : "",
                     piece.track + 1, due_m),
         worst->at, by_m(*worst)});
  }
}

}  // namespace tramline::check
