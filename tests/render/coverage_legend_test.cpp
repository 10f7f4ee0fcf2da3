#include "tramline/render/coverage/coverage_legend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "io/coverage/two_passes.h"

namespace tramline::render {
namespace {

std::map<std::string, std::string> values(const Coverage& coverage) {
  std::map<std::string, std::string> out;
  for (const LegendBlock& block : legend_of(coverage))
    for (const LegendRow& row : block.rows)
      if (row.symbol == Symbol::kNone) out[row.text] = row.value;
  return out;
}

std::multiset<Symbol> symbols(const Coverage& coverage) {
  std::multiset<Symbol> out;
  for (const LegendBlock& block : legend_of(coverage))
    for (const LegendRow& row : block.rows)
      if (row.symbol != Symbol::kNone) out.insert(row.symbol);
  return out;
}

// 1440/1600 = 90 %, 160/1600 = 10 %, 160/1540 = 10.39 %; 1540 m² in 42.5 s are 13.04 ha in an hour.
TEST(CoverageLegend, AreasHaveTheirUnitsAndShares) {
  const auto value = values(two_passes());
  EXPECT_EQ(value.at("field"), "0.16 ha");
  EXPECT_EQ(value.at("covered, of the field"), "0.14 ha · 90.00 %");
  EXPECT_EQ(value.at("missed, of the field"), "160 m² · 10.00 %");
  EXPECT_EQ(value.at("repeated, of all covered"), "160 m² · 10.39 %");
  EXPECT_EQ(value.at("covered outside it"), "100 m²");
  EXPECT_EQ(value.at("working width"), "20 m");
  EXPECT_EQ(value.at("runs"), "2");
  EXPECT_EQ(value.at("time working"), "0:01 h");
  EXPECT_EQ(value.at("covered in an hour"), "13.04 ha");
  EXPECT_EQ(value.at("fixes used"), "4 of 5");
  EXPECT_FALSE(value.contains("worked twice in bends"));
}

TEST(CoverageLegend, ShowsOnlyTheSymbolsThatOccur) {
  EXPECT_EQ(
      symbols(two_passes()),
      (std::multiset<Symbol>{Symbol::kField, Symbol::kCovered, Symbol::kOverlap, Symbol::kUncovered,
                             Symbol::kCoveredOutside, Symbol::kWorkedPath, Symbol::kIdlePath, Symbol::kGap}));
  Coverage coverage = two_passes();
  coverage.field.clear();
  coverage.missed.clear();
  coverage.gaps.clear();
  coverage.lines.resize(1);
  coverage.areas = {1540, 1540, 0, 1540, 0, 0, 0, 0, {}};
  coverage.worked_s = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(symbols(coverage), (std::multiset<Symbol>{Symbol::kCovered, Symbol::kWorkedPath}));
  const auto value = values(coverage);
  EXPECT_EQ(value.at("covered"), "0.15 ha");
  EXPECT_FALSE(value.contains("field"));
  EXPECT_FALSE(value.contains("missed, of the field"));
  EXPECT_FALSE(value.contains("time working"));
}

TEST(CoverageLegend, TwelveGapsAreListedAndTheRestSummed) {
  Coverage coverage = two_passes();
  coverage.gaps.clear();
  for (int i = 1; i <= 15; ++i) coverage.gaps.push_back({i, {}, 100.0 - i, {}, 0.5});
  const LegendBlock block = legend_of(coverage).back();
  EXPECT_EQ(block.heading, "Largest gaps");
  ASSERT_EQ(block.rows.size(), 13u);
  EXPECT_EQ(block.rows[11].index, 11);
  EXPECT_EQ(block.rows[11].text, "0.50 m wide");
  EXPECT_EQ(block.rows[11].value, "88.0 m²");
  EXPECT_EQ(block.rows[12].text, "and 3 smaller");
  EXPECT_EQ(block.rows[12].value, "258 m²");  // 87 + 86 + 85
}

TEST(CoverageLegend, HoursHaveMinutes) {
  EXPECT_EQ(duration_text(0), "0:00 h");
  EXPECT_EQ(duration_text(3 * 3600 + 25 * 60 + 20), "3:25 h");
  EXPECT_EQ(duration_text(3599), "1:00 h");
  EXPECT_EQ(duration_text(100 * 3600), "100:00 h");
}

}  // namespace
}  // namespace tramline::render
