// The tramline program: parses the command line, runs one verb, turns errors into exit codes.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "commands/command.h"
#include "output/result_output.h"
#include "tramline/geometry/error.h"

#ifndef TRAMLINE_VERSION
#define TRAMLINE_VERSION "unknown"
#endif

namespace {

using tramline::app::Command;
using Verbs = std::vector<CLI::App*>;

std::vector<std::unique_ptr<Command>> all_commands() {
  using namespace tramline::app;
  std::vector<std::unique_ptr<Command>> out;
  for (const auto make : {make_plan_command, make_map_command, make_compare_command, make_evaluate_command,
                          make_repair_command, make_watch_command, make_dose_command, make_info_command,
                          make_check_command, make_export_command, make_serve_command})
    out.push_back(make());
  return out;
}

/// "plan, map or serve".
std::string listed(const Verbs& verbs, const std::string& last_word) {
  std::string out = verbs.front()->get_name();
  for (std::size_t i = 1; i < verbs.size(); ++i)
    out += (i + 1 < verbs.size() ? ", " : " " + last_word + " ") + verbs[i]->get_name();
  return out;
}

bool is_verb(const Verbs& verbs, const std::string& word) {
  return std::any_of(verbs.begin(), verbs.end(),
                     [&](const CLI::App* verb) { return verb->get_name() == word; });
}

/// One sentence about what was not understood.
std::string unexpected_argument(const Verbs& verbs, const std::string& first) {
  if (!is_verb(verbs, first))
    return "there is no verb '" + first + "': the verbs are " + listed(verbs, "and");
  for (const CLI::App* verb : verbs)
    if (!verb->remaining().empty())
      return "'" + verb->remaining().front() + "' was not expected: see 'tramline " + verb->get_name() +
             " --help'";
  return "an argument was not expected";
}

/// "--width" in "--width=", where that is an option of the verb; "" elsewhere. CLI11 would take the next
/// argument for the value.
std::string option_cut_short(const CLI::App& verb, const std::string& argument) {
  if (!argument.starts_with('-') || !argument.ends_with('=')) return "";
  const std::string name = argument.substr(0, argument.size() - 1);
  return verb.get_option_no_throw(name) == nullptr ? "" : name;
}

constexpr const char* kEmpty = "the value is empty; is a shell variable not set?";

void refuse_values_cut_short(const Verbs& verbs, const std::vector<std::string>& arguments) {
  for (const CLI::App* verb : verbs) {
    if (arguments.empty() || arguments.front() != verb->get_name()) continue;
    for (const std::string& argument : arguments) {
      if (argument == "--") break;
      const std::string name = option_cut_short(*verb, argument);
      if (!name.empty()) throw tramline::bad_input(name + ": " + kEmpty);
    }
  }
}

/// An empty text is no value of any option: CLI11 takes it for a zero or for nothing said.
void refuse_empty_values(const Verbs& verbs) {
  for (CLI::App* verb : verbs)
    for (CLI::Option* option : verb->get_options({}))
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

int run_verb(CLI::App& app, const std::vector<std::unique_ptr<Command>>& commands, int argc, char** argv) {
  Verbs verbs;
  for (const auto& command : commands) verbs.push_back(command->setup(app).parser());
  refuse_empty_values(verbs);
  refuse_values_cut_short(verbs, {argv + std::min(argc, 1), argv + argc});
  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError&) {
    return failed(2, unexpected_argument(verbs, argc > 1 ? argv[1] : ""));
  }
  for (std::size_t i = 0; i < commands.size(); ++i)
    if (verbs[i]->parsed()) return with_output_flushed(commands[i]->run());
  return failed(2, "name a verb, " + listed(verbs, "or") + "; see 'tramline --help'");
}

}  // namespace

int main(int argc, char** argv) {
  using namespace tramline::app;
  CLI::App app{"Plans every pass a machine makes over a field, and proves what was worked."};
  app.set_version_flag("--version", TRAMLINE_VERSION);
  app.require_subcommand(0, 1);
  app.footer("Run 'tramline VERB --help' for the options and an example of each verb.");
  report_closed_pipes();
  const std::vector<std::unique_ptr<Command>> commands = all_commands();

  try {
    return run_verb(app, commands, argc, argv);
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
