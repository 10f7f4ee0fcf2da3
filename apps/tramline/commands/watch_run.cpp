#include "commands/watch_run.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <utility>

#include "report/report_parts.h"
#include "tramline/geometry/error.h"
#include "tramline/io/coverage/write_coverage.h"
#include "tramline/io/log/state_lines.h"

namespace tramline::app {
namespace {

using std::chrono::duration;
using std::chrono::milliseconds;

/// Without a fix for so long, something is wrong.
constexpr double kStalled_s = 3;

sigset_t end_signals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int one : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&set, one);
  return set;
}

}  // namespace

EndSignals::EndSignals() {
  const sigset_t set = end_signals();
  sigprocmask(SIG_BLOCK, &set, nullptr);
  // Writing tells, too, and a file too large is a full disk.
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);
  descriptor_ = signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC);
}

EndSignals::~EndSignals() {
  if (descriptor_ >= 0) close(descriptor_);
  const sigset_t set = end_signals();
  sigprocmask(SIG_UNBLOCK, &set, nullptr);
}

bool EndSignals::taken() const {
  signalfd_siginfo one{};
  while (read(descriptor_, &one, sizeof one) == sizeof one) {
  }
  return true;
}

WatchRun::WatchRun(WatchSession& session, io::Feed& feed, io::RawLog* log, const WatchOutput& output,
                   LineSource source)
    : session_(session),
      feed_(feed),
      log_(log),
      output_(output),
      source_(source),
      key_(source == LineSource::kStdin ? KeySource::kTerminal : KeySource::kStdin),
      terminal_(isatty(STDOUT_FILENO) == 1 && !output.json) {}

void WatchRun::say(const std::string& message) {
  if (shown_) std::fputs("\r\x1b[K", stdout);
  std::fflush(stdout);
  shown_ = false;
  std::fprintf(stderr, "tramline: %s\n", message.c_str());
}

void WatchRun::resume() {
  std::vector<std::string> lines = log_->take_lines_before();
  if (lines.empty()) return;
  for (const std::string& line : lines) session_.add(line);
  if (!output_.quiet)
    say(fmt::format("going on with {}.log: {} lines, {} fixes", output_.file, lines.size(),
                    session_.fixes()));
  if (source_ != LineSource::kFollowedFile) return;
  std::erase_if(lines, [](const std::string& line) { return line.starts_with(io::kOwnLine); });
  before_ = std::move(lines);
}

/// A file that is followed begins with what the raw log has of it.
bool WatchRun::known_already(const std::string& line) {
  if (line.starts_with(io::kOwnLine) || compared_ == before_.size()) return false;
  if (line != before_[compared_])
    throw bad_input(fmt::format(
        "{}.log was not made from {}: line {} differs; choose another -o, or move the raw log away",
        output_.file, feed_.name(), compared_ + 1));
  if (++compared_ == before_.size()) {
    before_ = {};
    compared_ = 0;
  }
  return true;
}

void WatchRun::take(io::Received& received) {
  for (const std::string& message : received.messages) say(message);
  std::erase_if(received.lines, [this](const std::string& line) { return known_already(line); });
  if (log_ != nullptr && !received.lines.empty()) {
    std::string text;
    for (const std::string& line : received.lines) (text += line) += '\n';
    log_->append(text);
  }
  const std::size_t fixes = session_.fixes();
  for (const std::string& line : received.lines) session_.add(line);
  if (session_.fixes() != fixes) last_fix_ = Clock::now();
}

void WatchRun::take_key() {
  const int pressed = key_.pressed();
  if (pressed % 2 == 0) return;
  if (session_.tells_work())
    return say("the log itself says whether the machine works: the key does nothing");
  if (works_at_ != session_.fixes() || works_at_ == 0) works_ = session_.live().working().value_or(works_);
  works_ = !works_;
  works_at_ = session_.fixes();
  const std::string line = io::work_line(works_);
  if (log_ != nullptr) log_->append(line + '\n');
  session_.add(line);
}

LiveFigures WatchRun::figures(bool final) const {
  LiveFigures out;
  out.evaluation.coverage = final ? session_.coverage() : session_.figures();
  out.evaluation.repeat = session_.repeat_rule();
  out.evaluation.seconds = duration<double>(Clock::now() - start_).count();
  out.final = final;
  out.settled = session_.settled();
  out.present_m2_per_s = session_.live().present_m2_per_s();
  out.time_s = session_.live().last_s();
  out.working = session_.live().working();
  const double silent_s = duration<double>(Clock::now() - last_fix_).count();
  if (!final && silent_s > kStalled_s) out.stalled_s = silent_s;
  out.looks_ahead = !final && output_.look_ahead;
  if (out.looks_ahead) out.ahead = session_.look_ahead(*output_.look_ahead);
  out.work_key = key_.descriptor() >= 0 && !session_.tells_work();
  return out;
}

void WatchRun::show() {
  if (output_.json) {
    fmt::print("{}\n", json_line(versioned(live_json(figures(false)))));
    std::fflush(stdout);
    return;
  }
  if (output_.quiet) return;
  const std::string line = status_line(figures(false));
  if (terminal_)
    fmt::print("\r{}\x1b[K", line);
  else
    fmt::print("{}\n", line);
  shown_ = terminal_;
  std::fflush(stdout);
}

void WatchRun::watch_log() {
  if (log_ == nullptr) return;
  log_->retry();
  if (log_->fault() == log_fault_) return;
  log_fault_ = log_->fault();
  say(log_fault_.empty() ? fmt::format("{}.log can be written again, and lacks nothing", output_.file)
                         : fmt::format("{}.log cannot be written ({}): measuring goes on, and what came is "
                                       "written as soon as that is possible",
                                       output_.file, log_fault_));
}

void WatchRun::save_in_background() {
  std::string fault;
  if (saver_.ended(fault) && fault != save_fault_) {
    save_fault_ = fault;
    if (!fault.empty()) say(fault + ": measuring goes on");
  }
  if (output_.file.empty() || session_.fixes() < 2 ||
      Clock::now() - last_save_ < duration<double>(output_.save_every_s))
    return;
  last_save_ = Clock::now();
  saver_.start([this] {
    log_->abandon();
    session_.settle();
    io::write_coverage(session_.coverage(), output_.file);
  });
}

void WatchRun::tick() {
  show();
  watch_log();
  save_in_background();
}

int WatchRun::wait_ms() const {
  const auto left = std::chrono::ceil<milliseconds>(next_tick_ - Clock::now());
  const int tick_ms = static_cast<int>(std::clamp<long long>(left.count(), 0, 1000));
  return feed_.wait_ms() < 0 ? tick_ms : std::min(tick_ms, feed_.wait_ms());
}

int WatchRun::run(const EndSignals& signals) {
  if (log_ != nullptr) resume();
  next_tick_ = Clock::now() + milliseconds(1000);
  bool ended = false, more = false, by_signal = false;
  while (!ended) {
    std::array<pollfd, 3> wanted{
        {{feed_.descriptor(), POLLIN, 0}, {signals.descriptor(), POLLIN, 0}, {key_.descriptor(), POLLIN, 0}}};
    const int ready = poll(wanted.data(), wanted.size(), more ? 0 : wait_ms());
    if (ready > 0 && wanted[1].revents != 0) {
      by_signal = signals.taken();
      break;
    }
    if (ready > 0 && wanted[2].revents != 0) take_key();
    // A feed that asks to be called is; any other only when it has something, for reading stdin waits.
    if (more || wanted[0].revents != 0 || feed_.wait_ms() >= 0) {
      io::Received received = feed_.receive();
      take(received);
      more = received.more;
      ended = received.ended;
    }
    if (Clock::now() >= next_tick_) {
      tick();
      next_tick_ += milliseconds(1000);
      if (next_tick_ < Clock::now()) next_tick_ = Clock::now() + milliseconds(1000);
      if (std::ferror(stdout) != 0) break;
    }
  }
  if (const std::string rest = feed_.rest(); !rest.empty()) {
    // The line of a file that is followed may still be completed: it is measured, and not kept.
    if (log_ != nullptr && source_ != LineSource::kFollowedFile) log_->append(rest + '\n');
    if (!known_already(rest)) session_.add(rest);
  }
  session_.finish();
  if (session_.fixes() < 2 && !by_signal)
    throw bad_input(fmt::format("{} ended with {} that has a position; at least two are needed", feed_.name(),
                                session_.fixes() == 0 ? "no fix" : "one fix"));
  finish();
  return 0;
}

void WatchRun::finish() {
  saver_.stop();
  const LiveFigures last = figures(true);
  if (shown_) std::fputs("\r\x1b[K", stdout);
  shown_ = false;
  if (output_.json)
    fmt::print("{}\n", json_line(versioned(live_json(last))));
  else if (!output_.quiet)
    fmt::print("{}", evaluation_table(last.evaluation));
  std::fflush(stdout);
  watch_log();
  if (!output_.file.empty()) io::write_coverage(last.evaluation.coverage, output_.file);
}

}  // namespace tramline::app
