#include "asked.h"

#include <utility>

#include "options/common_options.h"
#include "options/drive_options.h"
#include "options/field_options.h"
#include "options/plan_options.h"
#include "tramline/geometry/error.h"

namespace tramline::python {
namespace {

using app::CommandOptions;
using app::PlanDefaults;

void declare_run(CommandOptions& command, PlanRequest& request) {
  command.add_option("--seconds", request.seconds, "End the search after so many seconds.")
      .takes("S")
      .positive();
  app::add_threads_option(command, request.threads);
}

void declare_plan(CommandOptions& command, PlanRequest& request, PlanDefaults defaults) {
  app::add_field_options(command, request.field);
  app::add_plan_options(command, request.plan, defaults);
  if (defaults == PlanDefaults::kWhole) app::add_land_options(command, request.land);
  declare_run(command, request);
}

void declare_price(CommandOptions& command, PriceRequest& request) {
  command.add_option("LINES", request.lines.file, "The centre lines.").required();
  command.add_option("--lines-layer", request.lines.layer, "Read this layer of the lines.").takes("NAME");
  command.add_option("--lines-where", request.lines.where, "Read only lines that match.").takes("FILTER");
  app::add_field_choice(command, request.field);
  app::add_plan_options(command, request.plan);
}

void declare_evaluate(CommandOptions& command, EvaluateRequest& request) {
  command.add_option("LOG", request.log_file, "The drive.");
  app::add_field_choice(command, request.field);
  command.add_option("--log", request.drive.log.log, "Read this log of an ISOXML task set.").takes("NAME");
  command.add_option("--job", request.job, "Read this job where a log has several.")
      .takes("N")
      .in_range(1, 1000000);
  app::add_drive_options(command, request.drive);
  app::add_threads_option(command, request.threads);
}

void declare_check(CommandOptions& command, app::FieldOptions& field) {
  app::add_field_choice(command, field);
}

PlanRequest parsed(const Words& words, const Features& features, PlanDefaults defaults) {
  PlanRequest out;
  app::OptionParser parser("plan");
  declare_plan(parser.command(), out, defaults);
  parser.parse(words);
  out.field.in_memory = features;
  app::take_conventions(parser.command(), out.plan);
  // Headlands go round whole fields.
  const bool part_only = !out.land.only_file.empty() || !out.land.done_files.empty();
  if (defaults == PlanDefaults::kWhole && !part_only) app::take_whole_plan(parser.command(), out.plan);
  return out;
}

}  // namespace

PlanRequest plan_request(const Words& words, const Features& features) {
  return parsed(words, features, PlanDefaults::kWhole);
}

PlanRequest compare_request(const Words& words, const Features& features) {
  return parsed(words, features, PlanDefaults::kTracks);
}

PriceRequest price_request(const Words& words, const Features& features, const Features& lines) {
  PriceRequest out;
  app::OptionParser parser("price");
  declare_price(parser.command(), out);
  parser.parse(words);
  app::take_conventions(parser.command(), out.plan);
  out.field.in_memory = features;
  out.lines.in_memory = lines;
  return out;
}

EvaluateRequest evaluate_request(const Words& words, const Features& features) {
  EvaluateRequest out;
  app::OptionParser parser("evaluate");
  declare_evaluate(parser.command(), out);
  parser.parse(words);
  out.field.in_memory = features;
  return out;
}

app::FieldOptions check_request(const Words& words, const Features& features) {
  app::FieldOptions out;
  app::OptionParser parser("check");
  declare_check(parser.command(), out);
  parser.parse(words);
  out.in_memory = features;
  return out;
}

std::vector<app::OptionText> options_of(const std::string& command) {
  app::OptionParser parser(command);
  PlanRequest plan;
  PriceRequest price;
  EvaluateRequest evaluate;
  app::FieldOptions check;
  if (command == "plan")
    declare_plan(parser.command(), plan, PlanDefaults::kWhole);
  else if (command == "compare")
    declare_plan(parser.command(), plan, PlanDefaults::kTracks);
  else if (command == "price")
    declare_price(parser.command(), price);
  else if (command == "evaluate")
    declare_evaluate(parser.command(), evaluate);
  else if (command == "check")
    declare_check(parser.command(), check);
  else
    throw bad_input("there is no command '" + command + "'");
  return parser.options();
}

}  // namespace tramline::python
