// tramline info: what a file says and what was understood of it.

#include <fmt/format.h>

#include "commands/command.h"
#include "options/common_options.h"
#include "options/field_options.h"
#include "output/result_output.h"
#include "report/info_report.h"
#include "report/report_parts.h"
#include "tramline/geometry/error.h"

namespace tramline::app {
namespace {

constexpr const char* kInfoHelp =
    "Show what was read from a file: coordinate reference system, areas, obstacles and repairs. Of several "
    "features the first 20 are listed.";
constexpr const char* kInfoExample =
    "Examples:\n"
    "  tramline info parcels.gpkg\n"
    "  tramline info parcels.gpkg --id mill-field\n"
    "  tramline info parcels.gpkg --all --json | jq '.repairs[]'";
constexpr long long kListed = 20;

class InfoCommand : public Command {
 public:
  CommandOptions setup(CLI::App& program) override {
    CommandOptions command(program, "info", kInfoHelp);
    add_field_options(command, options_);
    command.begin_group("Output");
    command.add_flag("--json", json_,
                     "Print one JSON object, or with --all a line with an object for each field.");
    command.begin_group("Run");
    add_unused_threads_option(command, threads_);
    command.footer(kInfoExample);
    return command;
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
    if (input.fields.empty()) return 2;
    return input.refusals.empty() ? 0 : 3;
  }

 private:
  void list(const FieldInput& input) const {
    if (json_) {
      print_json_line(candidates_json(options_.file, input));
      return;
    }
    std::string table = source_rows(options_.file, input) + candidate_rows(input);
    if (input.features > kListed) table += fmt::format("and {} more features\n", input.features - kListed);
    print_result(table + skipped_rows(input.skipped) + "choose one with --id, or take all with --all\n");
  }

  /// With --all what was skipped stands on a line of its own rather than with every field.
  void print_json(const FieldInput& input) const {
    for (const Field& field : input.fields) {
      nlohmann::ordered_json line = field_json(options_.file, input, field);
      if (!options_.all) line["skipped"] = skipped_json(input.skipped);
      print_json_line(line);
    }
    for (const Refusal& refusal : input.refusals)
      print_json_line(refusal_json(input.file, input.layer, refusal));
    if (options_.all && !input.skipped.empty()) print_json_line({{"skipped", skipped_json(input.skipped)}});
  }

  void print_table(const FieldInput& input) const {
    std::string table = source_rows(options_.file, input);
    for (const Field& field : input.fields) {
      if (input.fields.size() > 1) table += '\n';
      table += field_rows(field);
    }
    for (const Refusal& refusal : input.refusals)
      table += fmt::format("\nrefused      {}\n", refusal.sentence);
    print_result(table + skipped_rows(input.skipped));
  }

  FieldOptions options_;
  int threads_ = 0;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> make_info_command() { return std::make_unique<InfoCommand>(); }

}  // namespace tramline::app
