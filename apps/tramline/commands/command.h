#pragma once
// The verbs of the program. setup() only declares options; run() does the work and returns the exit
// code (0 success, 1 failed run or failed check, 2 bad input, 3 some of many fields refused). Errors are
// thrown as tramline::Error.

#include <memory>

#include "commands/verb.h"

namespace tramline::app {

class Command {
 public:
  virtual ~Command() = default;
  /// Declares the verb as a subcommand of `program` and returns it.
  virtual Verb setup(CLI::App& program) = 0;
  virtual int run() = 0;
};

/// --threads, for a verb whose work is done by one thread: every verb takes the option.
inline void add_unused_threads_option(Verb& verb, int& threads) {
  verb.add_option("--threads", threads, "taken by every verb; this one uses a single thread")
      .in_range(0, 1024);
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
