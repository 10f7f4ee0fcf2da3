#include "asked.h"

#include <utility>

#include "options/common_options.h"
#include "options/drive_options.h"
#include "options/field_options.h"
#include "options/plan_options.h"
#include "options/search_seconds.h"
#include "tramline/geometry/error.h"

namespace tramline::python {
namespace {

using app::CommandOptions;
using app::PlanDefaults;

/// Of a request that ends after some time, and runs on some threads.
template <class Request>
void declare_run(CommandOptions& command, Request& request) {
  app::add_seconds_option(command, request.seconds);
  app::add_threads_option(command, request.threads);
}

void declare_plan(CommandOptions& command, PlanRequest& request) {
  app::add_field_options(command, request.field);
  app::add_plan_options(command, request.plan, PlanDefaults::kWhole);
  app::add_land_options(command, request.land);
  declare_run(command, request);
}

void declare_compare(CommandOptions& command, CompareRequest& request) {
  app::add_compare_options(command, request.options);
  declare_run(command, request);
}

void declare_price(CommandOptions& command, PriceRequest& request) {
  app::add_price_options(command, request.options);
  declare_run(command, request);
  command.option("--seconds").needs(command.option("--compare"));
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

}  // namespace

PlanRequest plan_request(const Words& words, const Features& features) {
  PlanRequest out;
  app::OptionParser parser("plan");
  declare_plan(parser.command(), out);
  parser.parse(words);
  out.field.in_memory = features;
  app::take_conventions(parser.command(), out.plan);
  // Headlands go round whole fields.
  const bool part_only = !out.land.only_file.empty() || !out.land.done_files.empty();
  if (!part_only) app::take_whole_plan(parser.command(), out.plan);
  return out;
}

CompareRequest compare_request(const Words& words, const Features& features) {
  CompareRequest out;
  app::OptionParser parser("compare");
  declare_compare(parser.command(), out);
  parser.parse(words);
  out.options.field.in_memory = features;
  if (!out.options.machines.asked()) {
    out.plans = app::asked_comparison(parser.command(), out.options);
    return out;
  }
  if (!out.options.prices.empty())
    throw bad_input(
        "several machines are compared by their whole routes: leave out --for, or --widths and --machines");
  out.machines = app::asked_machines(parser.command(), out.options);
  return out;
}

PriceRequest price_request(const Words& words, const Features& features, const Features& lines) {
  PriceRequest out;
  app::OptionParser parser("price");
  declare_price(parser.command(), out);
  parser.parse(words);
  app::take_conventions(parser.command(), out.options.plan);
  out.options.field.in_memory = features;
  out.options.lines.in_memory = lines;
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
  CompareRequest compare;
  PriceRequest price;
  EvaluateRequest evaluate;
  app::FieldOptions check;
  if (command == "plan")
    declare_plan(parser.command(), plan);
  else if (command == "compare")
    declare_compare(parser.command(), compare);
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
