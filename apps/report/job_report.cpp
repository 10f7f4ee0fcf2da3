#include "report/job_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace tramline::app {
namespace {

using nlohmann::ordered_json;

/// What all logs of the job have alike; null where they do not, or where it is not known.
ordered_json common(const io::LogJob& job, std::string io::LogEntry::*fact) {
  if (job.entries.empty() || (job.entries.front().*fact).empty()) return {};
  const std::string& first = job.entries.front().*fact;
  const bool all = std::all_of(job.entries.begin(), job.entries.end(),
                               [&](const io::LogEntry& entry) { return entry.*fact == first; });
  return all ? ordered_json(first) : ordered_json();
}

ordered_json date_json(const io::LogJob& job, double time_s) {
  const std::string text = job.clock == Clock::kUtc ? date_text(time_s) : "";
  return text.empty() ? ordered_json() : ordered_json(text);
}

}  // namespace

std::string job_heading(const NumberedJob& job) {
  return fmt::format("job {} of {}   {}\n", job.number, job.of, job_title(job.job));
}

namespace {

ordered_json facts_json(const NumberedJob& numbered) {
  const io::LogJob& job = numbered.job;
  std::vector<std::string> logs;
  for (const io::LogEntry& entry : job.entries) logs.push_back(entry.name);
  return {{"job", numbered.number},
          {"jobs", numbered.of},
          {"logs", logs},
          {"task_id", common(job, &io::LogEntry::task_id)},
          {"task_name", common(job, &io::LogEntry::task_name)},
          {"partfield", common(job, &io::LogEntry::field_id)},
          {"devices", job.devices},
          {"from", date_json(job, job.from_s)},
          {"to", date_json(job, job.to_s)}};
}

}  // namespace

ordered_json job_json(const NumberedJob& job, const Evaluation& evaluation) {
  ordered_json out = facts_json(job);
  out.update(evaluation_json(evaluation));
  return out;
}

ordered_json job_json(const NumberedJob& job, const std::string& why) {
  ordered_json out = facts_json(job);
  out["error"] = why;
  return out;
}

}  // namespace tramline::app
