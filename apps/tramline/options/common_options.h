#pragma once
// The options that most commands share: files that are written, the form of the report, threads.

#include <string>

#include "options/command_options.h"

namespace tramline::app {

/// Declares -o,--output, which nothing is written without.
Option add_output_option(CommandOptions& command, std::string& file, const char* help);

/// Declares --picture, which nothing is drawn without.
void add_picture_option(CommandOptions& command, std::string& file, const char* help);

/// Declares --json and --quiet.
void add_report_options(CommandOptions& command, bool& json, const char* json_help, bool& quiet);

/// Declares --threads.
void add_threads_option(CommandOptions& command, int& threads);

/// Declares --threads for a command whose work is done by one thread: every command takes the option.
void add_unused_threads_option(CommandOptions& command, int& threads);

}  // namespace tramline::app
