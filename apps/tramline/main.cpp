// The tramline program: parses the command line, runs one verb, turns errors into exit codes.

#include <cstdio>
#include <exception>
#include <vector>

#include "command.h"
#include "tramline/geometry/error.h"

#ifndef TRAMLINE_VERSION
#define TRAMLINE_VERSION "unknown"
#endif

namespace {

int exit_code(const tramline::Error& error) { return error.kind() == tramline::ErrorKind::kBadInput ? 2 : 1; }

}  // namespace

int main(int argc, char** argv) {
  using namespace tramline::app;
  CLI::App app{"Plans every pass a machine makes over a field, and proves what was worked."};
  app.set_version_flag("--version", TRAMLINE_VERSION);
  app.require_subcommand(1);
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
      if (verbs[i]->parsed()) return commands[i]->run();
    return 0;
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "tramline: %s\n", error.what());
    return 2;
  } catch (const tramline::Error& error) {
    std::fprintf(stderr, "tramline: %s\n", error.what());
    return exit_code(error);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tramline: the run failed: %s\n", error.what());
    return 1;
  }
}
