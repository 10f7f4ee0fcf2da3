#pragma once
// The commands of the program. setup() only declares options; run() does the work and returns the exit
// code (0 success, 1 failed run or failed check, 2 bad input, 3 some of many fields refused). Errors are
// thrown as tramline::Error.

#include <memory>

#include "options/command_options.h"

namespace tramline::app {

class Command {
 public:
  virtual ~Command() = default;
  /// Declares the command as a subcommand of `program` and returns it.
  virtual CommandOptions setup(CLI::App& program) = 0;
  virtual int run() = 0;
};

inline void add_threads_option(CommandOptions& command, int& threads) {
  command.add_option("--threads", threads, "Number of threads.")
      .takes("N")
      .in_range(0, 1024)
      .shows_default("all cores");
}

/// --threads, for a command whose work is done by one thread: every command takes the option.
inline void add_unused_threads_option(CommandOptions& command, int& threads) {
  command.add_option("--threads", threads, "Accepted by every command; this one uses a single thread.")
      .takes("N")
      .in_range(0, 1024)
      .shows_default("1");
}

std::unique_ptr<Command> make_plan_command();
std::unique_ptr<Command> make_map_command();
std::unique_ptr<Command> make_compare_command();
std::unique_ptr<Command> make_evaluate_command();
std::unique_ptr<Command> make_repair_command();
std::unique_ptr<Command> make_watch_command();
std::unique_ptr<Command> make_dose_command();
std::unique_ptr<Command> make_info_command();
std::unique_ptr<Command> make_check_command();
std::unique_ptr<Command> make_export_command();
std::unique_ptr<Command> make_serve_command();

}  // namespace tramline::app
