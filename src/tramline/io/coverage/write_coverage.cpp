#include "tramline/io/coverage/write_coverage.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "tramline/geodesy/field_projection.h"
#include "tramline/io/coverage/coverage_layers.h"
#include "tramline/io/coverage/coverage_metadata.h"
#include "tramline/io/coverage/coverage_styles.h"
#include "tramline/io/geopackage/layer_styles.h"
#include "tramline/io/geopackage/table.h"
#include "tramline/io/geopackage/write_geopackage.h"

namespace tramline::io {
namespace {

namespace layers = coverage_layers;

struct Part {
  const Polygon* polygon;
  double area_m2;
  Box box;
};

/// The largest first; see write_coverage().
std::vector<Part> by_size(const Region& region) {
  std::vector<Part> out;
  out.reserve(region.size());
  for (const Polygon& polygon : region) out.push_back({&polygon, area(polygon), bounds(polygon.outer)});
  std::stable_sort(out.begin(), out.end(), [](const Part& a, const Part& b) {
    if (a.area_m2 != b.area_m2) return a.area_m2 > b.area_m2;
    if (a.box.min_x != b.box.min_x) return a.box.min_x < b.box.min_x;
    return a.box.min_y < b.box.min_y;
  });
  return out;
}

void write_field(const Target& target, const Coverage& coverage) {
  Table table(target.file, layers::kField, wkbPolygon, target.crs, {text("field_id"), kAreaColumn});
  for (const Part& part : by_size(coverage.field))
    table.add(target.shapes.polygon(*part.polygon), {coverage.field_id, part.area_m2});
}

void write_region(const Target& target, const char* name, const Region& region) {
  Table table(target.file, name, wkbPolygon, target.crs, {kAreaColumn});
  for (const Part& part : by_size(region)) table.add(target.shapes.polygon(*part.polygon), {part.area_m2});
}

/// An engine may know an area and not its shape; either makes a feature.
void write_multiplicity(const Target& target, const Coverage& coverage) {
  Table table(target.file, layers::kMultiplicity, wkbMultiPolygon, target.crs,
              {integer("times"), kAreaColumn});
  for (std::size_t times = 1; times < coverage.worked_times.size(); ++times) {
    const Region& region = coverage.worked_times[times];
    const double counted_m2 = coverage.areas.worked_times_m2[times];
    if (region.empty() && !(counted_m2 > 0)) continue;
    Region sorted;
    for (const Part& part : by_size(region)) sorted.push_back(*part.polygon);
    table.add(region.empty() ? nullptr : target.shapes.region(sorted),
              {static_cast<long long>(times), std::isnan(counted_m2) ? area(region) : counted_m2});
  }
}

void write_gaps(const Target& target, const Coverage& coverage) {
  Table table(target.file, layers::kGaps, wkbPolygon, target.crs,
              {integer("number"), kAreaColumn, real("widest_m"), real("x"), real("y"), real("lon_deg"),
               real("lat_deg")});
  std::optional<FrameProjection> projection;
  if (coverage.frame.geodetic && !coverage.gaps.empty()) projection.emplace(coverage.frame);
  for (const Gap& gap : coverage.gaps) {
    const Point at = gap.centre + target.offset;
    const auto lonlat = projection ? std::optional(projection->to_lonlat(gap.centre)) : std::nullopt;
    table.add(target.shapes.polygon(gap.shape),
              {gap.number + 0LL, gap.area_m2, number_unless_nan(gap.widest_m), at.x, at.y,
               lonlat ? Cell(lonlat->x) : Cell(), lonlat ? Cell(lonlat->y) : Cell()});
  }
}

double length_of(const std::vector<Point>& line) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) sum += distance(line[i], line[i + 1]);
  return sum;
}

/// A line of a GeoPackage has two points or more.
std::unique_ptr<OGRGeometry> shape_of(const Target& target, const std::vector<Point>& line) {
  if (line.empty()) return nullptr;
  return target.shapes.line(line.size() == 1 ? std::vector<Point>{line[0], line[0]} : line);
}

void write_track(const Target& target, const Coverage& coverage) {
  Table table(target.file, layers::kTrack, wkbLineString, target.crs,
              {integer("run"), real("from_s"), real("to_s"), real("length_m")});
  for (const DrivenLine& driven : coverage.lines)
    table.add(shape_of(target, driven.line),
              {driven.run < 0 ? Cell() : Cell(driven.run + 1LL), number_unless_nan(driven.from_s),
               number_unless_nan(driven.to_s), length_of(driven.line)});
}

void write_slices(const Target& target, const Coverage& coverage) {
  if (coverage.slices.empty()) return;
  Table table(
      target.file, layers::kSlices, wkbNone, nullptr,
      {count_of("fixes"), real("gross_m2"), real("covered_m2"), real("covered_inside_m2"), real("outside_m2"),
       real("repeated_m2"), real("sliver_m2"), real("missed_m2"), real("not_recorded_m2"),
       real("worked_times_0_m2"), real("worked_times_1_m2"), real("worked_times_2_m2"),
       real("worked_times_3_m2"), count_of("covered_rings"), count_of("missed_regions"), real("seconds")});
  static_assert(kMostCounted == 3);
  for (const CoverageSlice& slice : coverage.slices) {
    const CoverageAreas& areas = slice.areas;
    const auto& times = areas.worked_times_m2;
    table.add(nullptr, {static_cast<long long>(slice.fixes), number_unless_nan(areas.gross_m2),
                        number_unless_nan(areas.covered_m2), number_unless_nan(areas.covered_inside_m2),
                        number_unless_nan(areas.outside_m2), number_unless_nan(areas.repeated_m2),
                        number_unless_nan(areas.sliver_m2), number_unless_nan(areas.missed_m2),
                        number_unless_nan(areas.not_recorded_m2), number_unless_nan(times[0]),
                        number_unless_nan(times[1]), number_unless_nan(times[2]), number_unless_nan(times[3]),
                        static_cast<long long>(slice.covered_rings),
                        static_cast<long long>(slice.missed_regions), number_unless_nan(slice.seconds)});
  }
}

void write_metadata(const Target& target, const Coverage& coverage) {
  Table table(target.file, layers::kMetadata, wkbNone, nullptr, {text("key"), text("value")});
  for (const auto& [key, value] : metadata_of(coverage)) table.add(nullptr, {key, value});
}

void write_layers(const Target& target, const Coverage& coverage) {
  write_field(target, coverage);
  write_region(target, layers::kCovered, coverage.covered);
  write_region(target, layers::kRepeated, coverage.repeated);
  write_region(target, layers::kMissed, coverage.missed);
  write_region(target, layers::kNotRecorded, coverage.not_recorded);
  write_multiplicity(target, coverage);
  write_gaps(target, coverage);
  write_track(target, coverage);
  write_slices(target, coverage);
  write_metadata(target, coverage);
  write_styles(target.file, coverage_styles());
}

}  // namespace

void write_coverage(const Coverage& coverage, const std::filesystem::path& path) {
  write_geopackage(path, kCoverageFile, coverage.frame,
                   [&](const Target& target) { write_layers(target, coverage); });
}

}  // namespace tramline::io
