// The tramline program: parses the command line, runs one command, turns errors into exit codes.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "commands/command.h"
#include "output/help_format.h"
#include "output/result_output.h"
#include "tramline/geometry/error.h"

#ifndef TRAMLINE_VERSION
#define TRAMLINE_VERSION "unknown"
#endif

namespace {

using tramline::app::Command;
using Parsers = std::vector<CLI::App*>;

std::vector<std::unique_ptr<Command>> all_commands() {
  using namespace tramline::app;
  std::vector<std::unique_ptr<Command>> out;
  for (const auto make : {make_plan_command, make_map_command, make_compare_command, make_farm_command,
                          make_batch_command, make_price_command, make_turns_command, make_evaluate_command,
                          make_repair_command, make_watch_command, make_dose_command, make_info_command,
                          make_check_command, make_export_command, make_serve_command})
    out.push_back(make());
  return out;
}

/// "plan, map or serve".
std::string listed(const Parsers& parsers, const std::string& last_word) {
  std::string out = parsers.front()->get_name();
  for (std::size_t i = 1; i < parsers.size(); ++i)
    out += (i + 1 < parsers.size() ? ", " : " " + last_word + " ") + parsers[i]->get_name();
  return out;
}

bool is_command(const Parsers& parsers, const std::string& word) {
  return std::any_of(parsers.begin(), parsers.end(),
                     [&](const CLI::App* parser) { return parser->get_name() == word; });
}

/// One sentence about what was not understood.
std::string unexpected_argument(const Parsers& parsers, const std::string& first) {
  if (!is_command(parsers, first))
    return "there is no command '" + first + "': the commands are " + listed(parsers, "and");
  for (const CLI::App* parser : parsers)
    if (!parser->remaining().empty())
      return "'" + parser->remaining().front() + "' was not expected: see 'tramline " + parser->get_name() +
             " --help'";
  return "an argument was not expected";
}

/// "--width" in "--width=", where that is an option of the command; "" elsewhere. CLI11 would take the next
/// argument for the value.
std::string option_cut_short(const CLI::App& parser, const std::string& argument) {
  if (!argument.starts_with('-') || !argument.ends_with('=')) return "";
  const std::string name = argument.substr(0, argument.size() - 1);
  return parser.get_option_no_throw(name) == nullptr ? "" : name;
}

constexpr const char* kEmpty = "the value is empty; is a shell variable not set?";

void refuse_values_cut_short(const Parsers& parsers, const std::vector<std::string>& arguments) {
  for (const CLI::App* parser : parsers) {
    if (arguments.empty() || arguments.front() != parser->get_name()) continue;
    for (const std::string& argument : arguments) {
      if (argument == "--") break;
      const std::string name = option_cut_short(*parser, argument);
      if (!name.empty()) throw tramline::bad_input(name + ": " + kEmpty);
    }
  }
}

/// An empty text is no value of any option: CLI11 takes it for a zero or for nothing said.
void refuse_empty_values(const Parsers& parsers) {
  for (CLI::App* parser : parsers)
    for (CLI::Option* option : parser->get_options({}))
      if (option->get_items_expected_max() > 0)
        // As a transformation it comes before what the option itself asks of its value.
        option->transform(CLI::Validator([](std::string& value) { return value.empty() ? kEmpty : ""; }, ""));
}

/// A full disk behind stdout shows at the last moment.
int with_output_flushed(int code) {
  tramline::app::flush_output();
  return code;
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c >= 0 && c < ' '; }, ' ');
  return text;
}

/// Does the error say that whoever read stdout has gone?
bool is_closed_pipe(const std::exception& error) {
  const auto* system = dynamic_cast<const std::system_error*>(&error);
  return system != nullptr && system->code() == std::errc::broken_pipe && std::ferror(stdout) != 0;
}

/// Says in one line of stderr what is wrong, whatever a user's names contain.
int failed(int code, const std::string& message) {
  std::fprintf(stderr, "tramline: %s\n", one_line(message).c_str());
  return code;
}

int run_command(CLI::App& app, const std::vector<std::unique_ptr<Command>>& commands, int argc, char** argv) {
  Parsers parsers;
  for (const auto& command : commands) parsers.push_back(command->setup(app).parser());
  refuse_empty_values(parsers);
  refuse_values_cut_short(parsers, {argv + std::min(argc, 1), argv + argc});
  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError&) {
    return failed(2, unexpected_argument(parsers, argc > 1 ? argv[1] : ""));
  }
  for (std::size_t i = 0; i < commands.size(); ++i)
    if (parsers[i]->parsed()) return with_output_flushed(commands[i]->run());
  return failed(2, "name a command: " + listed(parsers, "or") + "; see 'tramline --help'");
}

}  // namespace

int main(int argc, char** argv) {
  using namespace tramline::app;
  CLI::App app{"Plan every pass a machine makes over a field, and prove which land it worked."};
  app.set_version_flag("--version", TRAMLINE_VERSION);
  app.require_subcommand(0, 1);
  app.footer("'tramline COMMAND --help' lists a command's options and gives examples.");
  app.formatter(std::make_shared<HelpFormatter>());
  report_closed_pipes();
  const std::vector<std::unique_ptr<Command>> commands = all_commands();

  try {
    return run_command(app, commands, argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    return failed(2, error.what());
  } catch (const tramline::Error& error) {
    return failed(error.kind() == tramline::ErrorKind::kBadInput ? 2 : 1, error.what());
  } catch (const OutputClosed&) {
    end_as_by_closed_pipe();
  } catch (const std::exception& error) {
    if (is_closed_pipe(error)) end_as_by_closed_pipe();
    return failed(1, std::string("the run failed: ") + error.what());
  }
}
