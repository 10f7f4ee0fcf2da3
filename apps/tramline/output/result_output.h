#pragma once
// What goes to stdout: results, whole and on their way as soon as they are known.

#include <exception>
#include <nlohmann/json.hpp>
#include <string>

namespace tramline::app {

/// The reader of stdout has closed the pipe (`tramline … | head -1`). There is nobody to report this to, so
/// the program ends quietly.
class OutputClosed : public std::exception {
 public:
  const char* what() const noexcept override { return "stdout is closed"; }
};

/// From now on writing to a closed pipe is an error of the write and no longer ends the process, so that
/// files that are being written are finished or removed.
void report_closed_pipes();

/// Ends the process like the signal (SIGPIPE) that report_closed_pipes() suppresses.
[[noreturn]] void end_as_by_closed_pipe();

/// Writes everything printed so far to stdout. Throws OutputClosed where the pipe is closed, and
/// Error(kFailure) where writing fails for another reason.
void flush_output();

/// Prints the text and flushes it. Throws as flush_output() does.
void print_result(const std::string& text);

/// Prints one JSON result on a line of its own, with `format_version` (docs/json.md) as its first key.
void print_json_line(const nlohmann::ordered_json& result);
/// The same over several lines, indented.
void print_json(const nlohmann::ordered_json& result);

}  // namespace tramline::app
