#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "tramline/check/measure/bands.h"
#include "tramline/check/measure/cross_section.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// The requirement of the end rule on every cross-section: the metres that have to be inside, and the half
/// width to check.
struct Demand {
  double half_m = 0;
  double required_m = 0;
};

Demand demand(const Plan& plan) {
  const double width = plan.machine.width_m;
  const auto share = [&](double s) {
    const double required_m = s * width - kLengthTolerance_m;
    return required_m > kShortest_m ? Demand{0.5 * width, required_m}
                                    : Demand{0.5 * width + kTouching_m, kShortest_m};
  };
  switch (plan.settings.end_rule) {
    // The centre line may run along an edge: it is inside where either side of it is.
    case EndRule::kCentre:
      return {kLengthTolerance_m, kShortest_m};
    case EndRule::kCover:
      return share(0);
    case EndRule::kInside:
      return share(1);
    case EndRule::kCheapest:
      return share(cheapest_share(plan.objective));
  }
  return {};
}

/// The rings of all polygons that reach into the box as those of one: what lies inside counts even-odd, and
/// the polygons lie apart.
Polygon land_within(const Box& box, const Region& land) {
  Polygon out;
  for (const Polygon& polygon : land) {
    if (!intersects(bounds(polygon), box)) continue;
    out.holes.push_back(polygon.outer);
    out.holes.insert(out.holes.end(), polygon.holes.begin(), polygon.holes.end());
  }
  return out;
}

/// The land that a piece has to cover: its subfield; in a repair, any gap. Tracks along one curve may go
/// through several subfields.
Region land_asked_for(const Plan& plan, const TrackPiece& piece) {
  if (is_repair(plan)) return plan.body;
  const Subfield& own = plan.subfields[piece.subfield];
  if (piece.curve.empty()) return {own.shape};
  Region out;
  for (const Subfield& other : plan.subfields)
    if (other.reference == own.reference) out.push_back(other.shape);
  return out;
}

std::string describe(const Plan& plan, std::size_t index, const Stretch& stretch) {
  const char* rule = name(plan.settings.end_rule);
  const char* land = plan.pieces[index].curve.empty() ? "its subfield" : "the land to work";
  if (plan.settings.end_rule == EndRule::kCentre)
    return fmt::format("the centre line of {} leaves {} for {:.3f} m, against the end rule {}",
                       piece_name(index), land, stretch.length(), rule);
  return fmt::format(
      "{} has, for {:.3f} m, as little as {:.1f} % of its width inside {}, against the end rule {}",
      piece_name(index), stretch.length(), 100 * std::max(0.0, stretch.least_m) / plan.machine.width_m, land,
      rule);
}

}  // namespace

void check_ends(const Case& c, Violations& out) {
  const Demand asked = demand(c.plan);
  const double allowed_m = kLengthTolerance_m + (is_repair(c.plan) ? kLeastBreak_m : 0);
  const auto report = [&](std::size_t i, const Stretch& below, Point at) {
    if (below.length() > allowed_m)
      out.push_back({Rule::kEnds, describe(c.plan, i, below), at, below.length()});
  };
  std::map<std::pair<std::size_t, bool>, Region> lands;  // by subfield, of straight and of curved pieces
  for (std::size_t i = 0; i < c.plan.pieces.size(); ++i) {
    const TrackPiece& piece = c.plan.pieces[i];
    Region& asked_for = lands[{piece.subfield, piece.curve.empty()}];
    if (asked_for.empty()) asked_for = land_asked_for(c.plan, piece);
    for (const Path& part : parts_on_track(piece)) {
      const Polygon land = land_within(reach_of(part, 2 * asked.half_m), asked_for);
      const Stretch below = longest_below(land, part, asked.half_m, asked.required_m);
      report(i, below, point_on(part, 0.5 * (below.from_m + below.to_m)));
    }
  }
}

}  // namespace tramline::check
