#include "tramline/io/fixes/places.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tramline::io {
namespace {

constexpr double kStray_deg = 2;

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::string fault_of_lonlat(Point lonlat_deg) {
  if (!std::isfinite(lonlat_deg.x) || !std::isfinite(lonlat_deg.y)) return "no position";
  if (std::abs(lonlat_deg.y) > 90) return fmt::format("latitude {} is impossible", lonlat_deg.y);
  if (std::abs(lonlat_deg.x) > 180) return fmt::format("longitude {} is impossible", lonlat_deg.x);
  if (lonlat_deg == Point{0, 0}) return "longitude and latitude are 0";
  return {};
}

void skip_strays(WorkLog& log) {
  if (log.positions != Positions::kLonLat || log.fixes.size() < 3) return;
  // Longitudes as differences to the first one, so that a log across the 180th meridian holds together.
  const double first = log.fixes.front().position.x;
  const auto beside = [first](const Fix& fix) { return std::remainder(fix.position.x - first, 360.0); };
  std::vector<double> lon, lat;
  for (const Fix& fix : log.fixes) {
    lon.push_back(beside(fix));
    lat.push_back(fix.position.y);
  }
  const double middle_lon = median(std::move(lon)), middle_lat = median(std::move(lat));
  const double reach_lon = kStray_deg / std::max(std::cos(middle_lat * std::numbers::pi / 180), 1e-3);
  const auto strays = [&](const Fix& fix) {
    return std::abs(fix.position.y - middle_lat) > kStray_deg ||
           std::abs(std::remainder(beside(fix) - middle_lon, 360.0)) > reach_lon;
  };
  std::vector<Fix> kept;
  for (const Fix& fix : log.fixes)
    if (strays(fix))
      log.skipped.add(fix.record,
                      fmt::format("{:.7f}, {:.7f} is more than {} degrees from where most of the log is",
                                  fix.position.x, fix.position.y, kStray_deg));
    else
      kept.push_back(fix);
  log.fixes = std::move(kept);
}

}  // namespace tramline::io
