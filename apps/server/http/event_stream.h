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

  /// Gives one back when it goes. Throws HttpError(kBusy) where there is none left.
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
  /// Sends an event. False where nobody listens any more.
  bool send(const std::string& event, const nlohmann::ordered_json& data);
  /// `data`: JSON in one line.
  bool send_text(const std::string& event, const std::string& data);
  /// Sends an empty message to find out whether somebody still listens.
  bool ping();

 private:
  bool write(const std::string& text);
  httplib::DataSink& sink_;
};

/// Answers with a stream: `more` is called again and again by a thread of the server, sends what there is,
/// waits for at most a second, and gives false at the end. The stream also ends when nobody listens or the
/// server stops. Throws HttpError(kBusy).
void stream_events(StreamPermits& permits, httplib::Response& response, std::function<bool(EventSink&)> more);

}  // namespace tramline::server
