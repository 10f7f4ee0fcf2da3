// Plans every curated real field with obstacles in the three ways of getting past them, and compares.
//
//   obstacle_sweep [--width 3,6,12,24] [--radius 3,6,12] [--field ID]
//   obstacle_sweep --stop-prices
//
// Prints a line for everything that is not well, one for each machine, and a table for docs/obstacles.md;
// exit code 1 when anything failed. With --stop-prices: how many obstacles are driven round as the price of a
// stop rises, on one field with many small ones.

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sstream>

#include "real/obstacle_runs.h"
#include "real/real_fields.h"
#include "real/spread.h"
#include "real/stop_prices.h"
#include "tramline/geometry/error.h"

namespace tramline::testing {
namespace {

struct Request {
  std::vector<double> widths_m{3, 6, 12, 24};
  std::vector<double> radii_m{3, 6, 12};
  std::string field_id;  ///< empty: all
  bool stop_prices = false;
};

std::vector<double> numbers(const std::string& list) {
  std::vector<double> out;
  std::istringstream text(list);
  for (std::string word; std::getline(text, word, ',');) out.push_back(std::stod(word));
  return out;
}

/// nullopt where the arguments are not as above.
std::optional<Request> request_in(const std::vector<std::string>& words) {
  Request out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--stop-prices") {
      out.stop_prices = true;
      continue;
    }
    if (i + 1 == words.size()) return std::nullopt;
    if (words[i] == "--width")
      out.widths_m = numbers(words[++i]);
    else if (words[i] == "--radius")
      out.radii_m = numbers(words[++i]);
    else if (words[i] == "--field")
      out.field_id = words[++i];
    else
      return std::nullopt;
  }
  return out;
}

/// Does the feature have a hole, before anything is repaired?
bool has_holes(const RawFeature& feature) {
  return std::any_of(feature.polygons.begin(), feature.polygons.end(),
                     [](const RawPolygon& polygon) { return polygon.rings.size() > 1; });
}

std::vector<const RawFeature*> features_with_holes(const RealFields& fields, const std::string& field_id) {
  std::vector<const RawFeature*> out;
  for (const RawFeature& feature : fields.features())
    if (has_holes(feature) && (field_id.empty() || feature.id == field_id)) out.push_back(&feature);
  return out;
}

/// A run for each part of the feature that has obstacles.
std::vector<ObstacleRun> runs_of(const RealFields& fields, const RawFeature& feature, const Machine& machine,
                                 const std::string& scratch) {
  // A CRS object serves one thread at a time.
  thread_local const Crs crs(fields.dataset.layers.front().crs);
  std::vector<ObstacleRun> out;
  try {
    const std::vector<Field> parts = admitted(fields, crs, feature), inputs = admitted(fields, crs, feature);
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (!parts[i].obstacles.empty()) out.push_back(run_obstacles(parts[i], inputs[i], machine, scratch));
  } catch (const Error& error) {
    out.emplace_back();
    out.back().field_id = feature.id;
    out.back().refused = error.what();
  }
  return out;
}

std::vector<ObstacleRun> sweep(const RealFields& fields, const std::string& field_id,
                               const Machine& machine) {
  const std::vector<const RawFeature*> features = features_with_holes(fields, field_id);
  std::vector<std::vector<ObstacleRun>> by_feature(features.size());
  tbb::parallel_for(std::size_t{0}, features.size(), [&](std::size_t i) {
    const std::string scratch =
        (std::filesystem::temp_directory_path() / fmt::format("tramline-obstacles-{}-{}.gpkg", getpid(), i))
            .string();
    by_feature[i] = runs_of(fields, *features[i], machine, scratch);
  });
  std::vector<ObstacleRun> out;
  for (const auto& parts : by_feature) out.insert(out.end(), parts.begin(), parts.end());
  return out;
}

/// The runs of one machine in figures: what the cheapest plans save against all tracks cut.
struct Summary {
  Machine machine;
  int plans = 0;
  int failures = 0;
  int refused = 0;
  int met = 0;
  int round = 0;
  Spread turns;
  Spread stops;
  Spread cost;
  Spread cost_pct;
  Spread seconds;
  int paper_met = 0;       ///< by the paper's rule: encounters,
  int paper_round = 0;     ///< those driven round,
  int paper_tight = 0;     ///< and detours that the machine could not follow
  int paper_cheaper = 0;   ///< plans by the paper's rule that cost less, all of them with such detours
  Spread paper_saved_pct;  ///< of these, by how much
};

Summary summary_of(const std::vector<ObstacleRun>& runs, const Machine& machine) {
  Summary out;
  out.machine = machine;
  std::vector<double> turns, stops, cost, cost_pct, seconds, paper_saved_pct;
  for (const ObstacleRun& run : runs) {
    out.failures += run.faults.empty() ? 0 : 1;
    out.refused += run.refused.empty() ? 0 : 1;
    if (run.cheapest.directions_tried == 0) continue;
    ++out.plans;
    out.met += run.cheapest.met;
    out.round += run.cheapest.round;
    turns.push_back(run.cut.tally.turns - run.cheapest.tally.turns);
    stops.push_back(run.cut.tally.stops - run.cheapest.tally.stops);
    cost.push_back(run.cut.cost - run.cheapest.cost);
    cost_pct.push_back(run.cut.cost > 0 ? 100 * cost.back() / run.cut.cost : 0);
    seconds.push_back(run.cheapest.seconds);
    out.paper_met += run.paper.met;
    out.paper_round += run.paper.round;
    out.paper_tight += run.paper.tight;
    const double saved = run.cheapest.cost - run.paper.cost;
    if (run.paper.tight == 0 || saved <= 1e-9 * run.paper.cost) continue;
    ++out.paper_cheaper;
    paper_saved_pct.push_back(100 * saved / run.cheapest.cost);
  }
  out.turns = spread_of(turns);
  out.stops = spread_of(stops);
  out.cost = spread_of(cost);
  out.cost_pct = spread_of(cost_pct);
  out.seconds = spread_of(seconds);
  if (!paper_saved_pct.empty()) out.paper_saved_pct = spread_of(paper_saved_pct);
  return out;
}

void report_runs(const std::vector<ObstacleRun>& runs, const Machine& machine) {
  constexpr double kSlow_s = 5;
  const std::string place = fmt::format("w {} r {}", machine.width_m, machine.radius_m);
  for (const ObstacleRun& run : runs) {
    for (const std::string& fault : run.faults) fmt::print("  {}, {}: {}\n", run.field_id, place, fault);
    if (!run.refused.empty()) fmt::print("  {}, {} refused: {}\n", run.field_id, place, run.refused);
    if (run.cheapest.seconds > kSlow_s)
      fmt::print("  {}, {}: {:.1f} s ({:.1f} s with all tracks cut, {} directions)\n", run.field_id, place,
                 run.cheapest.seconds, run.cut.seconds, run.cut.directions_tried);
  }
}

double share_pct(int part, int whole) { return whole > 0 ? 100.0 * part / whole : 0; }

/// Never "-0".
double plain(double value) { return value == 0 ? 0 : value; }

std::string counts(const Spread& spread) {
  return fmt::format("{:g} ({:g} … {:g})", plain(spread.median), plain(spread.least), plain(spread.most));
}

std::string amounts(const Spread& spread) {
  return fmt::format("{:.1f} ({:.1f} … {:.1f})", plain(spread.median), plain(spread.least),
                     plain(spread.most));
}

void report_line(const Summary& s) {
  fmt::print(
      "w {} r {}: {} plans, {} fail, {} refused; saved, median (worst … best): turns {}, stops {}, cost {}, "
      "{} %; {} of {} encounters driven round, {:.0f} %; planning median {:.3f} s, longest {:.2f} s\n",
      s.machine.width_m, s.machine.radius_m, s.plans, s.failures, s.refused, counts(s.turns), counts(s.stops),
      amounts(s.cost), amounts(s.cost_pct), s.round, s.met, share_pct(s.round, s.met), s.seconds.median,
      s.seconds.most);
  std::fflush(stdout);
}

void print_table(const std::vector<Summary>& summaries) {
  fmt::print(
      "\n| *w*, m | *r*, m | fields | encounters | driven round | turns saved | stops saved | cost saved, € "
      "| "
      "cost saved, % | planning, s |\n|--:|--:|--:|--:|--:|---|---|---|---|---|\n");
  for (const Summary& s : summaries)
    fmt::print("| {} | {} | {} | {} | {:.0f} % | {} | {} | {} | {} | {:.2f}, at most {:.1f} |\n",
               s.machine.width_m, s.machine.radius_m, s.plans, s.met, share_pct(s.round, s.met),
               counts(s.turns), counts(s.stops), amounts(s.cost), amounts(s.cost_pct), s.seconds.median,
               s.seconds.most);
}

/// What the paper draws and the machine may be unable to follow, against the cheapest that it can.
void print_paper_table(const std::vector<Summary>& summaries) {
  fmt::print(
      "\n| *w*, m | *r*, m | encounters | driven round | too tight to follow | plans that cost less | by, % "
      "|\n"
      "|--:|--:|--:|--:|--:|--:|---|\n");
  for (const Summary& s : summaries)
    fmt::print("| {} | {} | {} | {} | {} | {} of {} | {} |\n", s.machine.width_m, s.machine.radius_m,
               s.paper_met, s.paper_round, s.paper_tight, s.paper_cheaper, s.plans,
               s.paper_cheaper > 0 ? amounts(s.paper_saved_pct) : "");
}

int run_sweep(const RealFields& fields, const Request& request) {
  std::vector<Summary> summaries;
  int failures = 0;
  for (const double width_m : request.widths_m)
    for (const double radius_m : request.radii_m) {
      Machine machine;
      machine.width_m = width_m;
      machine.radius_m = radius_m;
      const std::vector<ObstacleRun> runs = sweep(fields, request.field_id, machine);
      report_runs(runs, machine);
      summaries.push_back(summary_of(runs, machine));
      report_line(summaries.back());
      // No plan at all is no success.
      failures += summaries.back().failures + (summaries.back().plans == 0 ? 1 : 0);
    }
  print_table(summaries);
  print_paper_table(summaries);
  return failures > 0 ? 1 : 0;
}

int run(const std::vector<std::string>& words) {
  const std::optional<Request> request = request_in(words);
  if (!request) {
    fmt::print(stderr, "usage: obstacle_sweep [--width LIST] [--radius LIST] [--field ID] | --stop-prices\n");
    return 2;
  }
  const auto fields = read_or_say();
  if (!fields) return 0;
  return request->stop_prices ? run_stop_prices(*fields) : run_sweep(*fields, *request);
}

}  // namespace
}  // namespace tramline::testing

int main(int argc, char** argv) { return tramline::testing::run({argv + 1, argv + argc}); }
