// tramline evaluate: what was worked, worked again and missed.

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "commands/command.h"
#include "commands/evaluate_jobs.h"
#include "options/common_options.h"
#include "options/drive_options.h"
#include "options/field_options.h"
#include "output/output_target.h"
#include "output/progress.h"
#include "output/result_output.h"
#include "report/evaluate_report.h"
#include "report/evaluations.h"
#include "report/report_parts.h"
#include "request/evaluate_input.h"
#include "request/log_jobs.h"
#include "request/output_names.h"
#include "tramline/coverage/evaluate.h"
#include "tramline/geometry/error.h"
#include "tramline/io/coverage/write_coverage.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/render/coverage/draw_coverage.h"

namespace tramline::app {
namespace {

constexpr const char* kEvaluateHelp =
    "Evaluate a recorded drive, or the drive of a plan: which land was covered, repeated and missed.";
constexpr const char* kEvaluateExample =
    "Examples:\n"
    "  tramline evaluate spraying.csv --field fields.gpkg --where \"id='mill-field'\" --width 24 --picture "
    "done.png\n"
    "  tramline evaluate TASKDATA.zip --log TLG00001 --json -o coverage.gpkg\n"
    "  tramline evaluate TASKDATA.zip --field TASKDATA.zip --job 2\n"
    "  tramline evaluate --plan plan.gpkg\n"
    "  tramline evaluate spraying.csv --plan plan.gpkg --width 24\n"
    "  tramline evaluate spraying.csv --field field.geojson --with repair.gpkg\n"
    "Widths and work states of the log take precedence over --width. docs/logs.md describes the formats of "
    "logs.\n"
    "Paper: Zhang et al. 2023, Agronomy 13:1631.";

class EvaluateCommand : public Command {
 public:
  CommandOptions setup(CLI::App& program) override {
    CommandOptions command(program, "evaluate", kEvaluateHelp);
    command.add_option(
        "LOG", log_file_,
        "The drive: CSV, NMEA 0183, GPX, ISOXML task data (folder, zip or one time log), or points or worked "
        "polygons of a vector file; .gz too.");
    add_field_choice(command, field_);
    command.begin_group("Plan");
    Option plan =
        command.add_option("--plan", plan_file_, "A plan file: evaluate its drive, or compare LOG with it.");
    plan.takes("FILE").shows_default("none");
    command
        .add_option("--with", with_files_,
                    "A plan file, such as a repair, whose drive counts as done after that of LOG. May be "
                    "given several "
                    "times.")
        .takes("FILE")
        .one_value_each_time()
        .shows_default("none")
        .excludes(plan);
    command.begin_group("Log");
    command.add_option("--log", drive_.log.log, "Read this log of an ISOXML task set, such as TLG00001.")
        .takes("NAME")
        .shows_default("all logs of the job");
    command.add_option("--job", job_, "Read this job where a log has several.")
        .takes("N")
        .in_range(1, 1000000)
        .shows_default("the only job");
    add_drive_options(command, drive_);
    command.begin_group("Output");
    add_output_option(command, output_, "Write the coverage to this GeoPackage (.gpkg).");
    add_picture_option(command, picture_, "Draw the coverage to this .png, .svg or .pdf.");
    command.add_option("--slice", settings_.slice, "Also report the figures after every so many fixes.")
        .takes("N")
        .in_range(1, 1000000000)
        .shows_default("at the end only");
    add_report_options(command, json_, "Print one JSON object instead of the table.", quiet_);
    command.begin_group("Run");
    add_threads_option(command, settings_.threads);
    command.footer(kEvaluateExample);
    return command;
  }

  int run() override {
    if (log_file_.empty() && !with_files_.empty())
      throw bad_input("--with adds the drive of a plan to that of a log: name the log, or use --plan");
    if (log_file_.empty() && plan_file_.empty())
      throw bad_input("name a log to evaluate, or a plan with --plan");
    if (log_file_.empty() && !field_.file.empty())
      throw bad_input("--field goes with a log; a plan is evaluated on the land it was made for");
    std::vector<std::string> inputs{log_file_, field_.file, plan_file_};
    inputs.insert(inputs.end(), with_files_.begin(), with_files_.end());
    require_writable(output_, "--output", {".gpkg"}, inputs);
    require_writable(picture_, "--picture", {".png", ".svg", ".pdf"}, inputs);
    std::optional<Plan> plan;
    if (!plan_file_.empty()) plan = io::read_plan(plan_file_);
    if (log_file_.empty()) {
      const auto start = std::chrono::steady_clock::now();
      Evaluation evaluation = evaluation_of_plan(*plan, plan_file_, settings());
      finish(evaluation, start);
      write(evaluation, output_, picture_);
      print(evaluation);
      return 0;
    }
    std::vector<NumberedJob> jobs = jobs_of(log_file_, drive_.log, job_);
    if (jobs.size() > 1) return several(plan, std::move(jobs));
    const auto start = std::chrono::steady_clock::now();
    io::LogJob& job = jobs.front().job;
    WorkGround ground = ground_of(plan, job);
    Evaluation evaluation = drive(plan, std::move(job.log), std::move(ground));
    finish(evaluation, start);
    write(evaluation, output_, picture_);
    print(evaluation);
    return 0;
  }

 private:
  using TimePoint = std::chrono::steady_clock::time_point;

  void finish(Evaluation& evaluation, TimePoint start) const {
    evaluation.repeat = settings().repeat;
    evaluation.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  /// Each job by itself, with files of its own.
  int several(const std::optional<Plan>& plan, std::vector<NumberedJob> jobs) const {
    if (!with_files_.empty())
      throw bad_input(fmt::format("--with goes with one job and '{}' has {}; choose one with --job",
                                  log_file_, jobs.size()));
    OutputNames outputs(output_, Naming::kWithId), pictures(picture_, Naming::kWithId);
    JobWork work;
    work.ground = [&](const io::LogJob& job) { return ground_of(plan, job); };
    work.evaluate = [&](WorkLog log, WorkGround ground) {
      const auto start = std::chrono::steady_clock::now();
      Evaluation out = drive(plan, std::move(log), std::move(ground));
      finish(out, start);
      return out;
    };
    work.write = [&](const Evaluation& evaluation, const std::string& name) {
      write(evaluation, output_.empty() ? "" : outputs.next(name).string(),
            picture_.empty() ? "" : pictures.next(name).string());
    };
    return evaluate_jobs(std::move(jobs), work, {json_, quiet_});
  }

  coverage::EvaluateSettings settings() const {
    coverage::EvaluateSettings out = settings_;
    apply(drive_, out);
    out.shapes = !output_.empty() || !picture_.empty();
    return out;
  }

  /// Where the job was to work: none where neither a field nor a plan was given.
  WorkGround ground_of(const std::optional<Plan>& plan, const io::LogJob& job) const {
    if (const std::optional<WorkGround> field = work_ground(field_of_job(field_, log_file_, job)))
      return *field;
    return plan ? work_ground(*plan) : WorkGround{};
  }

  Evaluation drive(const std::optional<Plan>& plan, WorkLog read, WorkGround ground) const {
    std::vector<Plan> with;
    for (const std::string& file : with_files_) with.push_back(io::read_plan(file));
    ProgressLine progress(quiet_);
    const coverage::FixProgress show = shown_by(progress, read.name);
    const std::optional<NamedPlan> compared =
        plan ? std::optional<NamedPlan>({*plan, plan_file_}) : std::nullopt;
    Evaluation out =
        evaluation_of_drive(std::move(read), std::move(ground), {compared, with}, settings(), show);
    out.with = with_files_;
    return out;
  }

  /// `progress` has to outlive it.
  static coverage::FixProgress shown_by(ProgressLine& progress, const std::string& log) {
    return [&progress, what = "evaluating " + log](std::size_t done, std::size_t total) {
      progress.show(what, static_cast<int>(done), static_cast<int>(total), "fixes");
    };
  }

  static void write(const Evaluation& evaluation, const std::string& output, const std::string& picture) {
    if (!output.empty()) io::write_coverage(evaluation.coverage, output);
    if (!picture.empty()) render::draw_coverage(evaluation.coverage, picture);
  }

  void print(const Evaluation& evaluation) const {
    if (json_)
      print_json_line(evaluation_json(evaluation));
    else if (!quiet_)
      print_result(evaluation_table(evaluation));
  }

  FieldOptions field_;
  DriveOptions drive_;
  coverage::EvaluateSettings settings_;
  std::string log_file_, plan_file_, output_, picture_;
  std::vector<std::string> with_files_;
  std::optional<std::size_t> job_;
  bool json_ = false, quiet_ = false;
};

}  // namespace

std::unique_ptr<Command> make_evaluate_command() { return std::make_unique<EvaluateCommand>(); }

}  // namespace tramline::app
