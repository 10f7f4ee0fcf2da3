// Plans of least whole cost over real fields, against plans of least cost of their tracks, against plans
// along the longest side, and against random ones: are they cheaper, and which fields are not driven along?
//
//   whole_plans WIDTH RADIUS KIND [EVERY|FIELD [RANDOM [FIRST]]]
//
// Every EVERY-th curated field from the FIRST on, all by default, or the one of this id; RANDOM: so many
// random layouts a field, none by default: one direction, offset and depth of headland each, with its route.
// Prints a row for every field: figures of the plan, those of the plan by the cost of tracks, and how far the
// longest tracks of both are off the longest side. Plans of elongated fields that do not lie along it are
// explained by the cheapest plan that does. Exit code 1 where a plan along the longest side or a random
// layout costs less than a plan by more than a hundredth.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "real/plans_along.h"
#include "real/real_fields.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/bounding_rectangle.h"
#include "tramline/planner/assembly/finished_plan.h"
#include "tramline/planner/explain/longest_side.h"
#include "tramline/planner/plan_field.h"
#include "tramline/planner/plans/cheapest_route.h"
#include "tramline/planner/prepare_field.h"
#include "tramline/planner/whole/route_floor.h"

namespace tramline::testing {
namespace {

constexpr double kElongated = 2.5, kLengthwise_deg = 10, kBeaten = 0.01;

struct Words {
  std::size_t every = 1, first = 0;
  std::string only;  ///< id of the one field
  int layouts = 0;
};

/// A random layout: so many passes round the field and round each obstacle.
struct RandomLayout {
  Direction along;
  double offset_m = 0;
  int passes = 0, round_obstacles = 0;
  Plan plan;  ///< its route and all
};

struct Compared {
  bool planned = false, elongated = false, lengthwise = true, beaten_lengthwise = false, beaten = false;
  double whole = 0, tracks = 0;  ///< prices of both plans
};

double off_deg(const Plan& plan, Direction side) {
  const auto along = main_direction(plan);
  return along ? angle_between(*along, side).degrees() : 0;
}

std::string row(const Plan& plan, Direction side) {
  const WholeCost cost = whole_cost(plan);
  return fmt::format("{:4} {:4} {:7.3f} {:9.2f} {:3.0f}", plan.tally.turns, plan.tally.stops,
                     cost.time_s() / 3600, price_of(plan), off_deg(plan, side));
}

RandomLayout any_layout(double width_m, std::mt19937& random) {
  std::uniform_real_distribution<double> any(0, 1);
  RandomLayout out;
  out.along = Direction::clockwise_from_north(Angle::degrees(180 * any(random)));
  out.offset_m = width_m * any(random);
  out.passes = 1 + static_cast<int>(4 * any(random));
  out.round_obstacles = static_cast<int>(3 * any(random));
  return out;
}

/// The plan of the layout with its route; nothing where no track fits, or where all that any route of it
/// takes costs no less than `limit`.
std::optional<Plan> planned_below(double limit, const PlanningProblem& problem, const RandomLayout& layout) {
  PlanningProblem asked = problem;
  asked.settings.shape = TrackShape::kStraight;
  asked.settings.headland_rule = asked.settings.obstacle_headland_rule = HeadlandRule::kPasses;
  asked.settings.headlands = layout.passes;
  const std::optional<PreparedField> prepared =
      field_behind(asked, std::vector<int>(problem.field.obstacles.size(), layout.round_obstacles));
  if (!prepared || area(prepared->ground.plannable) == 0) return std::nullopt;
  std::vector<LinedSubfield> lined;
  for (const Polygon& part : prepared->ground.plannable)
    lined.push_back({{part, layout.along}, layout.offset_m});
  PlanningProblem without_route = asked;
  without_route.settings.turns = TurnPlanning::kNone;
  const SearchTask laying(without_route, *prepared);
  SearchResult found;
  found.best = candidate_on(laying, lined);
  if (!found.best.works()) return std::nullopt;
  if (route_floor(drafted(laying, found).plan, *prepared->turning_land) >= limit) return std::nullopt;
  return drafted(SearchTask(asked, *prepared), found).plan;
}

/// The cheapest of so many random layouts, if it costs less than `price`.
std::optional<RandomLayout> cheapest_random(const Field& field, const Machine& machine, double price,
                                            int layouts) {
  const PlanningProblem problem =
      with_track_prices(planning_problem(field, machine, {}, settings_for(Aim::kWholeCost)));
  std::mt19937 random(20260101);
  std::optional<RandomLayout> out;
  for (int i = 0; i < layouts; ++i) {
    RandomLayout layout = any_layout(machine.width_m, random);
    std::optional<Plan> plan = planned_below(price, problem, layout);
    if (!plan || price_of(*plan) >= price) continue;
    price = price_of(*plan);
    layout.plan = *std::move(plan);
    out = std::move(layout);
  }
  return out;
}

/// Of the directions of the longest side and of the length.
std::optional<Plan> cheapest_lengthwise(const Field& field, const Machine& machine, const Plan& whole,
                                        Direction side) {
  std::optional<Plan> out = cheapest_along(field, machine, whole, side);
  std::optional<Plan> other = cheapest_along(field, machine, whole, across_least_width(field.outer));
  if (other && off_deg(*other, side) <= kLengthwise_deg && (!out || price_of(*other) < price_of(*out)))
    out = std::move(other);
  return out;
}

Compared compare(const Field& field, const Machine& machine, const Words& words) {
  Compared out;
  try {
    const Plan whole = plan_field(field, machine, {}, settings_for(Aim::kWholeCost), 1);
    const Plan tracks = plan_field(field, machine, {}, settings_for(Aim::kCost), 1);
    out.planned = true;
    out.whole = price_of(whole);
    out.tracks = price_of(tracks);
    const double ratio = elongation(field);
    const Direction side = longest_side(field, machine.width_m);
    out.elongated = ratio >= kElongated;
    out.lengthwise = off_deg(whole, side) <= kLengthwise_deg;
    const bool unexpected = out.elongated && !out.lengthwise;
    std::string text =
        fmt::format("{:12} {:6.2f} {:5.1f} | {} | {}{}\n", field.id, area(Polygon{field.outer, {}}) / 1e4,
                    ratio, row(tracks, side), row(whole, side), unexpected ? " *" : "");
    if (unexpected || !words.only.empty()) {
      text += fmt::format("    planned  {}\n", figures_in_full(whole));
      const auto along = cheapest_lengthwise(field, machine, whole, side);
      out.beaten_lengthwise = along && price_of(*along) < (1 - kBeaten) * out.whole;
      text += fmt::format("    along    {}{}\n", along ? figures_in_full(*along) : "no track fits",
                          out.beaten_lengthwise ? ": CHEAPER" : "");
    }
    if (const auto found = cheapest_random(field, machine, out.whole, words.layouts)) {
      out.beaten = price_of(found->plan) < (1 - kBeaten) * out.whole;
      text +=
          fmt::format("    random   {}, offset {:.2f} m, {} passes, {} round obstacles, tracks {:.2f} €{}\n",
                      figures_in_full(found->plan), found->offset_m, found->passes, found->round_obstacles,
                      found->plan.cost, out.beaten ? ": CHEAPER" : "");
    }
    fmt::print("{}", text);
  } catch (const Error& error) {
    fmt::print("{:12} {}\n", field.id, error.what());
    if (error.kind() != ErrorKind::kBadInput) throw;
  }
  std::fflush(stdout);
  return out;
}

void choose(const Words& words, std::vector<RawFeature>& features) {
  std::vector<RawFeature> chosen;
  for (std::size_t i = words.first; i < features.size(); i += words.every)
    if (words.only.empty() || features[i].id == words.only) chosen.push_back(std::move(features[i]));
  features = std::move(chosen);
}

int run(const Machine& machine, const Words& words) {
  std::optional<RealFields> fields = read_or_say();
  if (!fields) return 0;
  choose(words, fields->dataset.layers.front().features);
  fmt::print("{:12} {:>6} {:>5} | {:>4} {:>4} {:>7} {:>9} {:>3} | {:>4} {:>4} {:>7} {:>9} {:>3}\n", "field",
             "ha", "l/w", "turn", "stop", "h", "€", "off", "turn", "stop", "h", "€", "off");
  const std::vector<Compared> all =
      for_each_field(*fields, [&](const Field& field) { return compare(field, machine, words); });
  double whole = 0, tracks = 0;
  for (const Compared& one : all) {
    whole += one.whole;
    tracks += one.tracks;
  }
  const auto count = [&](const auto& is) { return std::count_if(all.begin(), all.end(), is); };
  const auto beaten_along = count([](const Compared& one) { return one.beaten_lengthwise; });
  const auto beaten = count([](const Compared& one) { return one.beaten; });
  fmt::print(
      "w {:g} m, r {:g} m: {} plans, {:.0f} €, by the cost of tracks {:.0f} €, dearer {}; {} elongated, {} "
      "of "
      "them not along the longest side, {} of these dearer than a plan along it; {} beaten by random "
      "layouts\n",
      machine.width_m, machine.radius_m, count([](const Compared& one) { return one.planned; }), whole,
      tracks, count([](const Compared& one) { return one.whole > one.tracks + 0.005; }),
      count([](const Compared& one) { return one.elongated; }),
      count([](const Compared& one) { return one.elongated && !one.lengthwise; }), beaten_along, beaten);
  return beaten + beaten_along == 0 ? 0 : 1;
}

Words words_of(int count, char** words) {
  Words out;
  if (count > 4) {
    const std::string which = words[4];
    const bool number =
        std::all_of(which.begin(), which.end(), [](unsigned char c) { return std::isdigit(c); });
    if (number)
      out.every = static_cast<std::size_t>(std::max(1, std::atoi(words[4])));
    else
      out.only = which;
  }
  if (count > 5) out.layouts = std::atoi(words[5]);
  if (count > 6) out.first = static_cast<std::size_t>(std::max(0, std::atoi(words[6])));
  return out;
}

}  // namespace
}  // namespace tramline::testing

int main(int count, char** words) {
  const auto machine = tramline::testing::machine_in_words(
      count, words, "whole_plans WIDTH RADIUS KIND [EVERY|FIELD [RANDOM [FIRST]]]");
  if (!machine) return 2;
  return tramline::testing::run(*machine, tramline::testing::words_of(count, words));
}
