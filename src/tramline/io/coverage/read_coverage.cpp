#include "tramline/io/coverage/read_coverage.h"

#include <fmt/format.h>

#include <limits>

#include "tramline/geometry/error.h"
#include "tramline/io/coverage/coverage_layers.h"
#include "tramline/io/coverage/coverage_metadata.h"
#include "tramline/io/gdal/start_gdal.h"
#include "tramline/io/geopackage/gdal_errors.h"
#include "tramline/io/geopackage/local_crs.h"
#include "tramline/io/geopackage/rows.h"

namespace tramline::io {
namespace {

namespace layers = coverage_layers;

double number_or_nan(const Row& row, const char* column) {
  return row.number_if_any(column).value_or(std::numeric_limits<double>::quiet_NaN());
}

void read_region(Rows& file, const char* name, Region& into) {
  file.each(name, [&](const Row& row) { into.push_back(row.polygon()); });
}

void read_multiplicity(Rows& file, Coverage& out) {
  std::array<bool, kMostCounted + 1> seen{};
  file.each(layers::kMultiplicity, [&](const Row& row) {
    const int times = row.whole("times");
    if (times < 1 || times > kMostCounted)
      throw bad_input(fmt::format("{} is {}, expected 1 to {}", row.place_of("times"), times, kMostCounted));
    const auto index = static_cast<std::size_t>(times);
    if (seen[index]) throw bad_input(fmt::format("{} is {} again", row.place_of("times"), times));
    seen[index] = true;
    if (row.has_shape()) out.worked_times[index] = row.region();
  });
}

void read_gaps(Rows& file, Coverage& out) {
  file.each(layers::kGaps, [&](const Row& row) {
    Gap gap;
    gap.number = row.whole("number");
    gap.shape = row.polygon();
    gap.area_m2 = row.number("area_m2");
    gap.centre = Point{row.number("x"), row.number("y")} - row.offset();
    gap.widest_m = number_or_nan(row, "widest_m");
    out.gaps.push_back(std::move(gap));
  });
}

void read_track(Rows& file, Coverage& out) {
  file.each(layers::kTrack, [&](const Row& row) {
    DrivenLine driven;
    const std::optional<int> run = row.whole_if_any("run");
    if (run && *run < 1)
      throw bad_input(fmt::format("{} is {}: runs count from 1", row.place_of("run"), *run));
    driven.run = run.value_or(0) - 1;
    if (row.has_shape()) driven.line = row.line();
    driven.from_s = number_or_nan(row, "from_s");
    driven.to_s = number_or_nan(row, "to_s");
    out.lines.push_back(std::move(driven));
  });
}

void read_slices(Rows& file, Coverage& out) {
  if (!file.has(layers::kSlices)) return;
  file.each(layers::kSlices, [&](const Row& row) {
    CoverageSlice slice;
    CoverageAreas& areas = slice.areas;
    slice.fixes = row.count("fixes");
    areas.gross_m2 = number_or_nan(row, "gross_m2");
    areas.covered_m2 = number_or_nan(row, "covered_m2");
    areas.covered_inside_m2 = number_or_nan(row, "covered_inside_m2");
    areas.outside_m2 = number_or_nan(row, "outside_m2");
    areas.repeated_m2 = number_or_nan(row, "repeated_m2");
    areas.sliver_m2 = number_or_nan(row, "sliver_m2");
    areas.missed_m2 = number_or_nan(row, "missed_m2");
    if (row.has("not_recorded_m2")) areas.not_recorded_m2 = number_or_nan(row, "not_recorded_m2");
    for (std::size_t times = 0; times < areas.worked_times_m2.size(); ++times)
      areas.worked_times_m2[times] = number_or_nan(row, fmt::format("worked_times_{}_m2", times).c_str());
    slice.covered_rings = row.count("covered_rings");
    slice.missed_regions = row.count("missed_regions");
    slice.seconds = number_or_nan(row, "seconds");
    out.slices.push_back(slice);
  });
}

}  // namespace

Coverage read_coverage(const std::filesystem::path& path) {
  GdalErrors errors;
  Rows file(path, kCoverageFile, errors);
  Coverage out;
  Metadata metadata;
  file.each(layers::kMetadata, [&](const Row& row) { metadata[row.text("key")] = row.text("value"); });
  apply_metadata(metadata, path, out);
  file.shift_by(offset_of(out.frame));

  read_region(file, layers::kField, out.field);
  read_region(file, layers::kCovered, out.covered);
  read_region(file, layers::kRepeated, out.repeated);
  read_region(file, layers::kMissed, out.missed);
  if (metadata.contains(layers::kNotRecordedArea)) read_region(file, layers::kNotRecorded, out.not_recorded);
  read_multiplicity(file, out);
  read_gaps(file, out);
  read_track(file, out);
  read_slices(file, out);
  return out;
}

bool is_coverage_file(const std::filesystem::path& path) {
  if (!EQUAL(path.extension().c_str(), ".gpkg")) return false;
  const GdalErrors errors;
  start_gdal();
  RegisterOGRGeoPackage();
  const char* const drivers[] = {"GPKG", nullptr};
  const GDALDatasetUniquePtr file(
      GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, nullptr, nullptr));
  return file != nullptr && file->GetLayerByName(layers::kMultiplicity) != nullptr &&
         file->GetLayerByName(layers::kMetadata) != nullptr;
}

}  // namespace tramline::io
