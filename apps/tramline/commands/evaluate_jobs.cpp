#include "commands/evaluate_jobs.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "output/result_output.h"
#include "report/job_report.h"
#include "report/report_parts.h"
#include "tramline/geometry/error.h"

namespace tramline::app {
namespace {

/// Prints results in their order, and nothing before the first job that could be evaluated.
class JobPrinter {
 public:
  explicit JobPrinter(JobPrint how) : how_(how) {}

  void evaluated(const NumberedJob& job, const Evaluation& evaluation) {
    any_ = true;
    add(job,
        how_.json ? json_line(versioned(job_json(job, evaluation))) + "\n" : evaluation_table(evaluation));
  }
  void left_out(const NumberedJob& job, const std::string& why) {
    add(job,
        how_.json ? json_line(versioned(job_json(job, why))) + "\n" : fmt::format("left out     {}\n", why));
  }
  bool any() const { return any_; }

 private:
  void add(const NumberedJob& job, const std::string& text) {
    if (how_.quiet && !how_.json) return;
    if (!how_.json) held_ += (first_ ? "" : "\n") + job_heading(job);
    first_ = false;
    held_ += text;
    if (any_) print_result(std::exchange(held_, {}));
  }

  JobPrint how_;
  bool first_ = true, any_ = false;
  std::string held_;
};

std::string name_of(const io::LogJob& job) { return job.entries.empty() ? "job" : job.entries.front().name; }

Error nowhere_near(const std::vector<NumberedJob>& jobs, const std::string& field_id) {
  return bad_input(
      fmt::format("none of the {} jobs lies near the field {}; give the field they were driven on",
                  jobs.size(), field_id));
}

}  // namespace

int evaluate_jobs(std::vector<NumberedJob> jobs, const JobWork& work, JobPrint print) {
  JobPrinter printer(print);
  std::optional<Error> refusal;
  std::string field_id;
  for (NumberedJob& job : jobs) {
    try {
      WorkGround ground = work.ground(job.job);
      field_id = ground.field_id;
      if (!lies_near(job.job.log, ground)) {
        printer.left_out(job, fmt::format("{} lies nowhere near the field {}", job.job.log.name, field_id));
        continue;
      }
      const Evaluation evaluation = work.evaluate(std::move(job.job.log), std::move(ground));
      work.write(evaluation, name_of(job.job));
      printer.evaluated(job, evaluation);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::kBadInput) throw;
      if (!refusal) refusal.emplace(error);
      printer.left_out(job, error.what());
    }
  }
  if (!printer.any()) throw refusal ? Error(*refusal) : nowhere_near(jobs, field_id);
  return refusal ? 3 : 0;
}

}  // namespace tramline::app
