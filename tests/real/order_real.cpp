// In which order the pieces of plans of every curated real field are driven: how long the hops between them
// are, as a ratio to those of a nearest-neighbour tour over the same ends.
//
//   order_real [--each]
//
// Straight tracks and those that --curved auto chooses, 6 and 12 m wide, without and with a headland pass.
// With --each a line for every plan. Exit code 1 where a ratio is above 1.2.

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "real/order_runs.h"
#include "real/real_fields.h"
#include "real/spread.h"

namespace tramline::testing {
namespace {

std::string in_words(const OrderScenario& scenario) {
  return fmt::format("w {:g} m, {} headland passes, {}", scenario.width_m, scenario.headlands,
                     name(scenario.shape));
}

/// The summary of one scenario; how many plans have hops that are too long.
int report(const OrderScenario& scenario, const std::vector<OrderRun>& runs, bool each) {
  std::vector<double> ratios;
  int above = 0, hops = 0, through = 0, outside = 0;
  std::string worst = "none";
  for (const OrderRun& run : runs) {
    if (!run.planned) continue;
    if (ratios.empty() || run.ratio() > *std::max_element(ratios.begin(), ratios.end())) worst = run.field_id;
    ratios.push_back(run.ratio());
    above += run.ratio() > kMostHops ? 1 : 0;
    hops += run.hops.count;
    through += run.hops.through_obstacles;
    outside += run.hops.far_outside;
    if (each || run.ratio() > kMostHops)
      fmt::print(
          "  {} ({}): {} pieces, hops {:.1f} m, nearest neighbour {:.1f} m, ratio {:.3f}, {} through "
          "obstacles, {} far outside\n",
          run.field_id, in_words(scenario), run.pieces, run.hops.length_m, run.nearest_neighbour_m,
          run.ratio(), run.hops.through_obstacles, run.hops.far_outside);
  }
  fmt::print(
      "{}: {} plans; hops to nearest neighbour median {:.3f}, 95 % {:.3f}, most {:.3f} ({}); {} above "
      "{}; of {} hops {} through obstacles, {} far outside\n",
      in_words(scenario), ratios.size(), median(ratios), quantile(ratios, 0.95),
      ratios.empty() ? 0 : *std::max_element(ratios.begin(), ratios.end()), worst, above, kMostHops, hops,
      through, outside);
  return above;
}

int run(int argc, char** argv) {
  const auto fields = read_or_say();
  if (!fields) return 0;
  const bool each = argc > 1 && std::string(argv[1]) == "--each";
  int above = 0;
  for (const TrackShape shape : {TrackShape::kStraight, TrackShape::kAuto})
    for (const int headlands : {0, 1})
      for (const double width_m : {6.0, 12.0}) {
        const OrderScenario scenario{width_m, headlands, shape};
        const auto runs =
            for_each_field(*fields, [&](const Field& field) { return run_order(field, scenario); });
        above += report(scenario, runs, each);
      }
  return above > 0 ? 1 : 0;
}

}  // namespace
}  // namespace tramline::testing

int main(int argc, char** argv) { return tramline::testing::run(argc, argv); }
