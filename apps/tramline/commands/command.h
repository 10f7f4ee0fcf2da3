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

std::unique_ptr<Command> make_plan_command();
std::unique_ptr<Command> make_map_command();
std::unique_ptr<Command> make_compare_command();
std::unique_ptr<Command> make_farm_command();
std::unique_ptr<Command> make_batch_command();
std::unique_ptr<Command> make_price_command();
std::unique_ptr<Command> make_evaluate_command();
std::unique_ptr<Command> make_repair_command();
std::unique_ptr<Command> make_turns_command();
std::unique_ptr<Command> make_watch_command();
std::unique_ptr<Command> make_dose_command();
std::unique_ptr<Command> make_info_command();
std::unique_ptr<Command> make_check_command();
std::unique_ptr<Command> make_export_command();
std::unique_ptr<Command> make_serve_command();

}  // namespace tramline::app
