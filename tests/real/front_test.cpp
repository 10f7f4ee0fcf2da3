// Fronts of ten real fields: what a chart of them needs to hold.

#include <gtest/gtest.h>

#include <cmath>

#include "real/real_fields.h"
#include "tramline/geometry/error.h"
#include "tramline/planner/pareto/trade_off.h"

namespace tramline {
namespace {

/// Neither less than nothing nor a zero with a sign, which a square root or a logarithm makes no number of.
void expect_area(double area_m2) {
  EXPECT_GE(area_m2, 0);
  EXPECT_FALSE(std::signbit(area_m2));
}

TEST(RealFronts, NoPlanMissesOrRepeatsLessThanNothing) {
  const auto fields = testing::read_real_fields();
  if (!fields) GTEST_SKIP() << testing::no_real_fields();
  const Crs crs(fields->dataset.layers.front().crs);
  Machine machine;
  machine.width_m = 12;
  std::size_t looked_at = 0;
  for (std::size_t i = 3; i < fields->features().size() && looked_at < 10; i += 11) {
    for (const Field& field : testing::admitted(*fields, crs, fields->features()[i])) {
      if (area_m2(field) > 8e4) continue;
      SCOPED_TRACE(field.id);
      try {
        const TradeOff found = trade_off(field, machine, {}, {}, 1);
        for (const FrontPoint& point : found.front.points) {
          expect_area(point.tally.overlap_m2);
          expect_area(point.tally.uncovered_m2);
        }
        ++looked_at;
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::kBadInput);  // too small for the machine
      }
    }
  }
  EXPECT_GE(looked_at, 10U);
}

}  // namespace
}  // namespace tramline
