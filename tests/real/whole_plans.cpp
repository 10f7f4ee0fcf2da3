// Plans of least whole cost over real fields, against plans of least cost of their tracks and against random
// ones: are they cheaper, and which fields are driven crosswise?
//
//   whole_plans WIDTH RADIUS forward|reversing [EVERY [RANDOM]]
//
// Every EVERY-th curated field, all by default; RANDOM: so many random layouts a field, none by default: one
// direction, offset and depth of headland each, with its route. Prints a line for every field, and a summary;
// exit code 1 where a random layout beats a plan by more than a hundredth.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <random>
#include <string>

#include "real/real_fields.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/bounding_rectangle.h"
#include "tramline/planner/assembly/finished_plan.h"
#include "tramline/planner/explain/longest_side.h"
#include "tramline/planner/plan_field.h"
#include "tramline/planner/prepare_field.h"
#include "tramline/planner/whole/cheapest_route.h"

namespace tramline::testing {
namespace {

constexpr double kElongated = 2.5, kCrosswise_deg = 45, kBeaten = 0.01;

PlanSettings settings_for(Aim aim) {
  PlanSettings out;
  out.headland_rule = out.obstacle_headland_rule = HeadlandRule::kTurns;
  out.boundary = EdgeKind::kHard;
  out.turns = TurnPlanning::kRoute;
  out.aim = aim;
  return out;
}

double price_of(const Plan& plan) { return compared_price(alternative_of(Alternative::kSearched, plan)); }

struct Compared {
  bool planned = false, elongated = false, crosswise = false;
  double whole = 0, tracks = 0;  ///< prices of both plans
  double random = 0;             ///< of the cheapest random layout, 0 without
};

/// Length to width of the smallest rectangle round the field.
double elongation(const Field& field) {
  const Direction along = across_least_width(field.outer);
  const TrackFrame frame(along);
  Box box;
  for (const Point p : field.outer) box.extend(frame.to_track(p));
  return box.height() / box.width();
}

Direction main_direction(const Plan& plan) {
  double longest_m = -1;
  Direction out;
  for (const TrackPiece& piece : plan.pieces)
    if (piece.curve.empty() && length(piece) > longest_m) {
      longest_m = length(piece);
      out = plan.subfields[piece.subfield].direction;
    }
  return out;
}

std::string figures(const Plan& plan) {
  const WholeCost cost = whole_cost(plan);
  return fmt::format("{:.2f} € {:.2f} h {} turns {} stops", price_of(plan), cost.time_s() / 3600,
                     plan.tally.turns, plan.tally.stops);
}

/// The route over tracks in any direction, at any offset, behind 1 to 4 passes round everything; nullopt
/// where no track fits.
std::optional<double> random_price(const PlanningProblem& problem, std::mt19937& random) {
  std::uniform_real_distribution<double> any(0, 1);
  const Direction along = Direction::clockwise_from_north(Angle::degrees(180 * any(random)));
  const double offset_m = problem.machine.width_m * any(random);
  PlanningProblem asked = problem;
  asked.settings.headland_rule = asked.settings.obstacle_headland_rule = HeadlandRule::kPasses;
  asked.settings.headlands = 1 + static_cast<int>(4 * any(random));
  const int round_obstacles = static_cast<int>(3 * any(random));
  const std::optional<PreparedField> prepared =
      field_behind(asked, std::vector<int>(problem.field.obstacles.size(), round_obstacles));
  if (!prepared || area(prepared->ground.plannable) == 0) return std::nullopt;
  const SearchTask task(asked, *prepared);
  std::vector<LinedSubfield> lined;
  for (const Polygon& part : prepared->ground.plannable) lined.push_back({{part, along}, offset_m});
  SearchResult found;
  found.best = candidate_on(task, lined);
  if (!found.best.works()) return std::nullopt;
  return price_of(drafted(task, found).plan);
}

Compared compare(const Field& field, const Machine& machine, int layouts) {
  Compared out;
  try {
    const Plan whole = plan_field(field, machine, {}, settings_for(Aim::kWholeCost), 1);
    const Plan tracks = plan_field(field, machine, {}, settings_for(Aim::kCost), 1);
    out.planned = true;
    out.whole = price_of(whole);
    out.tracks = price_of(tracks);
    const double ratio = elongation(field);
    const Direction side = longest_side(field, machine.width_m);
    const double off_deg = angle_between(main_direction(whole), side).degrees();
    out.elongated = ratio >= kElongated;
    out.crosswise = out.elongated && !whole.pieces.empty() && off_deg > kCrosswise_deg;
    PlanningProblem problem =
        with_track_prices(planning_problem(field, machine, {}, settings_for(Aim::kWholeCost)));
    std::mt19937 random(20260101);
    for (int i = 0; i < layouts; ++i)
      if (const auto price = random_price(problem, random))
        out.random = out.random == 0 ? *price : std::min(out.random, *price);
    fmt::print(
        "  {}: {}; by tracks {}; length to width {:.1f}, {:.0f}° off the longest side (by tracks "
        "{:.0f}°){}{}\n",
        field.id, figures(whole), figures(tracks), ratio, off_deg,
        angle_between(main_direction(tracks), side).degrees(), out.crosswise ? ", crosswise" : "",
        out.random > 0 ? fmt::format("; best of {} random ones {:.2f} €", layouts, out.random) : "");
    std::fflush(stdout);
  } catch (const Error& error) {
    fmt::print("  {}: {}\n", field.id, error.what());
    if (error.kind() != ErrorKind::kBadInput) throw;
  }
  return out;
}

int run(const Machine& machine, std::size_t every, int layouts) {
  std::optional<RealFields> fields = read_or_say();
  if (!fields) return 0;
  std::vector<RawFeature>& features = fields->dataset.layers.front().features;
  std::vector<RawFeature> chosen;
  for (std::size_t i = 0; i < features.size(); i += every) chosen.push_back(std::move(features[i]));
  features = std::move(chosen);
  const std::vector<Compared> all =
      for_each_field(*fields, [&](const Field& field) { return compare(field, machine, layouts); });
  std::size_t planned = 0, dearer = 0, elongated = 0, crosswise = 0, beaten = 0;
  double whole = 0, tracks = 0;
  for (const Compared& one : all) {
    if (!one.planned) continue;
    ++planned;
    whole += one.whole;
    tracks += one.tracks;
    dearer += one.whole > one.tracks + 0.005 ? 1 : 0;
    elongated += one.elongated ? 1 : 0;
    crosswise += one.crosswise ? 1 : 0;
    beaten += one.random > 0 && one.random < (1 - kBeaten) * one.whole ? 1 : 0;
  }
  fmt::print(
      "w {:g} m, r {:g} m: {} plans, {:.0f} €, by the cost of tracks {:.0f} €, dearer {}; {} elongated, {} "
      "of them "
      "crosswise; {} beaten by random layouts\n",
      machine.width_m, machine.radius_m, planned, whole, tracks, dearer, elongated, crosswise, beaten);
  return beaten == 0 ? 0 : 1;
}

}  // namespace
}  // namespace tramline::testing

int main(int count, char** words) {
  const auto machine = tramline::testing::machine_in_words(
      count, words, "whole_plans WIDTH RADIUS forward|reversing [EVERY [RANDOM]]");
  if (!machine) return 2;
  const auto every = static_cast<std::size_t>(count > 4 ? std::max(1, std::atoi(words[4])) : 1);
  return tramline::testing::run(*machine, every, count > 5 ? std::atoi(words[5]) : 0);
}
