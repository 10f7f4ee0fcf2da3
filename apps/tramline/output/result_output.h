#pragma once
// What goes to stdout: results, whole and on their way as soon as they are known.

#include <exception>
#include <nlohmann/json.hpp>
#include <string>

namespace tramline::app {

/// Whoever read stdout has gone (`tramline … | head -1`): nobody is left to tell, so the program ends
/// quietly.
class OutputClosed : public std::exception {
 public:
  const char* what() const noexcept override { return "stdout is closed"; }
};

/// Writing to a closed pipe is an error of the write from now on, and no longer the end of the process: files
/// under way are finished or taken away.
void report_closed_pipes();

/// Ends the process as the signal would have that report_closed_pipes() puts off.
[[noreturn]] void end_as_by_closed_pipe();

/// Hands over what was printed so far. Throws OutputClosed where nobody reads it, and Error(kFailure) where
/// it cannot be written otherwise.
void flush_output();

/// Prints the text and hands it over. Throws as flush_output() does.
void print_result(const std::string& text);

/// Prints one JSON result on a line of its own, with `format_version` (docs/json.md) as its first key.
void print_json_line(const nlohmann::ordered_json& result);
/// The same over several lines, indented.
void print_json(const nlohmann::ordered_json& result);

}  // namespace tramline::app
