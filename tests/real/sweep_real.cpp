// Plans and verifies every curated real field under one scenario of Versleijen and all four end rules.
//
//   TRAMLINE_SCENARIO=1 sweep_real [END_RULE]
//
// Prints a line for everything that is not well and a summary; exit code 1 when a plan fails.

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "real/real_fields.h"
#include "real/spread.h"

namespace tramline::testing {
namespace {

std::vector<Outcome> sweep(const RealFields& fields, int scenario_number, EndRule end_rule) {
  std::vector<std::vector<Outcome>> by_feature(fields.features().size());
  tbb::parallel_for(std::size_t{0}, by_feature.size(), [&](std::size_t i) {
    // A CRS object serves one thread at a time.
    thread_local const Crs crs(fields.dataset.layers.front().crs);
    const std::string scratch =
        (std::filesystem::temp_directory_path() / fmt::format("tramline-sweep-{}-{}.gpkg", getpid(), i))
            .string();
    by_feature[i] = plan_and_verify(fields, crs, fields.features()[i], scenario_number, end_rule, scratch);
  });
  std::vector<Outcome> out;
  for (const auto& parts : by_feature) out.insert(out.end(), parts.begin(), parts.end());
  return out;
}

/// Versleijen's kind of field: with obstacles, 1 to 22 ha.
bool like_the_papers(const Outcome& outcome) {
  return outcome.refused.empty() && outcome.obstacles > 0 && outcome.field_m2 >= 1e4 &&
         outcome.field_m2 <= 22e4;
}

int report(const std::vector<Outcome>& outcomes, int scenario_number, EndRule end_rule) {
  int failed = 0, refused = 0;
  std::vector<double> overlap, uncovered, seconds;
  for (const Outcome& outcome : outcomes) {
    for (const std::string& violation : outcome.violations)
      fmt::print("  {} violates {}\n", outcome.field_id, violation);
    if (!outcome.refused.empty()) fmt::print("  {} refused: {}\n", outcome.field_id, outcome.refused);
    failed += outcome.violations.empty() ? 0 : 1;
    refused += outcome.refused.empty() ? 0 : 1;
    if (outcome.refused.empty()) seconds.push_back(outcome.seconds);
    if (!like_the_papers(outcome)) continue;
    overlap.push_back(outcome.overlap_pct);
    uncovered.push_back(outcome.uncovered_pct);
  }
  fmt::print(
      "scenario {} {}: {} plans, {} fail, {} refused; median of {} fields with obstacles, 1-22 ha: overlap "
      "{:.3f} %, "
      "uncovered {:.3f} %; planning median {:.3f} s, longest {:.2f} s\n",
      scenario_number, name(end_rule), outcomes.size(), failed, refused, overlap.size(), median(overlap),
      median(uncovered), median(seconds),
      seconds.empty() ? 0 : *std::max_element(seconds.begin(), seconds.end()));
  return failed;
}

int run(int argc, char** argv) {
  const auto fields = read_or_say();
  if (!fields) return 0;
  const char* number = std::getenv("TRAMLINE_SCENARIO");
  const int scenario_number = number != nullptr ? std::atoi(number) : 1;
  int failed = 0;
  for (const EndRule rule : {EndRule::kCentre, EndRule::kCover, EndRule::kInside, EndRule::kCheapest})
    if (argc < 2 || end_rule_named(argv[1]) == rule)
      failed += report(sweep(*fields, scenario_number, rule), scenario_number, rule);
  return failed > 0 ? 1 : 0;
}

}  // namespace
}  // namespace tramline::testing

int main(int argc, char** argv) { return tramline::testing::run(argc, argv); }
