#include "tramline/check/file/compare_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>

#include "tramline/check/measure/overlay_cells.h"
#include "tramline/check/rules/route/route_facts.h"
#include "tramline/check/rules/rules.h"

namespace tramline::check {
namespace {

/// A number that a warning has to state. Amounts are rounded in sentences, and computed here by other means.
struct ExpectedFigure {
  double value = 0;
  bool is_count = false;
};

ExpectedFigure amount(double value) { return {value, false}; }
ExpectedFigure counted(std::ptrdiff_t count) { return {static_cast<double>(count), true}; }

/// A warning, known by some of its words, and whether it has to be there.
struct Expected {
  const char* words;
  bool due = false;
  bool open = false;  ///< so near to the limit that it may be there or not
  std::vector<ExpectedFigure> figures;
};

/// A number in a sentence, and one in its last digit.
struct Figure {
  double value;
  double step;
};

std::vector<Figure> figures_in(const std::string& sentence) {
  std::vector<Figure> out;
  const auto digit = [&](std::size_t i) {
    return i < sentence.size() && std::isdigit(static_cast<unsigned char>(sentence[i])) != 0;
  };
  for (std::size_t i = 0; i < sentence.size();) {
    if (!digit(i)) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (digit(end)) ++end;
    double step = 1;
    if (end < sentence.size() && sentence[end] == '.' && digit(end + 1))
      for (++end; digit(end); ++end) step *= 0.1;
    out.push_back({std::strtod(sentence.substr(i, end - i).c_str(), nullptr), step});
    i = end;
  }
  return out;
}

bool agrees(const std::string& sentence, const std::vector<ExpectedFigure>& figures) {
  const std::vector<Figure> found = figures_in(sentence);
  return found.size() == figures.size() && std::equal(found.begin(), found.end(), figures.begin(),
                                                      [](const Figure& said, const ExpectedFigure& expected) {
                                                        return std::abs(said.value - expected.value) <=
                                                               (expected.is_count ? 0 : 1.01 * said.step);
                                                      });
}

Expected of_unworked_land(const Plan& plan) {
  constexpr double kMuch = 0.02, kOpen = 1e-6;
  const double land = land_m2(plan), share = land > 0 ? plan.tally.uncovered_m2 / land : 0;
  return {"stays unworked",
          !is_repair(plan) && share > kMuch,
          std::abs(share - kMuch) < kOpen,
          {amount(100 * share), amount(plan.tally.uncovered_m2)}};
}

double distance_to_outline(const Ring& ring, Point p) {
  double out = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i)
    out = std::min(out, distance_to_edge({ring[i], ring[i + 1 < ring.size() ? i + 1 : 0], 0}, p, p));
  return out;
}

Expected of_overrun(const Plan& plan) {
  constexpr double kWorthSaying_m = 0.01, kOpen_m = 1e-4;
  enum Over : std::size_t { kField, kOverlap };
  double farthest_m = 0, outside_m2 = 0;
  for (const Polygon& part : plan.overlap)
    for (const Point p : part.outer)
      if (!contains(plan.field.outer, p))
        farthest_m = std::max(farthest_m, distance_to_outline(plan.field.outer, p));
  OverlayEdges overlay;
  overlay.add(Polygon{plan.field.outer, {}}, kField);
  overlay.add(plan.overlap, kOverlap);
  each_cell(overlay, [&](const OverlayCell& cell) {
    if (cell.covers.front().shape == kOverlap) outside_m2 += cell.area_m2;
  });
  return {"pass the field boundary by",
          farthest_m >= kWorthSaying_m,
          std::abs(farthest_m - kWorthSaying_m) < kOpen_m,
          {amount(farthest_m), amount(outside_m2)}};
}

Expected of_given_up_land(const Plan& plan) {
  constexpr double kWorthSaying_m2 = 0.05, kOpen_m2 = 1e-3;
  const double given_up_m2 = area(plan.given_up) - area(left_out_land(plan));
  return {"narrower than the machine and are given up",
          given_up_m2 >= kWorthSaying_m2,
          std::abs(given_up_m2 - kWorthSaying_m2) < kOpen_m2,
          {amount(given_up_m2)}};
}

Expected of_left_out_land(const Plan& plan) {
  constexpr double kWorthSaying_m2 = 0.05, kOpen_m2 = 1e-3;
  const double left_out_m2 = area(left_out_land(plan));
  return {"left out on purpose",
          left_out_m2 >= kWorthSaying_m2,
          std::abs(left_out_m2 - kWorthSaying_m2) < kOpen_m2,
          {amount(left_out_m2)}};
}

/// Passes that follow from turns nobody has asked for.
Expected of_passes_without_room(const Plan& plan) {
  int most = 0;
  for (const HeadlandPass& pass : plan.headland.passes)
    if (pass.around_field) most = std::max(most, pass.number);
  const int asked = plan.settings.headlands;
  const bool lacking = plan.settings.headland_rule == HeadlandRule::kPasses && most < asked;
  return {"headland passes round the field were asked for", lacking, false, {counted(asked), counted(most)}};
}

Expected of_passes_alone(const Plan& plan) {
  return {
      "worked by its headland passes alone", plan.pieces.empty() && !plan.headland.passes.empty(), false, {}};
}

std::vector<double> lengths_dropped_for(DroppedFor why, const Plan& plan) {
  std::vector<double> out;
  for (const DroppedPiece& piece : plan.dropped)
    if (piece.why == why) out.push_back(distance(piece.start, piece.end));
  return out;
}

Expected of_short_dropped_pieces(const Plan& plan) {
  const std::vector<double> lengths_m = lengths_dropped_for(DroppedFor::kShort, plan);
  return {"not driven:",
          !lengths_m.empty(),
          false,
          {counted(std::ssize(lengths_m)), amount(min_length_m(plan.machine)),
           amount(std::accumulate(lengths_m.begin(), lengths_m.end(), 0.0))}};
}

Expected of_pieces_not_worth_the_way(const Plan& plan) {
  const std::vector<double> lengths_m = lengths_dropped_for(DroppedFor::kWay, plan);
  return {"not worth the way:",
          !lengths_m.empty(),
          false,
          {counted(std::ssize(lengths_m)), amount(std::accumulate(lengths_m.begin(), lengths_m.end(), 0.0))}};
}

Expected of_short_pieces(const Plan& plan) {
  const double least_m = 2 * plan.machine.radius_m + plan.machine.width_m;
  const auto count = std::count_if(plan.pieces.begin(), plan.pieces.end(),
                                   [least_m](const TrackPiece& piece) { return length(piece) < least_m; });
  return {"hardly worth turning for",
          !is_repair(plan) && count > 0,
          false,
          {counted(count), counted(std::ssize(plan.pieces)), amount(least_m)}};
}

Expected of_cut_short(const Plan& plan) {
  return {"the search was ended before it was through", plan.proof.cut_short, false, {}};
}

Expected of_connections(const Plan& plan) {
  return {"connections between tracks are not planned", !plan.route.planned(), false, {}};
}

Expected of_backing(const Plan& plan) {
  constexpr double kWorthSaying_share = 0.1, kOpen_share = 1e-9;
  double all_m = 0, backed_m = 0, longest_m = 0;
  for (const RouteLeg& leg : plan.route.legs) {
    const double leg_m = length(leg);
    all_m += leg_m;
    if (leg.kind != LegKind::kBackOut) continue;
    backed_m += leg_m;
    longest_m = std::max(longest_m, leg_m);
  }
  const double share = all_m > 0 ? backed_m / all_m : 0;
  return {"are driven in reverse, up to",
          share > kWorthSaying_share,
          std::abs(share - kWorthSaying_share) < kOpen_share,
          {amount(backed_m), amount(100 * share), amount(longest_m)}};
}

Expected of_legs_without_room(const Plan& plan) {
  std::ptrdiff_t count = 0;
  double most_m = 0;
  for (const RouteLeg& leg : plan.route.legs) {
    if (!cannot_be_driven(plan, leg)) continue;
    ++count;
    most_m = std::max(most_m, leg.missing_m);
  }
  return {"the route leaves the land on",
          count > 0,
          false,
          {counted(count), counted(std::ssize(plan.route.legs)), amount(most_m)}};
}

Expected of_swinging_corners(const Plan& plan) {
  double most_m = 0;
  for (const RouteLeg& leg : plan.route.legs)
    if (!cannot_be_driven(plan, leg)) most_m = std::max(most_m, leg.missing_m);
  return {"swing out over the edge of the land by up to", most_m > 0, false, {amount(most_m)}};
}

Expected of_parts(const Plan& plan) {
  const std::size_t parts = plan.route.planned() ? parts_with_work(plan, LandParts(plan)) : 1;
  return {"the land falls into", parts > 1, false, {counted(static_cast<std::ptrdiff_t>(parts))}};
}

/// Of lines of others only the warning about land is ours to repeat.
std::vector<Expected> all_expected(const Plan& plan) {
  if (is_of_lines(plan)) return {of_unworked_land(plan)};
  return {of_unworked_land(plan),
          of_overrun(plan),
          of_given_up_land(plan),
          of_left_out_land(plan),
          of_passes_without_room(plan),
          of_passes_alone(plan),
          of_short_dropped_pieces(plan),
          of_pieces_not_worth_the_way(plan),
          of_short_pieces(plan),
          of_cut_short(plan),
          of_connections(plan),
          of_backing(plan),
          of_legs_without_room(plan),
          of_swinging_corners(plan),
          of_parts(plan)};
}

}  // namespace

std::vector<Violation> compare_warnings(const Plan& plan) {
  std::vector<Violation> out;
  if (plan.figures == PlanFigures::kTracks) return out;
  const auto report = [&](const std::string& what) {
    out.push_back({Rule::kWarnings, what, plan.field.outer.front(), 1});
  };
  for (const Expected& expected : all_expected(plan)) {
    const auto found = std::find_if(
        plan.warnings.begin(), plan.warnings.end(),
        [&](const std::string& sentence) { return sentence.find(expected.words) != std::string::npos; });
    const bool said = found != plan.warnings.end();
    if (!expected.open && said != expected.due)
      report(said ? fmt::format("the plan warns '{}' without cause", expected.words)
                  : fmt::format("the plan has no warning '{}'", expected.words));
    else if (said && !agrees(*found, expected.figures))
      report(fmt::format("the warning '{}' has other figures than the plan", *found));
  }
  for (const std::string& sentence : plan.field.warnings)
    if (std::find(plan.warnings.begin(), plan.warnings.end(), sentence) == plan.warnings.end())
      report(fmt::format("the plan does not repeat what was said of its field: '{}'", sentence));
  return out;
}

}  // namespace tramline::check
