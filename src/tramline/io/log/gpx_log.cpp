#include "tramline/io/log/gpx_log.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <pugixml.hpp>
#include <set>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/io/fixes/civil_time.h"
#include "tramline/io/fixes/course_heading.h"
#include "tramline/io/fixes/job_groups.h"
#include "tramline/io/fixes/most_fixes.h"
#include "tramline/io/fixes/number_text.h"
#include "tramline/io/fixes/places.h"
#include "tramline/io/fixes/xml_budget.h"

namespace tramline::io {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// "gpxtpx:speed" is "speed".
std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

/// The number in the child of this name, or in its like among the extensions, which some nest once more.
double number_below(const pugi::xml_node& node, std::string_view name, int depth = 0) {
  constexpr int kDeepest = 3;
  for (const pugi::xml_node child : node.children()) {
    if (local_name(child) == name) return number_in(child.child_value()).value_or(kNone);
    if (depth == 0 && local_name(child) != "extensions") continue;
    if (depth == kDeepest) continue;
    if (const double inner = number_below(child, name, depth + 1); !std::isnan(inner)) return inner;
  }
  return kNone;
}

pugi::xml_node child_called(const pugi::xml_node& node, std::string_view name) {
  for (const pugi::xml_node child : node.children())
    if (local_name(child) == name) return child;
  return {};
}

void add_point(const pugi::xml_node& point, int unit, std::size_t record, WorkLog& log) {
  const auto lon = number_in(point.attribute("lon").value()), lat = number_in(point.attribute("lat").value());
  const Point lonlat = {lon.value_or(kNone), lat.value_or(kNone)};
  if (std::string fault = fault_of_lonlat(lonlat); !fault.empty()) {
    log.skipped.add(record, std::move(fault));
    return;
  }
  Fix fix;
  fix.record = record;
  fix.position = lonlat;
  fix.unit = unit;
  fix.time_s = date_time_s(child_called(point, "time").child_value()).value_or(kNone);
  fix.speed_mps = number_below(point, "speed");
  fix.heading = heading_of_course(number_below(point, "course"), fix.speed_mps);
  if (!std::isnan(fix.time_s)) log.clock = Clock::kUtc;
  log.fixes.push_back(fix);
}

/// One track of a file.
struct Track {
  LogEntry entry;
  WorkLog log;
};

std::vector<Track> tracks_of(std::string_view text, const std::string& place) {
  require_bounded_xml(text, place);
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
  if (!parsed)
    throw bad_input(fmt::format("{} is damaged XML at byte {} ({}); fetch or export it again", place,
                                parsed.offset, parsed.description()));
  std::vector<Track> out;
  int unit = 0;
  std::size_t record = 0, skipped = 0, fixes = 0;
  const pugi::xml_node root = child_called(document, "gpx");
  for (const pugi::xml_node track : root.children()) {
    if (local_name(track) != "trk") continue;
    require_room_for_log(out.size(), "tracks", place);
    out.emplace_back();
    const std::string name(trimmed(child_called(track, "name").child_value()));
    out.back().entry.name = name.empty() ? fmt::format("track {}", out.size()) : name;
    WorkLog& log = out.back().log;
    for (const pugi::xml_node segment : track.children()) {
      if (local_name(segment) != "trkseg") continue;
      for (const pugi::xml_node point : segment.children()) {
        if (local_name(point) != "trkpt") continue;
        require_room_for_fix(fixes + log.fixes.size(), place);
        add_point(point, unit, ++record, log);
      }
      ++unit;
    }
    skip_strays(log);
    skipped += log.skipped.count;
    fixes += log.fixes.size();
  }
  if (fixes == 0)
    throw bad_input(
        fmt::format("{} has no track point with a possible position ({} were skipped); routes and "
                    "waypoints are no log",
                    place, skipped));
  return out;
}

/// One track after the other.
WorkLog joined(std::vector<Track> tracks) {
  WorkLog out;
  std::set<int> units;
  for (Track& track : tracks) {
    if (track.log.clock != Clock::kNone) out.clock = track.log.clock;
    for (const Fix& fix : track.log.fixes) units.insert(fix.unit);
    out.fixes.insert(out.fixes.end(), track.log.fixes.begin(), track.log.fixes.end());
    out.skipped.add(track.log.skipped);
  }
  if (units.size() > 1)
    out.notes.push_back(fmt::format("{} track segments: nothing is worked between them", units.size()));
  return out;
}

}  // namespace

WorkLog read_gpx_log(std::string_view text, const std::string& place) {
  return joined(tracks_of(text, place));
}

std::vector<LogJob> read_gpx_jobs(std::string_view text, const std::string& place) {
  std::vector<Track> tracks = tracks_of(text, place);
  std::vector<JobFacts> facts;
  for (const Track& track : tracks) facts.push_back(facts_of(track.log));
  std::vector<LogJob> out;
  SkippedRecords of_no_job;
  for (const std::vector<std::size_t>& group : job_groups(facts)) {
    LogJob job;
    std::vector<Track> of_job;
    for (const std::size_t i : group) {
      job.entries.push_back(tracks[i].entry);
      of_job.push_back(std::move(tracks[i]));
    }
    job.log = joined(std::move(of_job));
    if (job.log.fixes.empty()) {
      of_no_job.add(job.log.skipped);
      continue;
    }
    job.clock = job.log.clock;
    const JobFacts of_all = facts_of(job.log);
    job.from_s = of_all.from_s;
    job.to_s = of_all.to_s;
    out.push_back(std::move(job));
  }
  out.front().log.skipped.add(of_no_job);
  return out;
}

}  // namespace tramline::io
