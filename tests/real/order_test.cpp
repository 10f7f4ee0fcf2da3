// Real fields that are cut up by obstacles and legs: hops between pieces are hardly longer than those of a
// nearest-neighbour tour over the same ends. All of them, and more scenarios, are the business of order_real.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "real/order_runs.h"
#include "real/real_fields.h"

namespace tramline::testing {
namespace {

/// Ponds, pylons, legs and a road, and every thirtieth of the others.
std::vector<const RawFeature*> sample(const RealFields& fields) {
  const std::set<std::string> odd{"cz/12",    "cz/45",     "de-bb/13",  "de-sh/10",
                                  "de-sh/99", "sk/83",     "us-csb/55", "at-schlag/36",
                                  "bg/35",    "br-lem/88", "de-sh/51",  "isopy-big/0"};
  std::vector<const RawFeature*> out;
  for (std::size_t i = 0; i < fields.features().size(); ++i)
    if (odd.count(fields.features()[i].id) > 0 || i % 30 == 0) out.push_back(&fields.features()[i]);
  return out;
}

TEST(RealOrder, HopsAreNearNearestNeighbour) {
  const auto fields = read_real_fields();
  if (!fields) GTEST_SKIP() << no_real_fields();
  const Crs crs(fields->dataset.layers.front().crs);
  int planned = 0, number = 0;
  OrderRun worst;
  for (const RawFeature* feature : sample(*fields)) {
    const OrderScenario scenario{12, number++ % 2, TrackShape::kStraight};
    for (const Field& field : admitted(*fields, crs, *feature)) {
      const OrderRun run = run_order(field, scenario);
      planned += run.planned ? 1 : 0;
      EXPECT_LE(run.ratio(), kMostHops)
          << run.field_id << " with " << scenario.headlands << " headland passes";
      if (run.planned && (worst.pieces == 0 || run.ratio() > worst.ratio())) worst = run;
    }
  }
  EXPECT_GE(planned, 18);
  fmt::print("worst: {}, hops {:.1f} m, {:.3f} times nearest neighbour\n", worst.field_id,
             worst.hops.length_m, worst.ratio());
}

}  // namespace
}  // namespace tramline::testing
