#pragma once
// Reads the tracks of GPX files.

#include <string>
#include <string_view>
#include <vector>

#include "tramline/io/fixes/log_job.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// The track points of a GPX file (1.0 or 1.1) in order; each segment is a unit of its own. Speed and course
/// are read where the point has them, also in extensions, and the course is taken as a heading above
/// kCourseHolds_mps. Points far from the others of their track are skipped. Fix::record counts track points
/// from 1. Throws bad_input for damaged XML, for a file without a possible track point, and beyond
/// kMostXmlTree, kMostFixes and kMostLogs. O(size).
WorkLog read_gpx_log(std::string_view text, const std::string& place);

/// The same, each job by itself (fixes/job_groups.h): tracks on different land or days are separate jobs.
std::vector<LogJob> read_gpx_jobs(std::string_view text, const std::string& place);

}  // namespace tramline::io
