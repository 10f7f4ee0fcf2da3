#include "request/log_jobs.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <utility>

#include "tramline/geodesy/placed_log.h"
#include "tramline/geometry/error.h"
#include "tramline/io/isoxml/read_task_log.h"
#include "tramline/io/isoxml/task_files.h"

namespace tramline::app {
namespace {

/// The same result wherever the log lies.
std::string without_folder(const std::string& name, const std::string& file) {
  const std::string folder = file.substr(0, file.find_last_of('/') + 1);
  return name.starts_with(folder) ? name.substr(folder.size()) : name;
}

std::string listed(const std::vector<io::LogJob>& jobs) {
  std::string out;
  for (std::size_t i = 0; i < jobs.size(); ++i)
    out += fmt::format("{}{}: {}", i > 0 ? "; " : "", i + 1, job_title(jobs[i]));
  return out;
}

std::string period(double from_s, double to_s) {
  const std::string from = date_text(from_s), to = date_text(to_s);
  if (from.empty() || to.empty()) return "";
  constexpr std::size_t kDay = 10, kMinute = 16;
  const bool one_day = from.substr(0, kDay) == to.substr(0, kDay);
  std::string out =
      from.substr(0, kMinute) + " to " + (one_day ? to.substr(kDay + 1, 5) : to.substr(0, kMinute));
  std::replace(out.begin(), out.end(), 'T', ' ');
  return out;
}

}  // namespace

std::vector<NumberedJob> jobs_of(const std::string& file, const io::LogOptions& options,
                                 std::optional<std::size_t> number) {
  std::vector<io::LogJob> jobs = io::read_jobs(file, options);
  if (number && (*number == 0 || *number > jobs.size()))
    throw bad_input(jobs.size() == 1
                        ? fmt::format("--job {}: '{}' is one job; leave --job away", *number, file)
                        : fmt::format("--job {}: '{}' has the jobs {}", *number, file, listed(jobs)));
  std::vector<NumberedJob> out;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (number && *number != i + 1) continue;
    jobs[i].log.name = without_folder(jobs[i].log.name, file);
    out.push_back({std::move(jobs[i]), i + 1, jobs.size()});
  }
  return out;
}

std::string date_text(double time_s) {
  // Years 1900 to 9999: others are no dates of logs.
  constexpr double kFirst_s = -2208988800, kEnd_s = 253402300800;
  if (!(time_s >= kFirst_s && time_s < kEnd_s)) return "";
  const auto whole = static_cast<long long>(std::floor(time_s));
  const std::chrono::sys_seconds at{std::chrono::seconds(whole)};
  const auto day = std::chrono::floor<std::chrono::days>(at);
  const std::chrono::year_month_day date(day);
  const std::chrono::hh_mm_ss clock(at - day);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                     clock.hours().count(), clock.minutes().count(), clock.seconds().count());
}

std::string job_title(const io::LogJob& job) {
  std::vector<std::string> names, about;
  const auto add_once = [](std::vector<std::string>& list, std::string text) {
    if (std::find(list.begin(), list.end(), text) == list.end()) list.push_back(std::move(text));
  };
  for (const io::LogEntry& entry : job.entries) {
    add_once(names, entry.name);
    if (!entry.task_name.empty()) add_once(about, fmt::format("task '{}'", entry.task_name));
  }
  for (const io::LogEntry& entry : job.entries)
    if (!entry.field_id.empty()) add_once(about, "field " + entry.field_id);
  for (const std::string& device : job.devices) add_once(about, device);
  std::string out = fmt::format("{}", fmt::join(names, ", "));
  if (!about.empty()) out += fmt::format(" ({})", fmt::join(about, ", "));
  const std::string when = job.clock == Clock::kUtc ? period(job.from_s, job.to_s) : "";
  if (!when.empty()) out += ", " + when;
  return out;
}

FieldOptions field_of_job(FieldOptions options, const std::string& log_file, const io::LogJob& job) {
  std::error_code error;
  const bool chosen = !options.where.empty() || options.fid || !options.layer.empty();
  const std::string field_id = job.entries.empty() ? "" : job.entries.front().field_id;
  if (options.file.empty() || chosen || field_id.empty() || field_id.find('\'') != std::string::npos ||
      !std::filesystem::equivalent(options.file, log_file, error) ||
      !io::TaskFiles::looks_like_one(options.file))
    return options;
  const RawDataset partfields = io::read_partfields(options.file);
  const std::vector<RawFeature>& features = partfields.layers.front().features;
  if (std::any_of(features.begin(), features.end(),
                  [&](const RawFeature& feature) { return feature.id == field_id; }))
    options.where = fmt::format("id = '{}'", field_id);
  return options;
}

bool lies_near(const WorkLog& log, const WorkGround& ground) {
  return ground.ground.empty() || comes_near(log, ground.frame, bounds(ground.ground), kNear_m);
}

}  // namespace tramline::app
