#include "request/asked_plans.h"

#include <fmt/format.h>

#include <utility>

#include "request/field_key.h"
#include "tramline/geodesy/crs.h"
#include "tramline/planner/validate_request.h"

namespace tramline::app {

AskedPlans::AskedPlans(const PlanOptions& options)
    : machine_(machine_of(options)), objective_(objective_of(options)), settings_(app::settings_of(options)) {
  validate_request(machine_, objective_, settings_);
}

void AskedPlans::read_files(const PlanOptions& options, const LandOptions& land, FieldInput& input) {
  if (input.fields.empty()) return;
  const std::string& crs = input.fields.front().source.input_crs;
  guide_ = guide_of(options, crs);
  gates_ = gates_of(options, crs);
  read_land(land, input);
}

void AskedPlans::read_land(const LandOptions& land, FieldInput& input) {
  const std::string& crs = input.fields.front().source.input_crs;
  LandFiles files(land, crs, input.crs_given && Crs(crs).plain() ? LandCrs::kPlain : LandCrs::kOfEachFile);
  for (const Field& field : input.fields) given_[field_key(field)] = files.given_for(field);
  const std::string fields = input.fields.size() == 1
                                 ? fmt::format("field '{}'", input.fields.front().id)
                                 : fmt::format("any of the {} fields", input.fields.size());
  for (Skipped& skipped : files.finish(fields)) input.skipped.push_back(std::move(skipped));
}

PlanSettings AskedPlans::settings_on(const Field& field) const {
  PlanSettings out = settings_for(settings_, guide_, field, machine_);
  place_gates(gates_, field, out);
  if (const auto found = given_.find(field_key(field)); found != given_.end()) out.given = found->second;
  return out;
}

}  // namespace tramline::app
