// tramline info: what a file says and what was understood of it.

#include <fmt/format.h>

#include "command.h"
#include "field_options.h"
#include "report/info_report.h"
#include "report/report_parts.h"
#include "tramline/geometry/error.h"

namespace tramline::app {
namespace {

constexpr const char* kHelp =
    "Show what was understood of a file: CRS, areas, obstacles, and what was repaired where. Of several "
    "features "
    "the first 20 are listed to choose from.";
constexpr const char* kExample =
    "Example:\n"
    "  tramline info parcels.gpkg\n"
    "  tramline info parcels.gpkg --where \"id = 'mill-field'\"\n"
    "  tramline info parcels.gpkg --all --json | jq '.repairs[]'";
constexpr long long kListed = 20;

class InfoCommand : public Command {
 public:
  CLI::App* setup(CLI::App& app) override {
    CLI::App* verb = app.add_subcommand("info", kHelp);
    add_field_options(*verb, options_);
    add_unused_threads_option(*verb, threads_);
    verb->add_flag("--json", json_, "print JSON: one object, with --all one per field and line");
    verb->footer(kExample);
    return verb;
  }

  int run() override {
    const FieldInput input = options_.all ? load_fields(options_) : survey_fields(options_, kListed);
    if (!options_.all && input.features > 1) {
      list(input);
      return 0;
    }
    // Alone, a refused feature is the result.
    if (!options_.all && !input.refusals.empty()) throw bad_input(input.refusals.front().sentence);
    json_ ? print_json(input) : print_table(input);
    return input.fields.empty() ? 2 : 0;
  }

 private:
  void list(const FieldInput& input) const {
    if (json_) {
      fmt::print("{}\n", json_line(candidates_json(options_.file, input)));
      return;
    }
    fmt::print("{}{}", source_rows(options_.file, input), candidate_rows(input));
    if (input.features > kListed) fmt::print("and {} more features\n", input.features - kListed);
    fmt::print("{}choose one with --where, or take all with --all\n", skipped_rows(input.skipped));
  }

  /// With --all what was skipped stands on a line of its own rather than with every field.
  void print_json(const FieldInput& input) const {
    for (const Field& field : input.fields) {
      nlohmann::ordered_json line = field_json(options_.file, input, field);
      if (!options_.all) line["skipped"] = skipped_json(input.skipped);
      fmt::print("{}\n", json_line(line));
    }
    for (const Refusal& refusal : input.refusals)
      fmt::print("{}\n", json_line(refusal_json(refusal.field_id, refusal.sentence)));
    if (options_.all && !input.skipped.empty())
      fmt::print("{}\n", json_line({{"skipped", skipped_json(input.skipped)}}));
  }

  void print_table(const FieldInput& input) const {
    fmt::print("{}", source_rows(options_.file, input));
    for (const Field& field : input.fields)
      fmt::print("{}{}", input.fields.size() > 1 ? "\n" : "", field_rows(field));
    for (const Refusal& refusal : input.refusals) fmt::print("\nrefused      {}\n", refusal.sentence);
    fmt::print("{}", skipped_rows(input.skipped));
  }

  FieldOptions options_;
  int threads_ = 0;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> make_info_command() { return std::make_unique<InfoCommand>(); }

}  // namespace tramline::app
