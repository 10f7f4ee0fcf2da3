#include "tramline/io/coverage/coverage_metadata.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tramline/io/coverage/coverage_layers.h"
#include "tramline/io/geopackage/key_values.h"

namespace tramline::io {
namespace {

constexpr const char* kFormat = "tramline coverage";
constexpr int kFormatVersion = 2;
/// Older ones know nothing of ground that was not recorded.
constexpr int kOldestVersion = 1;
constexpr const char* kListedRecords = "skipped.listed";

/// The one list of keys, walked by the writer (const coverage) and by the reader.
template <class CoverageOrConst, class Visitor>
void each_value(CoverageOrConst& coverage, Visitor&& visit) {
  visit("log", coverage.log);
  visit("field.id", coverage.field_id);
  visit("frame.geodetic", coverage.frame.geodetic);
  visit("frame.origin_lon_deg", coverage.frame.origin_lon_deg);
  visit("frame.origin_lat_deg", coverage.frame.origin_lat_deg);
  visit("frame.origin_x_m", coverage.frame.origin_x_m);
  visit("frame.origin_y_m", coverage.frame.origin_y_m);
  visit("width_m", coverage.width_m);
  visit("engine", coverage.engine);
  auto& areas = coverage.areas;
  visit.number_if_any("areas.gross_m2", areas.gross_m2);
  visit.number_if_any("areas.covered_m2", areas.covered_m2);
  visit.number_if_any("areas.covered_inside_m2", areas.covered_inside_m2);
  visit.number_if_any("areas.outside_m2", areas.outside_m2);
  visit.number_if_any("areas.repeated_m2", areas.repeated_m2);
  visit.number_if_any("areas.sliver_m2", areas.sliver_m2);
  visit.number_if_any("areas.missed_m2", areas.missed_m2);
  for (std::size_t times = 0; times < areas.worked_times_m2.size(); ++times)
    visit.number_if_any(fmt::format("areas.worked_times_{}_m2", times), areas.worked_times_m2[times]);
  visit("fixes", coverage.fixes);
  visit("fixes_used", coverage.fixes_used);
  visit("runs", coverage.runs);
  visit.number_if_any("worked_s", coverage.worked_s);
  visit("skipped.count", coverage.skipped.count);
  visit("warnings", coverage.warnings);
}

class Writer : public KeyWriter {
 public:
  using KeyWriter::KeyWriter;
  using KeyWriter::operator();
  void operator()(const std::string& key, const std::vector<SkippedRecord>& records) const {
    nlohmann::json list = nlohmann::json::array();
    for (const SkippedRecord& skipped : records)
      list.push_back({{"record", skipped.record}, {"why", skipped.why}});
    out()[key] = dumped(list);
  }
};

std::vector<SkippedRecord> records_of(const KeyReader& reader, const std::string& key) {
  std::vector<SkippedRecord> out;
  reader.parse(key, [&](const nlohmann::json& list) {
    // A loop over something else than a list runs over its values.
    if (!list.is_array()) throw nlohmann::json::other_error::create(0, "no list", nullptr);
    for (const nlohmann::json& item : list)
      out.push_back({item.at("record").get<std::size_t>(), item.at("why").get<std::string>()});
  });
  return out;
}

}  // namespace

Metadata metadata_of(const Coverage& coverage) {
  Metadata out;
  const Writer writer(out);
  each_value(coverage, writer);
  writer.number_if_any(coverage_layers::kNotRecordedArea, coverage.areas.not_recorded_m2);
  writer(kListedRecords, coverage.skipped.listed);
  writer.number_if_any("worked_hours", coverage.worked_s / 3600);
  writer("program_version", std::string(TRAMLINE_VERSION));
  writer("format", std::string(kFormat));
  writer("format_version", kFormatVersion);
  return out;
}

void apply_metadata(const Metadata& metadata, const std::filesystem::path& file, Coverage& coverage) {
  const KeyReader reader(metadata, file, kCoverageFile);
  if (reader.text("format") != kFormat) throw reader.wrong("format", "'tramline coverage'");
  int version = 0;
  reader("format_version", version);
  if (version < kOldestVersion || version > kFormatVersion)
    throw reader.wrong("format_version", "1 or 2: read it with the tramline that wrote it");
  each_value(coverage, reader);
  if (version > kOldestVersion)
    reader.number_if_any(coverage_layers::kNotRecordedArea, coverage.areas.not_recorded_m2);
  coverage.skipped.listed = records_of(reader, kListedRecords);
}

}  // namespace tramline::io
