#include "real/real_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "tramline/admission/admit.h"
#include "tramline/check/file/compare_fields.h"
#include "tramline/check/file/compare_layers.h"
#include "tramline/check/file/compare_whole_cost.h"
#include "tramline/check/verify.h"
#include "tramline/geometry/error.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/io/plan/write_plan.h"
#include "tramline/io/vector/read_vector.h"
#include "tramline/planner/plan_field.h"

namespace tramline::testing {

std::optional<Machine> machine_in_words(int count, char** words, const char* usage) {
  const std::string_view kind = count > 3 ? words[3] : "";
  constexpr std::array kKinds{"forward", "reversing", "carrying", "towing"};
  if (std::find(kKinds.begin(), kKinds.end(), kind) == kKinds.end()) {
    std::fprintf(stderr, "usage: %s\n", usage);
    return std::nullopt;
  }
  Machine machine{"", std::atof(words[1]), std::atof(words[2]), -1};
  Turning& turning = machine.turning;
  turning.reverse = kind == "reversing" || kind == "carrying";
  if (kind == "forward" || kind == "reversing") return machine;
  turning.vehicle_width_m = 2.5;
  turning.front_overhang_m = 4;
  turning.lift_m = turning.lower_m = 2;
  if (kind == "carrying") {
    turning.implement_offset_m = 1.5;
    turning.rear_overhang_m = 1;
  } else {
    turning.implement = Coupling::kTowed;
    turning.implement_offset_m = 1;
    turning.drawbar_m = 5;
  }
  return machine;
}

void add_failure(const Error& error, std::vector<std::string>& faults) {
  if (error.kind() != ErrorKind::kBadInput) faults.push_back(std::string("the run failed: ") + error.what());
}

void print_faults(const Field& field, const std::vector<std::string>& faults) {
  for (const std::string& fault : faults) fmt::print("  {}: {}\n", field.id, fault);
}

namespace {

PlanSettings settings_with(EndRule end_rule) {
  PlanSettings settings;
  settings.strategy = Strategy::kSweep;
  settings.end_rule = end_rule;
  settings.merge_threshold = Angle::degrees(15);
  settings.decomposition_threshold = Angle::degrees(205);
  return settings;
}

void append(std::vector<check::Violation>& to, const std::vector<check::Violation>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

/// Where a plan file says something twice and not the same.
void compare_layers(const io::PlanFile& file, std::vector<check::Violation>& out) {
  append(out, check::compare_swaths(file.plan, file.track_order, file.swaths, file.swath_order));
  append(out, check::compare_lines(file.plan, file.track_lines));
  for (const io::DerivedNumber& number : file.derived)
    check::compare_number(number.where, number.stored, number.from_shape, number.rounding, number.at, out);
  for (const io::DerivedText& text : file.derived_texts)
    check::compare_text(text.where, text.stored, text.from_shape, text.at, out);
}

std::vector<std::string> in_words(const check::Verdict& verdict) {
  std::vector<std::string> out;
  for (const check::Violation& violation : verdict.violations)
    out.push_back(fmt::format("{}: {} at ({:.3f}, {:.3f})", name(violation.rule), violation.what,
                              violation.at.x, violation.at.y));
  if (!verdict.complete) out.emplace_back("the verifier could not look at everything");
  return out;
}

Outcome outcome_of(const Field& field, const Field& input, int scenario_number, EndRule end_rule,
                   const std::string& scratch) {
  Outcome outcome;
  outcome.field_id = field.id;
  try {
    const auto start = std::chrono::steady_clock::now();
    const Plan plan = plan_field(field, Machine{}, scenario(scenario_number), settings_with(end_rule), 1);
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    outcome.field_m2 = area(Polygon{field.outer, {}});
    outcome.overlap_pct = 100 * plan.tally.overlap_m2 / outcome.field_m2;
    outcome.uncovered_pct = 100 * plan.tally.uncovered_m2 / outcome.field_m2;
    outcome.turns = plan.tally.turns;
    outcome.pieces = plan.tally.pieces;
    outcome.directions_tried = plan.directions_tried;
    outcome.obstacles = field.obstacles.size();
    io::write_plan(plan, scratch);
    outcome.violations = faults_of_file(scratch, input);
    std::filesystem::remove(scratch);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::kBadInput) outcome.refused = error.what();
    add_failure(error, outcome.violations);
  }
  return outcome;
}

}  // namespace

std::string real_data_folder() {
  const char* folder = std::getenv("TRAMLINE_DATA");
  return folder != nullptr ? folder : TRAMLINE_SOURCE_DIR "/../shared/data";
}

namespace {

std::optional<RealFields> read_fields_of(const char* name) {
  const std::string file = real_data_folder() + "/fields/" + name;
  if (!std::filesystem::exists(file)) return std::nullopt;
  io::VectorQuery query;
  query.file = file;
  RawDataset dataset = io::read_vector(query);
  return RealFields{file, std::move(dataset)};
}

}  // namespace

std::optional<RealFields> read_real_fields() { return read_fields_of("fields.geojson"); }

std::optional<RealFields> read_all_real_fields() { return read_fields_of("fields-all.geojson"); }

std::string no_real_fields() {
  return fmt::format("skipped: no real fields in {}; set TRAMLINE_DATA", real_data_folder());
}

std::optional<RealFields> read_or_say() {
  std::optional<RealFields> out = read_real_fields();
  if (!out) fmt::print("{}\n", no_real_fields());
  return out;
}

std::vector<Field> admitted(const RealFields& fields, const Crs& crs, const RawFeature& feature) {
  AdmissionContext context;
  context.file = fields.file;
  context.layer = fields.dataset.layers.front().name;
  context.crs = &crs;
  context.winding = fields.dataset.winding;
  return admit(feature, context).fields;
}

std::vector<std::string> faults_of(const Plan& plan) { return in_words(check::verify(plan)); }

std::vector<std::string> faults_of_file(const std::string& path, const Field& input) {
  const io::PlanFile file = io::read_plan_file(path);
  check::Verdict verdict = check::verify(file.plan);
  if (verdict.complete) {
    compare_layers(file, verdict.violations);
    if (file.stated_cost) append(verdict.violations, check::compare_whole_cost(file.plan, *file.stated_cost));
    append(verdict.violations, check::compare_fields(file.plan.field, input));
  }
  return in_words(verdict);
}

Objective scenario(int number) {
  constexpr double kAbove = 99999;
  if (number == 1) return {kAbove, 1, 1, 0};
  if (number == 2) return {1, kAbove, 1, 0};
  return {1, 1, kAbove, 0};
}

std::vector<Outcome> plan_and_verify(const RealFields& fields, const Crs& crs, const RawFeature& feature,
                                     int scenario_number, EndRule end_rule, const std::string& scratch) {
  std::vector<Outcome> out;
  try {
    const std::vector<Field> parts = admitted(fields, crs, feature), inputs = admitted(fields, crs, feature);
    for (std::size_t i = 0; i < parts.size(); ++i)
      out.push_back(outcome_of(parts[i], inputs[i], scenario_number, end_rule, scratch));
  } catch (const Error& error) {
    out.emplace_back();
    out.back().field_id = feature.id;
    out.back().refused = error.what();
  }
  return out;
}

}  // namespace tramline::testing
