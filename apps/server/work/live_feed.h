#pragma once
// A live drive that any number of readers can follow.

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "report/watch_report.h"
#include "request/watch_session.h"
#include "server/work/wake_up.h"
#include "server/work/work_frame.h"
#include "tramline/io/feed/feed.h"
#include "tramline/io/feed/raw_log.h"

namespace tramline::server {

/// The settings of a live feed.
struct FeedOrder {
  std::unique_ptr<io::Feed> source;
  app::WorkGround ground;  ///< empty: no field
  coverage::EvaluateSettings settings;
  io::LogOptions log;
  std::filesystem::path raw_log;  ///< every line goes there at once
  /// Keeps what was driven so far, from the raw log; called every `save_every_s` and never twice at a time.
  std::function<void()> save;
  double save_every_s = 60;
};

/// Reads its source by a thread of its own, from when it is made until stop(). Safe for several threads.
class LiveFeed {
 public:
  /// Throws kBadInput where the raw log cannot be written.
  explicit LiveFeed(FeedOrder order);
  LiveFeed(const LiveFeed&) = delete;
  LiveFeed& operator=(const LiveFeed&) = delete;
  ~LiveFeed() { stop(); }

  /// Reads no more; waits for what is being saved. The figures are settled then.
  void stop();
  bool ended() const;
  /// Work on or off from now on. Throws kBadInput where the stream itself says whether the machine works, or
  /// no fix came yet.
  void set_work(bool on);
  /// Without regions. O(1).
  app::LiveFigures figures() const;
  std::size_t fixes() const;
  /// The reason why the feed ended by itself; "" where it did not.
  std::string problem() const;

 private:
  friend class FeedReader;
  using Clock = std::chrono::steady_clock;
  struct NumberedState {
    std::uint64_t number = 0;
    FeedState state;
  };

  void run();
  void read();
  void take(io::Received received);
  void add(const std::string& line);
  void tick();
  void keep_saving();
  void finish();
  void say(std::string message);
  bool connected() const;
  WorkFigures work_figures() const;

  FeedOrder order_;
  io::RawLog raw_;
  mutable std::mutex mutex_;  ///< of all below but the threads
  std::condition_variable news_;
  app::WatchSession session_;
  /// How many fixes there were, and when the last of them came: of the last few times any came.
  std::deque<std::pair<std::size_t, Clock::time_point>> came_;
  std::vector<Point> way_;
  std::size_t way_of_rebuild_ = 0;
  std::deque<NumberedState> states_;
  std::uint64_t said_ = 0;  ///< states so far
  bool connected_ = true;
  bool stalled_ = false;
  bool ended_ = false;
  std::string problem_, raw_fault_;
  Clock::time_point start_ = Clock::now(), last_fix_ = start_, last_tick_ = start_;

  bool stopping_ = false;
  WakeUp wake_;
  std::condition_variable saving_due_;
  std::thread saving_, reading_;
};

/// What one reader gets of a live feed: what the connection is like, a frame with all there is, and then
/// frames with what changed. For one thread at a time.
class FeedReader {
 public:
  explicit FeedReader(std::shared_ptr<LiveFeed> feed) : feed_(std::move(feed)) {}

  /// What is next; nothing where that takes longer than `most`. Nothing follows the end.
  WorkEvent next(std::chrono::milliseconds most);
  bool ended() const { return ended_; }

 private:
  using Clock = std::chrono::steady_clock;
  bool anything_new() const;
  Clock::time_point frame_at() const;
  WorkFrame frame();

  std::shared_ptr<LiveFeed> feed_;
  coverage::SeenWork seen_;
  std::size_t fixes_ = 0;
  std::size_t places_ = 0;
  std::uint64_t states_ = 0;
  bool told_state_ = false;
  bool ended_ = false;
  Clock::time_point last_frame_{};
};

}  // namespace tramline::server
