#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// The straight line that all subfields refer to.
struct AnchorLine {
  Point from;
  Point along;

  /// Of a point, to the right of the line, m.
  double right_m(Point p) const { return cross(p - from, along); }
};

std::optional<AnchorLine> anchor_line(const Plan& plan) {
  const std::optional<Path> reference = common_reference(plan);
  if (!reference || reference->size() != 1 || !reference->front().straight()) return std::nullopt;
  const double length_m = distance(reference->front().from, reference->front().to);
  if (!(length_m > kShortest_m)) return std::nullopt;
  return AnchorLine{reference->front().from, direction_at_start(reference->front())};
}

void check_at_envelope(const Plan& plan, const AnchorLine& line, Violations& out) {
  double least_m = std::numeric_limits<double>::infinity();
  Point at{};
  for (const Subfield& subfield : plan.subfields)
    for (const Point p : subfield.shape.outer)
      if (line.right_m(p) < least_m) {
        least_m = line.right_m(p);
        at = p;
      }
  if (std::abs(least_m) <= kLengthTolerance_m) return;
  out.push_back(
      {Rule::kParallel,
       fmt::format("the land begins {:.4f} m to the {} of the reference line, which is to be the side "
                   "of its envelope",
                   std::abs(least_m), least_m > 0 ? "right" : "left"),
       at, std::abs(least_m)});
}

}  // namespace

void check_ab_anchor(const Case& c, Violations& out) {
  const Plan& plan = c.plan;
  if (anchor_of(plan.settings) != AbAnchor::kEnvelope || plan.subfields.empty() || is_repair(plan)) return;
  const std::optional<AnchorLine> line = anchor_line(plan);
  if (!line) {
    const std::string what = "tracks that are to begin at the envelope of the body";
    out.push_back({Rule::kParallel, what + " have no straight reference line", plan.field.outer.front(), 0});
    return;
  }
  check_at_envelope(plan, *line, out);
  for (std::size_t i = 0; i < plan.pieces.size(); ++i) {
    const TrackPiece& piece = plan.pieces[i];
    const double due_m = std::abs(piece.track + 0.5) * plan.machine.width_m;
    for (const Point end : {piece.start, piece.end}) {
      const double off_m = line->right_m(end);
      if (std::abs(off_m - due_m) <= kLengthTolerance_m) continue;
      out.push_back(
          {Rule::kParallel,
           fmt::format("{} lies {:.4f} m from the reference line, and track {} runs {:.4f} m from it",
                       piece_name(i), off_m, piece.track + 1, due_m),
           end, std::abs(off_m - due_m)});
      break;
    }
  }
}

}  // namespace tramline::check
