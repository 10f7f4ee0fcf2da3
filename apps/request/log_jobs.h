#pragma once
// The selected jobs of a log, and the field of each.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "request/evaluate_input.h"
#include "request/field_input.h"
#include "tramline/io/fixes/log_job.h"
#include "tramline/io/log/read_log.h"

namespace tramline::app {

/// One job with its number among those of its file.
struct NumberedJob {
  io::LogJob job;
  std::size_t number = 1;  ///< from 1
  std::size_t of = 1;
};

/// All jobs of a log, or the one with the number. Names do not say in which folder the log lies. Throws
/// kBadInput like io::read_jobs(), and for a number that is not among them.
std::vector<NumberedJob> jobs_of(const std::string& file, const io::LogOptions& options,
                                 std::optional<std::size_t> number);

/// "TLG00006, TLG00007 (task 'jk', field PFD-7, Harvester), 2020-01-03 00:00 to 01:43"
std::string job_title(const io::LogJob& job);

/// "2020-01-03T00:00:11"; empty for a time that is not known.
std::string date_text(double time_s);

/// The options for the field of a job: where field and log are of the same task set and nothing was chosen in
/// it, the partfield the job was recorded on, if it has a boundary.
FieldOptions field_of_job(FieldOptions options, const std::string& log_file, const io::LogJob& job);

/// Whether any fix lies near the ground; true without ground. Throws kBadInput where only one of the two is
/// in plain metres.
bool lies_near(const WorkLog& log, const WorkGround& ground);

}  // namespace tramline::app
