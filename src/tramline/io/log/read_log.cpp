#include "tramline/io/log/read_log.h"

#include <fmt/format.h>

#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/io/agopengps/sections_log.h"
#include "tramline/io/fixes/boom_list.h"
#include "tramline/io/fixes/lines.h"
#include "tramline/io/isoxml/read_task_log.h"
#include "tramline/io/log/csv_log.h"
#include "tramline/io/log/gpx_log.h"
#include "tramline/io/log/log_format.h"
#include "tramline/io/log/nmea_log.h"
#include "tramline/io/log/vector_log.h"

namespace tramline::io {
namespace {

/// Options that this kind of log has no use for are a mistake of who gave them.
void refuse_unused(const LogOptions& options, LogFormat format, const std::string& place) {
  const bool is_table = format == LogFormat::kCsv || format == LogFormat::kVector;
  const bool has_parts = format == LogFormat::kIsoxml || format == LogFormat::kVector;
  if (!options.columns.empty() && !is_table)
    throw bad_input(fmt::format("{} has no columns to be named with --columns", place));
  if (!options.crs.empty() && !is_table)
    throw bad_input(fmt::format("{} is in longitude and latitude; leave out --log-crs", place));
  if (!options.log.empty() && !has_parts)
    throw bad_input(fmt::format("{} is one log; leave out --log", place));
}

}  // namespace

WorkLog read_log(const std::string& path, const LogOptions& options) {
  const LogFormat format = log_format(path);
  const std::string place = "'" + path + "'";
  refuse_unused(options, format, place);
  WorkLog log;
  switch (format) {
    case LogFormat::kCsv: {
      FileLines lines(path);
      log = read_csv_log(lines, options.columns, options.crs, place);
      break;
    }
    case LogFormat::kNmea: {
      FileLines lines(path);
      log = read_nmea_log(lines, place);
      break;
    }
    case LogFormat::kGpx:
      log = read_gpx_log(whole_text(path), place);
      break;
    case LogFormat::kIsoxml:
      log = read_task_log(path, options.log);
      break;
    case LogFormat::kAgOpenGps:
      log = sections_log(*FieldFolder::open(path));
      break;
    case LogFormat::kVector:
      log = read_vector_log(path, options.log, options.columns, options.crs);
      break;
  }
  if (std::string note = note_on_wide(log.booms); !note.empty()) log.notes.push_back(std::move(note));
  log.name = options.log.empty() ? path : path + "/" + options.log;
  return log;
}

std::vector<LogJob> read_jobs(const std::string& path, const LogOptions& options) {
  const LogFormat format = log_format(path);
  std::vector<LogJob> jobs;
  if (format == LogFormat::kIsoxml || format == LogFormat::kGpx) {
    const std::string place = "'" + path + "'";
    refuse_unused(options, format, place);
    jobs = format == LogFormat::kIsoxml ? read_task_jobs(path, options.log)
                                        : read_gpx_jobs(whole_text(path), place);
  }
  if (jobs.empty()) jobs.emplace_back().log = read_log(path, options);
  for (LogJob& job : jobs) {
    std::vector<std::string> names;
    for (const LogEntry& entry : job.entries) names.push_back(entry.name);
    job.log.name = jobs.size() > 1       ? fmt::format("{}/{}", path, fmt::join(names, ", "))
                   : options.log.empty() ? path
                                         : path + "/" + options.log;
    if (format != LogFormat::kIsoxml && format != LogFormat::kGpx) continue;
    if (std::string note = note_on_wide(job.log.booms); !note.empty())
      job.log.notes.push_back(std::move(note));
  }
  return jobs;
}

std::vector<LogEntry> list_logs(const std::string& path) {
  if (log_format(path) == LogFormat::kIsoxml) return list_task_logs(path);
  return {LogEntry{}};
}

}  // namespace tramline::io
