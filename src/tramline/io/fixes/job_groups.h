#pragma once
// Groups logs into jobs: the same land, machine and days.

#include <cstddef>
#include <string>
#include <vector>

#include "tramline/geometry/polygon/region.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// The most logs or tracks of one file, since each is compared with every other; more are refused.
inline constexpr std::size_t kMostLogs = 10'000;

/// Throws bad_input where there would be more than `most` of them at `place`; `what`: "tracks".
void require_room_for_log(std::size_t already, const char* what, const std::string& place,
                          std::size_t most = kMostLogs);

/// The data by which jobs are distinguished.
struct JobFacts {
  std::string field_id;              ///< empty: not named
  std::vector<std::string> devices;  ///< devices that worked; empty: not named
  double from_s = 0, to_s = 0;       ///< see WorkLog::clock; NaN without times
  Box lonlat;                        ///< of most fixes; empty without any
};

/// Times and box of a log's fixes; the box excludes the outermost hundredth on each side, which may be
/// strays. Precondition: longitude and latitude.
JobFacts facts_of(const WorkLog& log);

/// Whether two logs belong to one job: neither their named fields nor their machines differ, no whole day
/// lies between them, and their land is no further apart than 200 m (2 km where both name the field). A log
/// without fixes belongs to no job.
bool belong_together(const JobFacts& a, const JobFacts& b);

/// The indices of the logs of each job, ascending; jobs in the order of their first logs. Logs of one job
/// need not all belong together in pairs: one leads to the next. O(n²).
std::vector<std::vector<std::size_t>> job_groups(const std::vector<JobFacts>& logs);

}  // namespace tramline::io
