#include "tramline/io/log/columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "tramline/geometry/error.h"
#include "tramline/io/fixes/number_text.h"

namespace tramline::io {
namespace {

constexpr double kKmh = 1 / 3.6, kKnot = 1852.0 / 3600, kMph = 0.44704, kFoot = 0.3048, kInch = 0.0254;
constexpr double kRadian = 180 / std::numbers::pi;
// To amounts a hectare; an acre is 4046.8564224 m², a gallon that of the United States.
constexpr double kAcre_ha = 0.40468564224;
constexpr double kAnAcre = 1 / kAcre_ha, kGallonsAnAcre = 3.785411784 / kAcre_ha,
                 kPoundsAnAcre = 0.45359237 / kAcre_ha;

struct Name {
  std::string_view name;
  LogColumn column;
  double factor = 1;
  bool unit_named = false;
  PositionNames positions = PositionNames::kEither;
  AmountUnit amount = AmountUnit::kUnknown;
};

// Commoner names first; "kmh" and the like are units, not words of their own.
constexpr auto kDegrees = PositionNames::kDegrees, kMetres = PositionNames::kMetres,
               kEither = PositionNames::kEither;
using enum LogColumn;
constexpr auto kLitres = AmountUnit::kLitres, kKilograms = AmountUnit::kKilograms,
               kSeeds = AmountUnit::kSeeds;
constexpr Name kNames[] = {
    {"lon", kLon, 1, true, kDegrees},
    {"longitude", kLon, 1, true, kDegrees},
    {"long", kLon, 1, true, kDegrees},
    {"lng", kLon, 1, true, kDegrees},
    {"lon_deg", kLon, 1, true, kDegrees},
    {"longitude_deg", kLon, 1, true, kDegrees},
    {"gps_lon", kLon, 1, true, kDegrees},
    {"gps_longitude", kLon, 1, true, kDegrees},
    {"x", kLon, 1, false, kEither},
    {"x_m", kLon, 1, true, kMetres},
    {"easting", kLon, 1, true, kMetres},
    {"east", kLon, 1, true, kMetres},
    {"easting_m", kLon, 1, true, kMetres},
    {"east_m", kLon, 1, true, kMetres},
    {"lat", kLat, 1, true, kDegrees},
    {"latitude", kLat, 1, true, kDegrees},
    {"lat_deg", kLat, 1, true, kDegrees},
    {"latitude_deg", kLat, 1, true, kDegrees},
    {"gps_lat", kLat, 1, true, kDegrees},
    {"gps_latitude", kLat, 1, true, kDegrees},
    {"y", kLat, 1, false, kEither},
    {"y_m", kLat, 1, true, kMetres},
    {"northing", kLat, 1, true, kMetres},
    {"north", kLat, 1, true, kMetres},
    {"northing_m", kLat, 1, true, kMetres},
    {"north_m", kLat, 1, true, kMetres},
    {"time", kTime},
    {"timestamp", kTime},
    {"time_stamp", kTime},
    {"datetime", kTime},
    {"date_time", kTime},
    {"gps_time", kTime},
    {"gpstime", kTime},
    {"utc_time", kTime},
    {"time_utc", kTime},
    {"utc", kTime},
    {"isotime", kTime},
    {"iso_time", kTime},
    {"time_s", kTime},
    {"time_ms", kTime, 1e-3, true},
    {"timestamp_ms", kTime, 1e-3, true},
    {"epoch", kTime},
    {"unix_time", kTime},
    {"date", kDate},
    {"gps_date", kDate},
    {"utc_date", kDate},
    {"heading", kHeading},
    {"heading_deg", kHeading, 1, true},
    {"heading_rad", kHeading, kRadian, true},
    {"course", kCourse},
    {"course_deg", kCourse, 1, true},
    {"cog", kCourse},
    {"track", kCourse},
    {"track_deg", kCourse, 1, true},
    {"bearing", kHeading},
    {"azimuth", kHeading},
    {"speed", kSpeed},
    {"speed_mps", kSpeed, 1, true},
    {"speed_m_s", kSpeed, 1, true},
    {"speed_ms", kSpeed, 1, true},
    {"speed_kmh", kSpeed, kKmh, true},
    {"speed_km_h", kSpeed, kKmh, true},
    {"speed_kph", kSpeed, kKmh, true},
    {"speed_knots", kSpeed, kKnot, true},
    {"speed_kn", kSpeed, kKnot, true},
    {"speed_mph", kSpeed, kMph, true},
    {"velocity", kSpeed},
    {"width_m", kWidth, 1, true},
    {"width_mm", kWidth, 1e-3, true},
    {"width_cm", kWidth, 1e-2, true},
    {"width_ft", kWidth, kFoot, true},
    {"width_in", kWidth, kInch, true},
    {"width", kWidth},
    {"working_width", kWidth},
    {"working_width_m", kWidth, 1, true},
    {"working_width_mm", kWidth, 1e-3, true},
    {"swath_m", kWidth, 1, true},
    {"swath_mm", kWidth, 1e-3, true},
    {"swath_ft", kWidth, kFoot, true},
    {"swath_in", kWidth, kInch, true},
    {"swath_width_m", kWidth, 1, true},
    {"swath_width_ft", kWidth, kFoot, true},
    {"swath_width_in", kWidth, kInch, true},
    {"swath_width", kWidth},
    {"swath", kWidth},
    {"swath_raw", kWidth},
    {"swathwidth", kWidth},
    {"swth_wdth", kWidth},
    {"work_state", kWork},
    {"workstate", kWork},
    {"state", kWork},
    {"work", kWork},
    {"working", kWork},
    {"is_working", kWork},
    {"recording", kWork},
    {"work_status", kWork},
    {"working_state", kWork},
    {"implement_state", kWork},
    {"implement_status", kWork},
    {"implement_position", kWork},
    {"in_out", kWork},
    {"sections", kSections},
    {"section_states", kSections},
    {"sections_from_right", kSectionsFromRight},
    {"sections_condensed", kCondensed},
    {"condensed_work_state", kCondensed},
    {"ddi_161", kCondensed},
    {"rate_l_ha", kRate, 1, true, kEither, kLitres},
    {"rate_l_per_ha", kRate, 1, true, kEither, kLitres},
    {"rate_kg_ha", kRate, 1, true, kEither, kKilograms},
    {"rate_kg_per_ha", kRate, 1, true, kEither, kKilograms},
    {"rate_gal_ac", kRate, kGallonsAnAcre, true, kEither, kLitres},
    {"rate_lb_ac", kRate, kPoundsAnAcre, true, kEither, kKilograms},
    {"rate_seeds_ha", kRate, 1, true, kEither, kSeeds},
    {"rate_seeds_ac", kRate, kAnAcre, true, kEither, kSeeds},
    {"applied_rate_l_ha", kRate, 1, true, kEither, kLitres},
    {"applied_rate_kg_ha", kRate, 1, true, kEither, kKilograms},
    {"applied_rate_gal_ac", kRate, kGallonsAnAcre, true, kEither, kLitres},
    {"applied_rate_lb_ac", kRate, kPoundsAnAcre, true, kEither, kKilograms},
    {"applied_rate_seeds_ac", kRate, kAnAcre, true, kEither, kSeeds},
    {"applied_rate", kRate},
    {"actual_rate", kRate},
    {"application_rate", kRate},
    {"rate", kRate},
    {"device_area", kCounterArea},
    {"counter_area", kCounterArea},
    {"area_counter", kCounterArea},
    {"total_area", kCounterArea},
    {"area_total", kCounterArea},
    {"distance", kDistance},
    {"dist", kDistance},
    {"dist_raw", kDistance},
    {"dist_m", kDistance, 1, true},
    {"distance_m", kDistance, 1, true},
    {"machine", kMachine},
    {"machine_id", kMachine},
    {"vehicle", kMachine},
    {"vehicle_id", kMachine},
    {"device", kMachine},
    {"section_id", kSection},
    {"section", kSection},
    {"row_id", kSection},
    {"row", kSection},
    {"unit", kUnit},
    {"unit_id", kUnit},
    {"pass_id", kPass},
    {"pass", kPass},
    {"pass_num", kPass},
};

/// "Speed (km/h)" is speed_km_h.
std::string plain_name(std::string_view name) {
  std::string out;
  for (const char c : lower_case(name)) {
    const bool is_word = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (c & 0x80) != 0;
    if (is_word)
      out += c;
    else if (!out.empty() && out.back() != '_')
      out += '_';
  }
  if (out.ends_with('_')) out.pop_back();
  return out;
}

/// What may follow the name of a column, and what it is in metres or square metres.
struct Unit {
  std::string_view suffix;
  double factor;
  bool of_area = false;
};
constexpr double kAcre_m2 = 1e4 * kAcre_ha;
constexpr Unit kUnits[] = {{"_m", 1},          {"_metre", 1},           {"_metres", 1},
                           {"_meter", 1},      {"_meters", 1},          {"_mm", 1e-3},
                           {"_cm", 1e-2},      {"_ft", kFoot},          {"_feet", kFoot},
                           {"_foot", kFoot},   {"_in", kInch},          {"_inch", kInch},
                           {"_inches", kInch}, {"_m2", 1, true},        {"_sqm", 1, true},
                           {"_ha", 1e4, true}, {"_ac", kAcre_m2, true}, {"_acres", kAcre_m2, true}};

/// A width, a distance or an area whose name ends in a unit: swath_raw_in.
std::optional<Name> known_with_unit(std::string_view plain) {
  for (const Unit& unit : kUnits) {
    if (!plain.ends_with(unit.suffix)) continue;
    const std::string_view stem = plain.substr(0, plain.size() - unit.suffix.size());
    for (const Name& candidate : kNames) {
      const bool measured = unit.of_area ? candidate.column == kCounterArea
                                         : candidate.column == kWidth || candidate.column == kDistance;
      if (candidate.name != stem || !measured || candidate.unit_named) continue;
      Name out = candidate;
      out.factor = unit.factor;
      out.unit_named = true;
      return out;
    }
  }
  return std::nullopt;
}

std::optional<Name> known(std::string_view name) {
  const std::string plain = plain_name(name);
  for (const Name& candidate : kNames)
    if (candidate.name == plain) return candidate;
  return known_with_unit(plain);
}

std::string listed(std::span<const std::string> names) {
  constexpr std::size_t kMost = 40;
  std::string out;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i)
    out += (out.empty() ? "" : ", ") + std::string(trimmed(names[i]).substr(0, 40));
  if (names.size() > kMost) out += fmt::format(" and {} more", names.size() - kMost);
  return out;
}

std::optional<std::size_t> index_of(std::span<const std::string> names, std::string_view wanted) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (trimmed(names[i]) == wanted) return i;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (plain_name(names[i]) == plain_name(wanted)) return i;
  return std::nullopt;
}

void use(ColumnMap& map, const Name& name, std::size_t index) {
  map.uses[static_cast<std::size_t>(name.column)] = {index, name.factor, name.unit_named, name.amount};
  if (name.column == LogColumn::kLon || (name.column == LogColumn::kLat && map.position_names == kEither))
    map.position_names = name.positions;
}

/// Applies "lon=Xcoord,lat=Ycoord"; returns the columns it speaks of.
std::vector<LogColumn> apply_wanted(ColumnMap& map, std::span<const std::string> names,
                                    std::string_view wanted, const std::string& place) {
  std::vector<LogColumn> spoken_of;
  while (!wanted.empty()) {
    const std::size_t comma = wanted.find(',');
    const std::string_view part = trimmed(wanted.substr(0, comma));
    wanted = comma == std::string_view::npos ? std::string_view() : wanted.substr(comma + 1);
    if (part.empty()) continue;
    const std::size_t equals = part.find('=');
    const std::optional<Name> name = known(part.substr(0, equals));
    if (equals == std::string_view::npos || !name)
      throw bad_input(
          fmt::format("--columns: '{}' is not understood; write for example "
                      "lon=Xcoord,lat=Ycoord,time=T,width_mm=W",
                      part));
    spoken_of.push_back(name->column);
    const std::string_view column = trimmed(part.substr(equals + 1));
    if (column.empty()) continue;
    const auto index = index_of(names, column);
    if (!index)
      throw bad_input(fmt::format("{} has no column '{}', which --columns names; found {}", place, column,
                                  listed(names)));
    Name as_wanted = *name;
    // x=Xcoord says which column it is, not that it holds metres.
    if (as_wanted.column == LogColumn::kLon || as_wanted.column == LogColumn::kLat) {
      const std::string word = plain_name(part.substr(0, equals));
      as_wanted.positions = word == "lon" || word == "lat" ? kEither : as_wanted.positions;
    }
    use(map, as_wanted, *index);
  }
  return spoken_of;
}

}  // namespace

ColumnMap map_columns(std::span<const std::string> names, const std::string& wanted, PositionSource positions,
                      const std::string& place) {
  ColumnMap map;
  const std::vector<LogColumn> spoken_of = apply_wanted(map, names, wanted, place);
  std::vector<std::string> plain;
  for (const std::string& name : names) plain.push_back(plain_name(name));
  // What was given a meaning has no other.
  for (const auto& wanted_use : map.uses)
    if (wanted_use) plain[wanted_use->index].clear();
  for (const Name& name : kNames) {
    if (map[name.column] || std::find(spoken_of.begin(), spoken_of.end(), name.column) != spoken_of.end())
      continue;
    const auto at = std::find(plain.begin(), plain.end(), name.name);
    if (at != plain.end()) use(map, name, static_cast<std::size_t>(at - plain.begin()));
  }
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const std::optional<Name> name = known_with_unit(plain[i]);
    if (name && !map[name->column] &&
        std::find(spoken_of.begin(), spoken_of.end(), name->column) == spoken_of.end())
      use(map, *name, i);
  }
  if (positions == PositionSource::kElsewhere) return map;
  for (const auto& [column, word, other] : {std::tuple(LogColumn::kLon, "lon", "longitude, x or easting"),
                                            std::tuple(LogColumn::kLat, "lat", "latitude, y or northing")})
    if (!map[column])
      throw bad_input(fmt::format("{} has no column '{}' (nor {}); name it with --columns {}=NAME; found {}",
                                  place, word, other, word, listed(names)));
  return map;
}

}  // namespace tramline::io
