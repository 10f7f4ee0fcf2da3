// Forty real fields with every oddity of the collection: planned, written, read back and verified.
// All of them, under every scenario and end rule, are the business of sweep_real.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "real/real_fields.h"

namespace tramline {
namespace {

using testing::Outcome;

/// The named oddities, then every n-th field, forty in all.
std::vector<const RawFeature*> sample(const testing::RealFields& fields) {
  const std::set<std::string> odd{"cz/45", "de-bb/13",  "sk/83",     "isopy-big/0", "cz/12",    "br-lem/23",
                                  "sk/32", "us-csb/16", "us-csb/18", "us-csb/30",   "us-csb/55"};
  std::vector<const RawFeature*> out;
  for (const RawFeature& feature : fields.features())
    if (odd.count(feature.id) > 0) out.push_back(&feature);
  const std::size_t step = std::max<std::size_t>(1, fields.features().size() / 30);
  for (std::size_t i = 0; i < fields.features().size() && out.size() < 40; i += step)
    if (odd.count(fields.features()[i].id) == 0) out.push_back(&fields.features()[i]);
  return out;
}

TEST(RealFields, SampleIsPlannedAndHolds) {
  const auto fields = testing::read_real_fields();
  if (!fields) GTEST_SKIP() << testing::no_real_fields();
  const Crs crs(fields->dataset.layers.front().crs);
  const std::string scratch =
      (std::filesystem::temp_directory_path() / fmt::format("tramline-sample-{}.gpkg", getpid())).string();
  int planned = 0;
  const auto chosen = sample(*fields);
  EXPECT_EQ(chosen.size(), 40u);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const int scenario = static_cast<int>(i % 3) + 1;
    const auto rule = static_cast<EndRule>(i % 4);
    for (const Outcome& outcome :
         testing::plan_and_verify(*fields, crs, *chosen[i], scenario, rule, scratch)) {
      EXPECT_TRUE(outcome.refused.empty()) << outcome.field_id << ": " << outcome.refused;
      for (const std::string& violation : outcome.violations)
        ADD_FAILURE() << outcome.field_id << ", scenario " << scenario << ", " << name(rule) << ": "
                      << violation;
      planned += outcome.pieces > 0 ? 1 : 0;
    }
  }
  EXPECT_GE(planned, 40);
}

}  // namespace
}  // namespace tramline
