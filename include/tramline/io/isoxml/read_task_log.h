#pragma once
// Reads the time logs and partfields of ISOXML task sets (ISO 11783-10, annex D).

#include <string>
#include <vector>

#include "tramline/io/fixes/log_job.h"
#include "tramline/model/raw_feature.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// The time log named `log` of a task set, or all of them in the order of its tasks, each with a unit of its
/// own. `path`: see TaskFiles::open(). Throws bad_input for a task set without time logs, for a name that is
/// not among them (listing those there are), for a log whose header or records are missing, and when no
/// record has a possible position. O(size).
WorkLog read_task_log(const std::string& path, const std::string& log);

/// The same, each job by itself (fixes/job_groups.h), in the order of their first logs; with a name given,
/// only the job of that log. Logs without a possible position are left out, which the notes of the first job
/// report. Throws like read_task_log(). O(size).
std::vector<LogJob> read_task_jobs(const std::string& path, const std::string& log);

/// The time logs of a task set. Those in a folder without TASKDATA.XML cannot be listed.
std::vector<LogEntry> list_task_logs(const std::string& path);

/// The partfields of a task set as fields: layer "partfields" with one feature for each, called by its
/// identifier ("PFD1"), and layer "obstacles" where there are some. Anything that cannot be read is listed in
/// `skipped`. Throws bad_input like TaskFiles::open(), and when there is no partfield with a boundary.
/// O(size).
RawDataset read_partfields(const std::string& path);

/// The guidance lines of a task set, of all its partfields: layer "guidance", each feature called by the
/// identifier of its pattern, its designator in the attribute "name". Anything that cannot be read is listed
/// in `skipped`. Throws bad_input like TaskFiles::open(), and where there is no line. O(size).
RawDataset read_guidance(const std::string& path);

}  // namespace tramline::io
