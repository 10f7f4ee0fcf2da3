// The tramline program: parses the command line, runs one verb, turns errors into exit codes.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <system_error>
#include <vector>

#include "command.h"
#include "result_output.h"
#include "tramline/geometry/error.h"

#ifndef TRAMLINE_VERSION
#define TRAMLINE_VERSION "unknown"
#endif

namespace {

bool is_verb(const std::vector<CLI::App*>& verbs, const std::string& word) {
  return std::any_of(verbs.begin(), verbs.end(),
                     [&](const CLI::App* verb) { return verb->get_name() == word; });
}

/// One sentence about what the verb did not understand.
std::string unexpected_argument(const std::vector<CLI::App*>& verbs) {
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

void refuse_values_cut_short(const std::vector<CLI::App*>& verbs, const std::vector<std::string>& arguments) {
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
void refuse_empty_values(const std::vector<CLI::App*>& verbs) {
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

/// One line, whatever a user's names contain.
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

int exit_code(const tramline::Error& error) { return error.kind() == tramline::ErrorKind::kBadInput ? 2 : 1; }

}  // namespace

int main(int argc, char** argv) {
  using namespace tramline::app;
  CLI::App app{"Plans every pass a machine makes over a field, and proves what was worked."};
  app.set_version_flag("--version", TRAMLINE_VERSION);
  app.require_subcommand(0, 1);
  app.footer("Run 'tramline VERB --help' for the options and an example of each verb.");

  std::vector<std::unique_ptr<Command>> commands;
  commands.push_back(make_plan_command());
  commands.push_back(make_map_command());
  commands.push_back(make_compare_command());
  commands.push_back(make_evaluate_command());
  commands.push_back(make_repair_command());
  commands.push_back(make_watch_command());
  commands.push_back(make_dose_command());
  commands.push_back(make_info_command());
  commands.push_back(make_check_command());
  commands.push_back(make_export_command());
  commands.push_back(make_serve_command());
  std::vector<CLI::App*> verbs;
  for (auto& command : commands) verbs.push_back(command->setup(app).parser());
  refuse_empty_values(verbs);
  report_closed_pipes();

  try {
    refuse_values_cut_short(verbs, {argv + std::min(argc, 1), argv + argc});
    app.parse(argc, argv);
    for (std::size_t i = 0; i < commands.size(); ++i)
      if (verbs[i]->parsed()) return with_output_flushed(commands[i]->run());
    std::fputs(
        "tramline: name a verb, plan, map, compare, evaluate, repair, watch, dose, info, check, export or "
        "serve; "
        "see 'tramline "
        "--help'\n",
        stderr);
    return 2;
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ExtrasError&) {
    const std::string verb = argc > 1 ? argv[1] : "";
    if (!is_verb(verbs, verb)) {
      std::fprintf(stderr,
                   "tramline: there is no verb '%s': the verbs are plan, map, compare, evaluate, repair, "
                   "watch, dose, info, check, "
                   "export and serve\n",
                   verb.c_str());
      return 2;
    }
    std::fprintf(stderr, "tramline: %s\n", unexpected_argument(verbs).c_str());
    return 2;
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "tramline: %s\n", error.what());
    return 2;
  } catch (const tramline::Error& error) {
    std::fprintf(stderr, "tramline: %s\n", one_line(error.what()).c_str());
    return exit_code(error);
  } catch (const OutputClosed&) {
    end_as_by_closed_pipe();
  } catch (const std::exception& error) {
    if (is_closed_pipe(error)) end_as_by_closed_pipe();
    std::fprintf(stderr, "tramline: the run failed: %s\n", error.what());
    return 1;
  }
}
