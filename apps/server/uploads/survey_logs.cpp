#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "report/report_parts.h"
#include "server/http/page_words.h"
#include "server/uploads/survey.h"
#include "tramline/coverage/drive/worked_drive.h"
#include "tramline/geometry/error.h"
#include "tramline/io/log/read_log.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

/// [west, south, east, north] of all fixes but the outermost hundredth on each side, among which the stray
/// ones are; null where the log is in plain metres, or says nowhere where it was. O(n).
ordered_json where_driven(const WorkLog& log) {
  if (log.positions != Positions::kLonLat) return {};
  std::vector<double> lon, lat;
  for (const Fix& fix : log.fixes) {
    const Point p = fix.position;
    const bool on_the_globe = std::abs(p.x) <= 180 && std::abs(p.y) <= 90 && (p.x != 0 || p.y != 0);
    if (!on_the_globe) continue;
    lon.push_back(p.x);
    lat.push_back(p.y);
  }
  if (lon.empty()) return {};
  const std::size_t stray = lon.size() / 100;
  const auto nth = [](std::vector<double>& of, std::size_t n) {
    std::nth_element(of.begin(), of.begin() + static_cast<std::ptrdiff_t>(n), of.end());
    return of[n];
  };
  const std::size_t last = lon.size() - 1 - stray;
  return {nth(lon, stray), nth(lat, stray), nth(lon, last), nth(lat, last)};
}

/// One log as the list of an upload has it.
ordered_json entry_json(const io::LogEntry& entry, const WorkLog& log) {
  constexpr double kNever = std::numeric_limits<double>::quiet_NaN();
  double from_s = kNever, to_s = kNever;
  for (const Fix& fix : log.fixes) {
    from_s = std::fmin(from_s, fix.time_s);
    to_s = std::fmax(to_s, fix.time_s);
  }
  const double width_m = coverage::widest_m(log, {});
  return {{"name", entry.name},
          {"task", entry.task_name},
          {"partfield", entry.field_id},
          {"fixes", log.fixes.size()},
          {"from_s", app::number_json(from_s)},
          {"to_s", app::number_json(to_s)},
          {"bbox", where_driven(log)},
          {"width_m", width_m > 0 ? app::number_json(width_m) : ordered_json()},
          {"refused", nullptr}};
}

}  // namespace

ordered_json survey_logs_of(const Upload& upload) {
  ordered_json logs = ordered_json::array();
  const std::vector<io::LogEntry> entries = io::list_logs(upload.path.string());
  for (const io::LogEntry& entry : entries) {
    io::LogOptions options;
    options.log = entry.name;
    try {
      logs.push_back(entry_json(entry, io::read_log(upload.path.string(), options)));
    } catch (const Error& error) {
      // One bad log of a task set does not make the others useless.
      if (entries.size() == 1) throw;
      ordered_json refused = entry_json(entry, {});
      refused["refused"] = upload.in_its_name(in_page_words(error.what()));
      logs.push_back(std::move(refused));
    }
  }
  return {{"logs", std::move(logs)}};
}

}  // namespace tramline::server
