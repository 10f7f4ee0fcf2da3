#include "output/coverage_saver.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <exception>

namespace tramline::app {

void CoverageSaver::start(const std::function<void()>& write) {
  if (busy()) return;
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return;
  const pid_t parent = getpid();
  child_ = fork();
  if (child_ == 0) {
    // One that outlived its parent could overwrite what a later watch wrote.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);
    std::string fault;
    try {
      write();
    } catch (const std::exception& error) {
      fault = error.what();
    }
    const bool told = ::write(ends[1], fault.data(), fault.size()) == static_cast<ssize_t>(fault.size());
    // Nothing of the parent's is flushed or put back.
    _exit(told && fault.empty() ? 0 : 1);
  }
  close(ends[1]);
  if (child_ > 0)
    pipe_ = ends[0];
  else
    close(ends[0]);
}

bool CoverageSaver::ended(std::string& fault) {
  int status = 0;
  if (!busy() || waitpid(child_, &status, WNOHANG) != child_) return false;
  std::array<char, 4096> text{};
  const ssize_t got = read(pipe_, text.data(), text.size());
  fault.assign(text.data(), got > 0 ? static_cast<std::size_t>(got) : 0);
  if (fault.empty() && status != 0) fault = "the copy of the program that was to write it failed";
  close(pipe_);
  child_ = pipe_ = -1;
  return true;
}

void CoverageSaver::stop() {
  if (!busy()) return;
  kill(child_, SIGKILL);
  waitpid(child_, nullptr, 0);
  close(pipe_);
  child_ = pipe_ = -1;
}

}  // namespace tramline::app
