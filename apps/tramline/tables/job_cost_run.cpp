#include "tables/job_cost_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "output/output_target.h"
#include "output/progress.h"
#include "output/result_output.h"
#include "output/search_end.h"
#include "report/job_cost_report.h"
#include "report/report_parts.h"
#include "tramline/geometry/error.h"
#include "tramline/io/geopackage/whole_file.h"
#include "tramline/planner/plan_field.h"
#include "tramline/planner/validate_request.h"
#include "tramline/render/plan/draw_plan.h"

namespace tramline::app {
namespace {

class Jobs {
 public:
  Jobs(const JobCostRun& run, const FieldInput& input, const PlanOptions& options)
      : run_(run), input_(input) {
    if (input.fields.empty()) return;
    const std::string& crs = input.fields.front().source.input_crs;
    guide_ = guide_of(options, crs);
    gates_ = gates_of(options, crs);
  }

  int work() {
    for (const Refusal& refusal : input_.refusals) refuse(refusal.field_id, refusal.sentence);
    for (const Field& field : input_.fields) {
      bool refused = false;
      for (const Machine& machine : run_.machines) refused = !planned(field, machine) || refused;
      refused_ += refused ? 1 : 0;
    }
    if (run_.json) print_json_line(job_cost_sums_json(jobs_));
    if (says_text() && has_head_) print_result(job_cost_sum_rows(jobs_));
    write();
    const std::size_t all = input_.fields.size() + input_.refusals.size();
    if (refused_ == 0) return 0;
    return refused_ < all ? 3 : 2;
  }

 private:
  bool says_text() const { return !run_.json && !run_.quiet; }

  void show(JobCost job) {
    if (run_.json)
      print_json_line(job_cost_json(job));
    else if (!job.refusal.empty())
      fmt::print(stderr, "{}", job_cost_row(job));
    else if (!run_.quiet)
      print_result((has_head_ ? "" : job_cost_head()) + job_cost_row(job));
    has_head_ = has_head_ || job.refusal.empty();
    jobs_.push_back(std::move(job));
  }

  void refuse(const std::string& field_id, const std::string& sentence) {
    ++refused_;
    show({field_id, "", 0, 0, {}, sentence});
  }

  bool planned(const Field& field, const Machine& machine) {
    JobCost job{field.id, machine_text(machine), 0, 0, {}, {}};
    try {
      ProgressLine progress(run_.quiet);
      PlanSettings settings = settings_for(run_.settings, guide_, field, machine);
      place_gates(gates_, field, settings);
      job = job_cost(plan_field(field, machine, run_.objective, settings, run_.threads,
                                [&, end = SearchEnd(run_.seconds)](int done, int total) {
                                  progress.show("planning " + field.id, done, total);
                                  return end.demand();
                                }));
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::kBadInput) throw;
      job.refusal = error.what();
    }
    const bool fine = job.refusal.empty();
    show(std::move(job));
    return fine;
  }

  void write() const {
    if (!run_.csv_file.empty()) {
      const std::string csv = job_cost_csv(jobs_);
      io::write_whole(run_.csv_file, std::as_bytes(std::span(csv)));
    }
    if (run_.pdf_file.empty()) return;
    JobCostCells cells = job_cost_cells(jobs_);
    render::draw_table({"What the work takes", subtitle(), std::move(cells.head), std::move(cells.rows),
                        std::move(cells.sums)},
                       run_.pdf_file);
  }

  /// "sprayer: 24 m at 2.9 m/s, 120 €/h"
  std::string subtitle() const {
    std::string out;
    for (const Machine& machine : run_.machines) {
      const Rates rates = rates_of(machine);
      out += fmt::format("{}{}: {:g} m at {:g} m/s, {:g} €/h", out.empty() ? "" : "; ", machine_text(machine),
                         machine.width_m, machine.turning.working_speed_mps, rates.price_per_hour);
      if (rates.fuel_l_per_h > 0)
        out += fmt::format(", {:.1f} l/h at {:g} €/l", rates.fuel_l_per_h, rates.fuel_price);
    }
    return out;
  }

  const JobCostRun& run_;
  const FieldInput& input_;
  std::optional<GuideLine> guide_;
  Gates gates_;
  std::vector<JobCost> jobs_;
  std::size_t refused_ = 0;
  bool has_head_ = false;
};

}  // namespace

int run_job_costs(const JobCostRun& run, const FieldOptions& fields, const PlanOptions& options) {
  for (const Machine& machine : run.machines) validate_request(machine, run.objective, run.settings);
  const std::vector<std::string> inputs{fields.file, fields.obstacles_file, fields.passable_file,
                                        options.machine_file, options.guide_file};
  require_writable(run.csv_file, "--table", {".csv"}, inputs);
  require_writable(run.pdf_file, "--pdf", {".pdf"}, inputs);
  const FieldInput input = load_fields(fields);
  const InterruptEndsSearches interruptible;
  return Jobs(run, input, options).work();
}

}  // namespace tramline::app
