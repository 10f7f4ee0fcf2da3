#pragma once
// Which logs are of one job: the same land, machine and days.

#include <cstddef>
#include <string>
#include <vector>

#include "tramline/geometry/polygon/region.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// Refused beyond this: logs of one file, or tracks of one, since each is held against every other.
inline constexpr std::size_t kMostLogs = 10'000;

/// Throws bad_input where there would be more than `most` of them at `place`; `what`: "tracks".
void require_room_for_log(std::size_t already, const char* what, const std::string& place,
                          std::size_t most = kMostLogs);

/// What tells one job from another.
struct JobFacts {
  std::string field_id;              ///< empty: not named
  std::vector<std::string> devices;  ///< that worked; none: not named
  double from_s = 0, to_s = 0;       ///< see WorkLog::clock; NaN without times
  Box lonlat;                        ///< of most fixes; empty without any
};

/// Times and place of a log's fixes: of the box the outermost hundredths on either side are left out, which
/// may be strays. Precondition: longitude and latitude.
JobFacts facts_of(const WorkLog& log);

/// Whether two logs are of one job: neither the fields named nor the machines differ, no whole day lies
/// between them, and the land of the one is no further from that of the other than 200 m (2 km where both
/// name the field). A log without fixes is of no job.
bool belong_together(const JobFacts& a, const JobFacts& b);

/// The logs of each job by their places in the list, rising; jobs in the order of their first logs. Logs of
/// one job need not all belong together in pairs: one leads to the next. O(n²).
std::vector<std::vector<std::size_t>> job_groups(const std::vector<JobFacts>& logs);

}  // namespace tramline::io
