#include "tramline/planner/warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/polygon/outline_distance.h"
#include "tramline/headland/body.h"
#include "tramline/planner/given/narrow_tails.h"

namespace tramline {
namespace {

/// Much land is left where it is more than this share of all.
constexpr double kMuch_share = 0.02;
/// The machine backs out of ends over a long way where that is more than this share of the route.
constexpr double kMuchBacking_share = 0.1;

/// The land on which no swath fits, corners left out.
Region narrow_land(const Field& field, double width_m) {
  Region out;
  for (const Polygon& part :
       difference({{field.outer, {}}}, unite(obstacle_shapes(field, ObstacleKind::kObstacle)))) {
    const Region tails = narrow_tails(part, width_m, width_m);
    out.insert(out.end(), tails.begin(), tails.end());
  }
  return out;
}

/// Why much land stays unworked, where that is the land's fault. Land that is given up is told of by itself.
void warn_of_narrow_land(const Plan& plan, std::vector<std::string>& out) {
  if (unworked_land_warning(plan).empty()) return;
  const Region narrow = intersection(plan.uncovered, narrow_land(plan.field, plan.machine.width_m));
  const double unworked_m2 = area(difference(narrow, plan.given_up));
  if (unworked_m2 <= kMuch_share * land_m2(plan)) return;
  out.push_back(fmt::format(
      "{:.0f} m² of what stays unworked lie where the land is narrower than the machine", unworked_m2));
}

void warn_of_overrun(const Plan& plan, std::vector<std::string>& out) {
  constexpr double kWorthSaying_m = 0.01;
  const Region outside = difference(plan.overlap, {{plan.field.outer, {}}});
  double farthest = 0;
  for (const Polygon& part : outside)
    for (const Point p : part.outer) farthest = std::max(farthest, distance_to_outline(p, plan.field.outer));
  if (farthest < kWorthSaying_m) return;
  out.push_back(
      fmt::format("swaths pass the field boundary by up to {:.2f} m ({:.1f} m² in all); --boundary hard "
                  "keeps them inside",
                  farthest, area(outside)));
}

void warn_of_given_up_land(const Plan& plan, std::vector<std::string>& out) {
  constexpr double kWorthSaying_m2 =
      0.05;  // an area that would be reported as 0.0 m² is the grid of booleans
  const double left_out_m2 = area(left_out_land(plan)), given_up_m2 = area(plan.given_up) - left_out_m2;
  if (given_up_m2 >= kWorthSaying_m2)
    out.push_back(
        fmt::format("{:.1f} m² between obstacles, or between obstacles and the edge, are narrower than the "
                    "machine and are given up",
                    given_up_m2));
  if (left_out_m2 >= kWorthSaying_m2)
    out.push_back(fmt::format("{:.1f} m² are left out on purpose and count as uncovered", left_out_m2));
}

/// Warns of requested passes round the field that had no room, and of plans that consist of passes alone.
void warn_of_narrow_ground(const Plan& plan, std::vector<std::string>& out) {
  int most = 0;
  for (const HeadlandPass& pass : plan.headland.passes)
    if (pass.around_field) most = std::max(most, pass.number);
  const int asked = plan.settings.headlands;
  if (plan.settings.headland_rule == HeadlandRule::kPasses && most < asked)
    out.push_back(fmt::format("{} headland passes round the field were asked for, and there is room for {}",
                              asked, most));
  if (plan.pieces.empty() && !plan.headland.passes.empty())
    out.emplace_back("the field is worked by its headland passes alone: they leave no room for tracks");
}

struct Dropped {
  int pieces = 0;
  double length_m = 0;
};

Dropped dropped_for(DroppedFor why, const Plan& plan) {
  Dropped out;
  for (const DroppedPiece& piece : plan.dropped) {
    if (piece.why != why) continue;
    ++out.pieces;
    out.length_m += distance(piece.start, piece.end);
  }
  return out;
}

void warn_of_dropped_pieces(const Plan& plan, std::vector<std::string>& out) {
  const Dropped small = dropped_for(DroppedFor::kShort, plan), far = dropped_for(DroppedFor::kWay, plan);
  if (small.pieces > 0)
    out.push_back(fmt::format("not driven: {} {} shorter than {:.2f} m, {:.1f} m in all", small.pieces,
                              small.pieces == 1 ? "piece" : "pieces", min_length_m(plan.machine),
                              small.length_m));
  if (far.pieces > 0)
    out.push_back(
        fmt::format("not worth the way: {} {}, {:.1f} m in all, would cost more to drive to and work "
                    "than the land is worth",
                    far.pieces, far.pieces == 1 ? "piece" : "pieces", far.length_m));
}

/// The distance that a machine needs after a turn to straighten up and work, about.
void warn_of_short_pieces(const Plan& plan, std::vector<std::string>& out) {
  const double least_m = 2 * plan.machine.radius_m + plan.machine.width_m;
  const auto is_short = [least_m](const TrackPiece& piece) { return length(piece) < least_m; };
  const auto count = std::count_if(plan.pieces.begin(), plan.pieces.end(), is_short);
  if (is_repair(plan) || count == 0) return;
  out.push_back(
      fmt::format("{} of {} tracks {} shorter than {:.1f} m, twice the turning radius and the working "
                  "width: hardly worth turning for",
                  count, plan.pieces.size(), count == 1 ? "is" : "are", least_m));
}

void warn_of_swinging_corners(const Plan& plan, std::vector<std::string>& out) {
  double most_m = 0;
  for (const RouteLeg& leg : plan.route.legs)
    if (!lacks_room(leg, plan.machine)) most_m = std::max(most_m, leg.missing_m);
  if (most_m == 0) return;
  out.push_back(
      fmt::format("corners of the machine swing out over the edge of the land by up to {:.2f} m where "
                  "headland passes turn, whichever way they are driven",
                  most_m));
}

/// Says why a machine drives far in reverse, as on strips too narrow to turn on.
void warn_of_backing(const Plan& plan, std::vector<std::string>& out) {
  const double all_m = sums_of(plan.route).length_m;
  double backed_m = 0, longest_m = 0;
  for (const RouteLeg& leg : plan.route.legs) {
    if (leg.kind != LegKind::kBackOut) continue;
    backed_m += length(leg);
    longest_m = std::max(longest_m, length(leg));
  }
  if (backed_m <= kMuchBacking_share * all_m) return;
  out.push_back(
      fmt::format("{:.0f} m of the route, {:.0f} %, are driven in reverse, up to {:.0f} m at a time: where "
                  "tracks and passes end the machine has no room to turn",
                  backed_m, 100 * backed_m / all_m, longest_m));
}

void warn_of_legs_without_room(const Plan& plan, std::vector<std::string>& out) {
  const std::size_t without_room = legs_without_room(plan.route, plan.machine);
  if (without_room == 0) return;
  double most_m = 0;
  for (const RouteLeg& leg : plan.route.legs)
    if (lacks_room(leg, plan.machine)) most_m = std::max(most_m, leg.missing_m);
  out.push_back(
      fmt::format("the route leaves the land on {} of its {} legs, by up to {:.2f} m: no way has room there",
                  without_room, plan.route.legs.size(), most_m));
}

}  // namespace

std::string unworked_land_warning(const Plan& plan) {
  const double land = land_m2(plan), unworked = plan.tally.uncovered_m2;
  if (is_repair(plan) || unworked <= kMuch_share * land) return "";
  return fmt::format("{:.1f} % of the land, {:.0f} m², stays unworked", 100 * unworked / land, unworked);
}

void add_parts(std::size_t parts, std::vector<std::string>& warnings) {
  if (parts < 2) return;
  warnings.push_back(
      fmt::format("the land falls into {} parts for a machine as wide as this: the route works one after the "
                  "other, and leaves the land from each to the next",
                  parts));
}

void add_limits(const SweepLimits& limits, std::vector<std::string>& warnings) {
  std::vector<std::string> all;
  if (limits.directions_left_out > 0)
    all.push_back(fmt::format(
        "the edges of the field have {} directions, of which the sweep tries those {} of the longest edges",
        limits.directions, limits.directions - limits.directions_left_out));
  if (limits.without_detours > 0)
    all.push_back(fmt::format(
        "the sweep did not look for ways past obstacles in {} of its directions, which look more expensive",
        limits.without_detours));
  // Before the sentence that every plan without a route has.
  const auto last = std::find(warnings.begin(), warnings.end(), kConnectionsUnplanned);
  warnings.insert(last, all.begin(), all.end());
}

void add_shorter_ends(const Candidate& candidate, std::vector<std::string>& warnings) {
  constexpr double kWorthSaying_m = 0.05;
  int ends = 0;
  double most_m = 0;
  for (const LaidTracks& tracks : candidate.avoided.tracks)
    for (const LaidPiece& piece : tracks.pieces)
      for (const double short_m : {piece.short_at_from_m, piece.short_at_to_m})
        if (short_m >= kWorthSaying_m) {
          ++ends;
          most_m = std::max(most_m, short_m);
        }
  if (ends == 0) return;
  warnings.push_back(
      fmt::format("shortened: {} {} of tracks, by up to {:.2f} m: there the machine turns at once, where it "
                  "would have to stop or to drive a loop farther on",
                  ends, ends == 1 ? "end" : "ends", most_m));
}

void mark_cut_short(Plan& plan) {
  plan.proof.cut_short = true;
  std::vector<std::string> all{
      "the search was ended before it was through: a longer one may find a cheaper plan"};
  all.insert(all.end(), plan.warnings.begin(), plan.warnings.end());
  plan.warnings = std::move(all);
}

std::vector<std::string> warnings_about(const Plan& plan) {
  std::vector<std::string> out;
  if (std::string unworked = unworked_land_warning(plan); !unworked.empty())
    out.push_back(std::move(unworked));
  warn_of_narrow_land(plan, out);
  out.insert(out.end(), plan.field.warnings.begin(), plan.field.warnings.end());
  const std::vector<std::string>& remarks = plan.settings.given.remarks;
  out.insert(out.end(), remarks.begin(), remarks.end());
  warn_of_overrun(plan, out);
  warn_of_given_up_land(plan, out);
  warn_of_narrow_ground(plan, out);
  warn_of_dropped_pieces(plan, out);
  warn_of_short_pieces(plan, out);
  if (!plan.route.planned()) out.emplace_back(kConnectionsUnplanned);
  warn_of_backing(plan, out);
  warn_of_swinging_corners(plan, out);
  warn_of_legs_without_room(plan, out);
  return out;
}

}  // namespace tramline
