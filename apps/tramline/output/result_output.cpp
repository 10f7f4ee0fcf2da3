#include "output/result_output.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include "report/report_parts.h"
#include "tramline/geometry/error.h"

namespace tramline::app {
namespace {

[[noreturn]] void refuse(int cause) {
  if (cause == EPIPE) throw OutputClosed();
  throw failure("the result could not be written to stdout: is the disk full?");
}

}  // namespace

void report_closed_pipes() { std::signal(SIGPIPE, SIG_IGN); }

void end_as_by_closed_pipe() {
  std::signal(SIGPIPE, SIG_DFL);
  std::raise(SIGPIPE);
  std::_Exit(128 + SIGPIPE);  // where the signal is blocked
}

void flush_output() {
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) refuse(errno);
}

void print_result(const std::string& text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) refuse(errno);
  flush_output();
}

void print_json_line(const nlohmann::ordered_json& result) {
  print_result(json_line(versioned(result)) + '\n');
}

void print_json(const nlohmann::ordered_json& result) {
  print_result(json_text(versioned(result), 2) + '\n');
}

}  // namespace tramline::app
