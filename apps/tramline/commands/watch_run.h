#pragma once
// The loop of `watch`: waits for lines, keys, signals and the second.

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "output/coverage_saver.h"
#include "output/work_key.h"
#include "report/watch_report.h"
#include "request/watch_session.h"
#include "tramline/io/feed/feed.h"
#include "tramline/io/feed/raw_log.h"

namespace tramline::app {

struct WatchOutput {
  std::string file;  ///< coverage file; empty: none, and no raw log
  double save_every_s = 60;
  bool json = false;
  bool quiet = false;
  std::optional<coverage::SwitchRule> look_ahead;
};

/// SIGINT, SIGTERM and SIGHUP are something to read, not an end, while it lives; a reader of our output that
/// is gone is no end either.
class EndSignals {
 public:
  EndSignals();
  EndSignals(const EndSignals&) = delete;
  EndSignals& operator=(const EndSignals&) = delete;
  ~EndSignals();
  int descriptor() const { return descriptor_; }
  /// Those that came do nothing more.
  bool taken() const;

 private:
  int descriptor_ = -1;
};

/// Where the lines of a log come from.
enum class LineSource {
  kStdin,
  kFollowedFile,  ///< from its beginning: with the lines that the raw log has already
  kDevice,        ///< a server, a port, a receiver
};

class WatchRun {
 public:
  /// All outlive it. `log`: null without -o.
  WatchRun(WatchSession& session, io::Feed& feed, io::RawLog* log, const WatchOutput& output,
           LineSource source);

  /// Until the stream ends or a signal comes. Returns the exit code.
  int run(const EndSignals& signals);

 private:
  using Clock = std::chrono::steady_clock;

  void resume();
  void take(io::Received& received);
  bool known_already(const std::string& line);
  void take_key();
  void say(const std::string& message);
  void tick();
  void save_in_background();
  void watch_log();
  void show();
  void finish();
  LiveFigures figures(bool final) const;
  int wait_ms() const;

  WatchSession& session_;
  io::Feed& feed_;
  io::RawLog* log_;
  WatchOutput output_;
  LineSource source_;
  WorkKey key_;
  CoverageSaver saver_;
  bool terminal_;
  bool shown_ = false;
  std::vector<std::string> before_;  ///< lines of the stream that the raw log has, to be compared with
  std::size_t compared_ = 0;
  bool works_ = true;
  std::size_t works_at_ = 0;  ///< fixes when the key was pressed last
  std::string log_fault_, save_fault_;
  Clock::time_point start_ = Clock::now(), last_fix_ = start_, next_tick_ = start_, last_save_ = start_;
};

}  // namespace tramline::app
