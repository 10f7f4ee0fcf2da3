#include "output/plan_outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "request/field_key.h"
#include "request/output_names.h"
#include "tramline/geometry/error.h"
#include "tramline/io/plan/write_plan.h"
#include "tramline/io/plan/write_plans.h"
#include "tramline/render/plan/draw_plan.h"

namespace tramline::app {
namespace {

namespace fs = std::filesystem;

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw failure(fmt::format("folder '{}' for plans under way could not be made: {}", folder.string(),
                              error.message()));
}

}  // namespace

PlanOutputs::PlanOutputs(WantedFiles wanted, const std::vector<Field>& fields, Naming naming)
    : wanted_(std::move(wanted)), close_ups_(wanted_.close_ups) {
  OutputNames plans(wanted_.one_file ? parts_folder() / "plan.gpkg" : fs::path(wanted_.plan),
                    wanted_.one_file ? Naming::kWithId : naming);
  OutputNames pictures(wanted_.picture, naming);
  UniqueNames close_ups;
  for (const Field& field : fields)
    names_[field_key(field)] = {plans.next(field.id), pictures.next(field.id),
                                close_ups.next(as_file_name(field.id))};
}

fs::path PlanOutputs::parts_folder() const {
  const fs::path file = wanted_.plan;
  return file.parent_path() / fmt::format(".{}.parts", file.filename().string());
}

std::vector<std::string> PlanOutputs::write(const Plan& plan) {
  const Names& names = names_.at(field_key(plan.field));
  std::vector<std::string> out;
  if (!wanted_.plan.empty()) {
    io::write_plan(plan, names.plan);
    out.push_back(names.plan.string());
  }
  if (!wanted_.picture.empty()) {
    render::draw_plan(plan, names.picture);
    out.push_back(names.picture.string());
  }
  for (std::string& file : close_ups_.write(plan, names.close_ups)) out.push_back(std::move(file));
  return out;
}

fs::path PlanOutputs::record_file() const {
  const fs::path file = wanted_.plan.empty() ? wanted_.picture : wanted_.plan;
  if (!file.empty()) return file.parent_path() / (file.stem().string() + ".run.jsonl");
  return wanted_.close_ups.empty() ? fs::path() : fs::path(wanted_.close_ups) / "tramline.run.jsonl";
}

void PlanOutputs::begin(RunRecord& record, const std::vector<std::pair<std::string, std::string>>& made_from,
                        RunRecord::Start start) {
  if (!wanted_.one_file) return;
  const auto in_the_file = [&](const auto& field) {
    const FieldResult* found = record.finished(field.first, field.second);
    return found != nullptr && (found->refused || std::find(found->files.begin(), found->files.end(),
                                                            wanted_.plan) != found->files.end());
  };
  whole_is_current_ =
      start == RunRecord::Start::kResume && std::all_of(made_from.begin(), made_from.end(), in_the_file);
  if (whole_is_current_) return;
  // A plan that is only in an older whole would be missing among the parts.
  record.forget_those_in(wanted_.plan);
  std::error_code ignored;
  if (start == RunRecord::Start::kAnew) fs::remove_all(parts_folder(), ignored);
  make_folder(parts_folder());
}

void PlanOutputs::finish(RunRecord& record,
                         const std::vector<std::pair<std::string, std::string>>& made_from) {
  if (!wanted_.one_file || whole_is_current_) return;
  std::vector<io::KeptPlan> parts;
  struct Placed {
    std::string key, made_from;
    FieldResult result;
  };
  std::vector<Placed> placed;
  for (const auto& [key, from] : made_from) {
    const FieldResult* result = record.finished(key, from);
    if (result == nullptr || result->refused) continue;
    const std::string part = names_.at(key).plan.string();
    parts.push_back({key, part});
    FieldResult moved = *result;
    std::replace(moved.files.begin(), moved.files.end(), part, wanted_.plan);
    placed.push_back({key, from, std::move(moved)});
  }
  if (!parts.empty()) io::write_plans(parts, wanted_.plan);
  for (const Placed& plan : placed) record.add(plan.key, plan.made_from, plan.result);
  std::error_code ignored;
  fs::remove_all(parts_folder(), ignored);
}

}  // namespace tramline::app
