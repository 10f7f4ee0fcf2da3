#pragma once
// Reads any log of a machine as a WorkLog; the format is recognised from the file itself.

#include <string>
#include <vector>

#include "tramline/io/fixes/log_job.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// Information that the file does not contain.
struct LogOptions {
  /// The meaning of columns of a text, or of attributes of a vector file: "lon=Xcoord,lat=Ycoord,time=T".
  /// Columns not named here are found by their common names (docs/logs.md).
  std::string columns;
  /// CRS of x and y (anything Crs understands); positions come out as longitude and latitude. "none": plain
  /// metres. Empty: degrees where x and y can be degrees, plain metres otherwise.
  std::string crs;
  /// Which log of an ISOXML task set, for example "TLG00001", or which layer of a vector file; empty: all, in
  /// the order of the tasks, or the only layer with points.
  std::string log;
};

/// Reads CSV (.csv, .txt, also .gz), NMEA 0183, GPX, ISOXML (folder, TASKDATA.XML, zip, or one TLG*.xml or
/// .bin), the coverage of an AgOpenGPS field folder, and points of vector files (GeoJSON, GeoPackage,
/// Shapefile …; of a zip too). Records that cannot be used are listed in WorkLog::skipped, assumptions in
/// WorkLog::notes; the fixes are in the order of the file. Throws bad_input, in one sentence, for: a missing
/// file, a format that is not recognised, a column that is missing (naming those found), a log of that name
/// that is missing (naming those found), a file that expands to more than kMostExpanded bytes, and a file
/// without any usable fix. Prints nothing. O(size).
WorkLog read_log(const std::string& path, const LogOptions& options = {});

/// The same, job by job: logs of a task set from different fields, machines or days are separate jobs
/// (job_groups.h), and so are the tracks of a GPX file. Every other file is one job. The result is not empty.
/// Where there are several jobs, the name of each is that of the file and its logs. Throws bad_input like
/// read_log.
std::vector<LogJob> read_jobs(const std::string& path, const LogOptions& options = {});

/// The logs of an ISOXML task set in the order of its tasks; one entry without a name for other files.
/// Throws bad_input like read_log.
std::vector<LogEntry> list_logs(const std::string& path);

}  // namespace tramline::io
