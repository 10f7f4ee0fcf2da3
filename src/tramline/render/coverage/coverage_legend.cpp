#include "tramline/render/coverage/coverage_legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tramline/model/palette.h"

namespace tramline::render {
namespace {

// What rounding leaves of nothing.
constexpr double kLeastArea = 0.005;

std::string area_with_share(double area_m2, double whole_m2) {
  if (!(whole_m2 > 0)) return area_text(area_m2);
  return fmt::format("{} · {:.2f} %", area_text(area_m2), 100 * area_m2 / whole_m2);
}

bool has_obstacles(const Region& field) {
  return std::any_of(field.begin(), field.end(),
                     [](const Polygon& polygon) { return !polygon.holes.empty(); });
}

bool has_lines(const Coverage& coverage, bool working) {
  return std::any_of(coverage.lines.begin(), coverage.lines.end(), [&](const DrivenLine& driven) {
    return driven.line.size() > 1 && (driven.run >= 0) == working;
  });
}

LegendBlock symbols(const Coverage& coverage) {
  LegendBlock block{"Legend", {}};
  const auto add = [&](bool occurs, Symbol symbol, const char* text) {
    if (occurs) block.rows.push_back({symbol, 0, text, ""});
  };
  const bool field = !coverage.field.empty();
  const CoverageAreas& areas = coverage.areas;
  add(field, Symbol::kField, "field");
  add(has_obstacles(coverage.field), Symbol::kObstacle, "obstacle");
  add(!coverage.covered.empty(), Symbol::kCovered, "covered");
  add(areas.repeated_m2 > kLeastArea, Symbol::kOverlap, "repeated: worked again");
  add(field && areas.missed_m2 > kLeastArea, Symbol::kUncovered, "missed: not worked");
  add(areas.not_recorded_m2 > kLeastArea, Symbol::kNotRecorded, "not recorded: a hole in the log");
  add(field && areas.outside_m2 > kLeastArea, Symbol::kCoveredOutside, "covered outside the field");
  add(has_lines(coverage, true), Symbol::kWorkedPath, "driven and working");
  add(has_lines(coverage, false), Symbol::kIdlePath, "driven, not working");
  return block;
}

LegendBlock areas_of(const Coverage& coverage) {
  LegendBlock block{"Areas", {}};
  const auto add = [&](const char* text, std::string value) {
    block.rows.push_back({Symbol::kNone, 0, text, std::move(value)});
  };
  const CoverageAreas& areas = coverage.areas;
  if (!coverage.field.empty()) {
    const double field_m2 = area(coverage.field);
    add("field", area_text(field_m2));
    add("covered, of the field", area_with_share(areas.covered_inside_m2, field_m2));
    add("missed, of the field", area_with_share(areas.missed_m2, field_m2));
    if (areas.not_recorded_m2 > kLeastArea)
      add("not recorded, of the field", area_with_share(areas.not_recorded_m2, field_m2));
    add("covered outside it", area_text(areas.outside_m2));
  } else {
    add("covered", area_text(areas.covered_m2));
    if (areas.not_recorded_m2 > kLeastArea) add("not recorded", area_text(areas.not_recorded_m2));
  }
  add("repeated, of all covered", area_with_share(areas.repeated_m2, areas.covered_m2));
  if (areas.sliver_m2 > kLeastArea)
    add("worked twice in bends", area_with_share(areas.sliver_m2, areas.covered_m2));
  return block;
}

LegendBlock work_of(const Coverage& coverage) {
  LegendBlock block{"Work", {}};
  const auto add = [&](const char* text, std::string value) {
    block.rows.push_back({Symbol::kNone, 0, text, std::move(value)});
  };
  add("working width", fmt::format("{:g} m", coverage.width_m));
  add("runs", std::to_string(coverage.runs));
  if (coverage.worked_s > 0) {
    add("time working", duration_text(coverage.worked_s));
    add("covered in an hour",
        fmt::format("{:.2f} ha", coverage.areas.covered_m2 / 1e4 / (coverage.worked_s / 3600)));
  }
  if (coverage.fixes > 0)
    add("fixes used", coverage.fixes_used == coverage.fixes
                          ? fmt::format("all {}", coverage.fixes)
                          : fmt::format("{} of {}", coverage.fixes_used, coverage.fixes));
  return block;
}

LegendBlock gaps_of(const Coverage& coverage) {
  const std::size_t n = coverage.gaps.size();
  const std::size_t shown = std::min(n, static_cast<std::size_t>(kGapsNumbered));
  LegendBlock block{n > shown ? "Largest gaps" : "Gaps", {}};
  for (std::size_t i = 0; i < shown; ++i) {
    const Gap& gap = coverage.gaps[i];
    block.rows.push_back(
        {Symbol::kGap, gap.number - 1,
         std::isnan(gap.widest_m) ? std::string() : fmt::format("{:.2f} m wide", gap.widest_m),
         area_text(gap.area_m2)});
  }
  double rest_m2 = 0;
  for (std::size_t i = shown; i < n; ++i) rest_m2 += coverage.gaps[i].area_m2;
  if (shown < n)
    block.rows.push_back({Symbol::kNone, 0, fmt::format("and {} smaller", n - shown), area_text(rest_m2)});
  return block;
}

}  // namespace

std::string duration_text(double seconds) {
  const auto minutes = static_cast<long long>(std::llround(seconds / 60));
  return fmt::format("{}:{:02} h", minutes / 60, minutes % 60);
}

std::vector<LegendBlock> legend_of(const Coverage& coverage) {
  std::vector<LegendBlock> blocks{symbols(coverage), areas_of(coverage), work_of(coverage)};
  if (!coverage.gaps.empty()) blocks.push_back(gaps_of(coverage));
  return blocks;
}

}  // namespace tramline::render
