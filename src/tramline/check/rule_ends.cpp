#include <fmt/format.h>

#include <algorithm>

#include "tramline/check/bands.h"
#include "tramline/check/cross_section.h"
#include "tramline/check/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// What the end rule asks of every cross-section: so many metres inside, looked at so far to each side.
struct Demand {
  double half_m = 0;
  double required_m = 0;
};

/// Anything above nothing: as long as rounding can make a length that is none.
constexpr double kSome_m = 1e-9;

Demand demand(const Plan& plan) {
  const double width = plan.machine.width_m;
  const auto share = [&](double s) {
    return Demand{0.5 * width, std::max(s * width - kLengthTolerance_m, kSome_m)};
  };
  switch (plan.settings.end_rule) {
    // The centre line may run along an edge: it is inside where either side of it is.
    case EndRule::kCentre:
      return {kLengthTolerance_m, kSome_m};
    case EndRule::kCover:
      return share(0);
    case EndRule::kInside:
      return share(1);
    case EndRule::kCheapest:
      return share(cheapest_share(plan.objective));
  }
  return {};
}

/// The rings of all gaps near a straight part as those of one polygon: what lies inside counts even-odd, and
/// gaps lie apart.
Polygon gaps_near(const Case& c, const PieceFrame& frame, double half_m) {
  const Box near = frame.field_box({-half_m, 0, half_m, frame.length()});
  Polygon out;
  for (const Polygon& gap : c.plan.body) {
    if (!intersects(bounds(gap), near)) continue;
    out.holes.push_back(gap.outer);
    out.holes.insert(out.holes.end(), gap.holes.begin(), gap.holes.end());
  }
  return out;
}

std::string describe(const Plan& plan, std::size_t index, const Stretch& stretch) {
  const char* rule = name(plan.settings.end_rule);
  if (plan.settings.end_rule == EndRule::kCentre)
    return fmt::format("the centre line of {} leaves its subfield for {:.3f} m, against the end rule {}",
                       piece_name(index), stretch.length(), rule);
  return fmt::format(
      "{} has, for {:.3f} m, as little as {:.1f} % of its width inside its subfield, against the end rule {}",
      piece_name(index), stretch.length(), 100 * std::max(0.0, stretch.least_m) / plan.machine.width_m, rule);
}

}  // namespace

void check_ends(const Case& c, Violations& out) {
  const Demand asked = demand(c.plan);
  const double allowed_m = kLengthTolerance_m + (is_repair(c.plan) ? kLeastBreak_m : 0);
  const auto report = [&](std::size_t i, const Stretch& below, Point at) {
    if (below.length() > allowed_m) out.push_back({"ends", describe(c.plan, i, below), at, below.length()});
  };
  for (std::size_t i = 0; i < c.plan.pieces.size(); ++i) {
    const TrackPiece& piece = c.plan.pieces[i];
    const Polygon& land = c.plan.subfields[static_cast<std::size_t>(piece.subfield)].shape;
    if (!piece.curve.empty()) {
      for (const Path& part : parts_on_track(piece)) {
        const Stretch below = longest_below(land, part, asked.half_m, asked.required_m);
        report(i, below, place_on(part, 0.5 * (below.from_m + below.to_m)));
      }
      continue;
    }
    for (const PathSegment& part : straight_parts(piece)) {
      const PieceFrame frame(part.from, part.to);
      const Stretch below = is_repair(c.plan) ? longest_below(gaps_near(c, frame, asked.half_m), frame,
                                                              asked.half_m, asked.required_m)
                                              : longest_below(land, frame, asked.half_m, asked.required_m);
      report(i, below, frame.to_field({0, 0.5 * (below.from_m + below.to_m)}));
    }
  }
}

}  // namespace tramline::check
