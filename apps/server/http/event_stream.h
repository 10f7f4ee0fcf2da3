#pragma once
// Server-sent events. Each open stream holds a thread of the server, so there is a limit to them.

#include <httplib.h>

#include <atomic>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

namespace tramline::server {

/// How many streams may be open. Shared by all that count.
class StreamPermits {
 public:
  explicit StreamPermits(int most) : most_(most) {}
  int most() const { return most_; }
  int open() const { return open_; }
  /// Makes all streams end soon.
  void stop() { stopping_ = true; }
  bool stopping() const { return stopping_; }

  /// A permit for one stream, returned when it is destroyed. Throws HttpError(kBusy) where none is left.
  std::shared_ptr<void> take();

 private:
  const int most_;
  std::atomic<int> open_ = 0;
  std::atomic<bool> stopping_ = false;
};

/// A receiver of events. Not for several threads.
class EventSink {
 public:
  explicit EventSink(httplib::DataSink& sink) : sink_(sink) {}
  /// Sends an event. False where the client has gone.
  bool send(const std::string& event, const nlohmann::ordered_json& data);
  /// `data`: JSON in one line.
  bool send_text(const std::string& event, const std::string& data);
  /// Sends an empty message to find out whether the client is still there.
  bool ping();

 private:
  bool write(const std::string& text);
  httplib::DataSink& sink_;
};

/// Answers with a stream. A thread of the server calls `more` repeatedly; `more` sends the events that are
/// ready, waits for at most a second, and returns false at the end. The stream also ends when the client goes
/// or the server stops. Throws HttpError(kBusy).
void stream_events(StreamPermits& permits, httplib::Response& response, std::function<bool(EventSink&)> more);

}  // namespace tramline::server
