// The tramline program: parses the command line, runs one verb, turns errors into exit codes.

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "command.h"
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

/// A full disk behind stdout shows at the last moment.
int with_output_flushed(int code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  std::fprintf(stderr, "tramline: the result could not be written to stdout: is the disk full?\n");
  return 1;
}

/// One line, whatever a user's names contain.
std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c >= 0 && c < ' '; }, ' ');
  return text;
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
  commands.push_back(make_info_command());
  commands.push_back(make_check_command());
  std::vector<CLI::App*> verbs;
  for (auto& command : commands) verbs.push_back(command->setup(app));

  try {
    app.parse(argc, argv);
    for (std::size_t i = 0; i < commands.size(); ++i)
      if (verbs[i]->parsed()) return with_output_flushed(commands[i]->run());
    std::fputs("tramline: name a verb, plan, info or check; see 'tramline --help'\n", stderr);
    return 2;
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ExtrasError&) {
    const std::string verb = argc > 1 ? argv[1] : "";
    if (!is_verb(verbs, verb)) {
      std::fprintf(stderr, "tramline: there is no verb '%s': the verbs are plan, info and check\n",
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
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tramline: the run failed: %s\n", error.what());
    return 1;
  }
}
