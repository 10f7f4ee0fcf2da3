// Maps every curated real field with headlands, straight and curved, and verifies the plans.
//
//   map_real [--width W] [--headlands N]
//
// Prints a line for everything that is not well and a summary; exit code 1 when a plan fails, when the areas
// do not add up, when curved tracks were chosen though they cost more, or when a straight map that is to
// cover everything leaves anything.

#include <fmt/format.h>

#include <cstdlib>
#include <string>

#include "real/real_fields.h"
#include "tramline/geometry/error.h"
#include "tramline/planner/plan_field.h"

namespace tramline::testing {
namespace {

struct Request {
  double width_m = 6;
  int headlands = 1;
};

struct Outcome {
  std::vector<std::string> faults;
  bool planned = false;
  bool curved = false;
};

void verify(const Plan& plan, const char* what, std::vector<std::string>& faults) {
  for (const std::string& fault : faults_of(plan)) faults.push_back(fmt::format("{}: {}", what, fault));
  if (std::abs(identity_error_m2(plan)) > 1e-6 * area(plan.body))
    faults.push_back(fmt::format("{}: areas miss by {} m²", what, identity_error_m2(plan)));
}

Outcome map(const Field& field, const Request& request) {
  Outcome out;
  PlanSettings settings;
  settings.strategy = Strategy::kSweep;
  settings.headlands = request.headlands;
  settings.obstacle_headlands = request.headlands;
  try {
    settings.end_rule = EndRule::kCover;
    const Plan covering = plan_field(field, {"", request.width_m, 6, 0}, {}, settings, 1);
    verify(covering, "straight, cover", out.faults);
    if (covering.given_up.empty() && covering.track_tally.uncovered_m2 > 1e-6 * area(covering.body))
      out.faults.push_back(fmt::format("cover leaves {} m²", covering.track_tally.uncovered_m2));
    settings.end_rule = EndRule::kCheapest;
    const Plan straight = plan_field(field, {"", request.width_m, 6, -1}, {}, settings, 1);
    settings.shape = TrackShape::kAuto;
    const Plan best = plan_field(field, {"", request.width_m, 6, -1}, {}, settings, 1);
    verify(best, "auto", out.faults);
    out.curved = is_curved(best);
    if (best.cost > straight.cost)
      out.faults.push_back(fmt::format("auto costs {:.6f}, straight {:.6f}", best.cost, straight.cost));
    out.planned = true;
  } catch (const Error& error) {
    add_failure(error, out.faults);
  }
  print_faults(field, out.faults);
  return out;
}

int run(int argc, char** argv) {
  const auto fields = read_or_say();
  if (!fields) return 0;
  Request request;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string word = argv[i];
    if (word == "--width") request.width_m = std::atof(argv[i + 1]);
    if (word == "--headlands") request.headlands = std::atoi(argv[i + 1]);
  }
  int planned = 0, curved = 0, failed = 0;
  for (const Outcome& one :
       for_each_field(*fields, [&](const Field& field) { return map(field, request); })) {
    planned += one.planned ? 1 : 0;
    curved += one.curved ? 1 : 0;
    failed += one.faults.empty() ? 0 : 1;
  }
  fmt::print("w {:g} m, {} headland passes: {} fields mapped, {} with curved tracks, {} fail\n",
             request.width_m, request.headlands, planned, curved, failed);
  return failed > 0 ? 1 : 0;
}

}  // namespace
}  // namespace tramline::testing

int main(int argc, char** argv) { return tramline::testing::run(argc, argv); }
