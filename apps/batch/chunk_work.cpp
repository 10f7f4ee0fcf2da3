#include "batch/chunk_work.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "report/plan_report.h"
#include "report/report_parts.h"
#include "request/field_key.h"
#include "tramline/geometry/error.h"
#include "tramline/io/plan/write_plans.h"
#include "tramline/planner/plan_field.h"

namespace tramline::app {
namespace {

using nlohmann::ordered_json;

struct Result {
  std::optional<Plan> plan;
  std::string refusal;
};

Result planned(const Field& field, const AskedPlans& asked) {
  constexpr int kThisThread = 1;
  try {
    return {plan_field(field, asked.machine(), asked.objective(), asked.settings_on(field), kThisThread), ""};
  } catch (const Error& error) {
    return {std::nullopt, error.what()};
  }
}

/// The figures of a plan. What is a list of pieces of the plan is in the plan file.
ordered_json figures_of(const Plan& plan) {
  ordered_json out = plan_json(plan, {}, 0);
  for (const char* key : {"seconds", "encounters", "reference", "references"}) out.erase(key);
  if (out.contains("route")) out["route"].erase("legs");
  return out;
}

std::string line_of(const ordered_json& result) { return json_line(versioned(result)) + '\n'; }

std::string line_of(const Field& field, const Result& result) {
  return line_of(with_field_names(
      field, result.plan ? figures_of(*result.plan) : ordered_json{{"error", result.refusal}}));
}

/// Fields farther apart than this have no plane in common, degrees.
constexpr double kOnePlane_deg = 10;

bool lie_near(const LocalFrame& a, const LocalFrame& b) {
  return std::abs(std::remainder(a.origin_lon_deg - b.origin_lon_deg, 360.0)) <= kOnePlane_deg &&
         std::abs(a.origin_lat_deg - b.origin_lat_deg) <= kOnePlane_deg;
}

/// In one file, or, where fields of the chunk lie in several parts of the world, in one for each.
void write_plans_of(const std::vector<io::KeyedPlan>& plans, const BatchFolder& folder, long long chunk) {
  std::vector<std::vector<io::KeyedPlan>> parts;
  for (const io::KeyedPlan& plan : plans) {
    const auto part = std::find_if(parts.begin(), parts.end(), [&](const std::vector<io::KeyedPlan>& others) {
      return lie_near(others.front().plan->field.frame, plan.plan->field.frame);
    });
    if (part == parts.end())
      parts.push_back({plan});
    else
      part->push_back(plan);
  }
  for (std::size_t i = 0; i < parts.size(); ++i) io::write_plans(parts[i], folder.plans_of(chunk, i));
}

FieldInput input_of(const ChunkRequest& request, RawDataset features) {
  FieldOptions options = request.field;
  options.all = true;
  options.in_memory = std::make_shared<const RawDataset>(std::move(features));
  return load_fields(options);
}

}  // namespace

ChunkCounts work_on_chunk(const ChunkRequest& request, RawDataset features, const BatchFolder& folder,
                          long long chunk) {
  FieldInput input;
  if (!features.layers.empty()) input = input_of(request, std::move(features));
  AskedPlans asked = request.asked;
  asked.read_files(request.plan, {}, input);
  std::vector<Result> results(input.fields.size());
  tbb::parallel_for(std::size_t{0}, results.size(),
                    [&](std::size_t i) { results[i] = planned(input.fields[i], asked); });
  ChunkCounts counts;
  counts.refused = input.refusals.size();
  std::string lines;
  std::vector<io::KeyedPlan> plans;
  for (const Refusal& refusal : input.refusals)
    lines += line_of(refusal_json(input.file, input.layer, refusal));
  for (std::size_t i = 0; i < results.size(); ++i) {
    lines += line_of(input.fields[i], results[i]);
    if (results[i].plan) plans.push_back({field_key(input.fields[i]), &*results[i].plan});
  }
  if (!input.skipped.empty()) lines += line_of({{"skipped", skipped_json(input.skipped)}});
  counts.planned = plans.size();
  counts.refused += results.size() - plans.size();
  write_plans_of(plans, folder, chunk);
  folder.finish(chunk, lines);
  return counts;
}

}  // namespace tramline::app
