// Headlands of every curated real field: drivable, in place and with areas that add up?
//
//   headland_sweep [WIDTH]...
//
// Prints a line for everything that is not well, and a summary and the ten fields of whose headland most
// stays unworked for each working width (4, 6 and 12 m without any) and number of passes; exit code 1 where
// something is not well.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

#include "headland/headland_faults.h"
#include "real/real_fields.h"
#include "real/spread.h"
#include "tramline/geometry/error.h"

namespace tramline::testing {
namespace {

constexpr double kRadius = 6;

struct Spreads {
  std::vector<double> uncovered_pct, overlap_pct, milliseconds;
  double slowest_per_corner_us = 0;
  std::vector<std::pair<double, std::string>> fields;  ///< by what stays unworked, %
  int failed = 0, without_body = 0, rings = 0;
};

std::size_t corners(const Field& field) {
  std::size_t out = field.outer.size();
  for (const Obstacle& obstacle : field.obstacles) out += obstacle.shape.outer.size();
  return out;
}

void look_at(const Field& field, double width_m, int passes, Spreads& out) {
  const HeadlandTerms terms = terms_of(field, width_m, kRadius, passes);
  try {
    const auto start = std::chrono::steady_clock::now();
    const HeadlandAndBody headland = headland_of(field, terms);
    const double ms = 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const auto faults = faults_of(field, terms, headland);
    for (const std::string& fault : faults)
      fmt::print("  {} (w {}, {} passes): {}\n", field.id, width_m, passes, fault);
    out.failed += faults.empty() ? 0 : 1;
    out.without_body += headland.body.empty() ? 1 : 0;
    out.rings += static_cast<int>(headland.passes.size());
    const double ground = std::max(1.0, area(headland.ground));
    out.uncovered_pct.push_back(100 * headland.uncovered_m2 / ground);
    out.fields.emplace_back(out.uncovered_pct.back(), field.id);
    out.overlap_pct.push_back(100 * headland.overlap_m2 / ground);
    out.milliseconds.push_back(ms);
    out.slowest_per_corner_us =
        std::max(out.slowest_per_corner_us, 1e3 * ms / static_cast<double>(corners(field)));
  } catch (const Error& error) {
    fmt::print("  {} (w {}, {} passes) failed: {}\n", field.id, width_m, passes, error.what());
    ++out.failed;
  }
}

void print_worst(std::vector<std::pair<double, std::string>> fields) {
  constexpr std::size_t kShown = 10;
  std::sort(fields.rbegin(), fields.rend());
  fields.resize(std::min(fields.size(), kShown));
  for (const auto& [share_pct, id] : fields) fmt::print("  {:.1f} % {}\n", share_pct, id);
  std::fflush(stdout);
}

int run(const std::vector<double>& widths_m) {
  const auto fields = read_or_say();
  if (!fields) return 0;
  const Crs crs(fields->dataset.layers.front().crs);
  int failed = 0;
  for (const double width_m : widths_m)
    for (const int passes : {1, 2}) {
      Spreads spreads;
      for (const RawFeature& feature : fields->features()) {
        try {
          for (const Field& field : admitted(*fields, crs, feature)) look_at(field, width_m, passes, spreads);
        } catch (const Error& error) {  // refused: the sweep of plans says so
          if (error.kind() != ErrorKind::kBadInput) throw;
        }
      }
      fmt::print(
          "w {} m, r {} m, {} passes: {} fields, {} fail, {} rings, {} without body; of the headland "
          "uncovered "
          "median {:.2f} %, 90 % {:.1f} %, most {:.1f} %; overlap median {:.3f} %, most {:.1f} %; median "
          "{:.2f} ms, longest "
          "{:.0f} "
          "ms, most per corner {:.0f} µs\n",
          width_m, kRadius, passes, spreads.milliseconds.size(), spreads.failed, spreads.rings,
          spreads.without_body, median(spreads.uncovered_pct), quantile(spreads.uncovered_pct, 0.9),
          *std::max_element(spreads.uncovered_pct.begin(), spreads.uncovered_pct.end()),
          median(spreads.overlap_pct),
          *std::max_element(spreads.overlap_pct.begin(), spreads.overlap_pct.end()),
          median(spreads.milliseconds),
          *std::max_element(spreads.milliseconds.begin(), spreads.milliseconds.end()),
          spreads.slowest_per_corner_us);
      print_worst(spreads.fields);
      failed += spreads.failed;
    }
  return failed == 0 ? 0 : 1;
}

}  // namespace
}  // namespace tramline::testing

int main(int count, char** words) {
  std::vector<double> widths_m;
  for (int i = 1; i < count; ++i) widths_m.push_back(std::atof(words[i]));
  return tramline::testing::run(widths_m.empty() ? std::vector<double>{4, 6, 12} : widths_m);
}
