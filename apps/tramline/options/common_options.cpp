#include "options/common_options.h"

namespace tramline::app {

Option add_output_option(CommandOptions& command, std::string& file, const char* help) {
  return command.add_option("-o,--output", file, help).takes("FILE").shows_default("not written");
}

void add_picture_option(CommandOptions& command, std::string& file, const char* help) {
  command.add_option("--picture", file, help).takes("FILE").shows_default("not drawn");
}

void add_report_options(CommandOptions& command, bool& json, const char* json_help, bool& quiet) {
  command.add_flag("--json", json, json_help);
  command.add_flag("--quiet", quiet, "Print neither progress nor table.");
}

void add_threads_option(CommandOptions& command, int& threads) {
  command.add_option("--threads", threads, "Number of threads.")
      .takes("N")
      .in_range(0, 1024)
      .shows_default("all cores");
}

void add_unused_threads_option(CommandOptions& command, int& threads) {
  command.add_option("--threads", threads, "Accepted by every command; this one uses a single thread.")
      .takes("N")
      .in_range(0, 1024)
      .shows_default("1");
}

}  // namespace tramline::app
