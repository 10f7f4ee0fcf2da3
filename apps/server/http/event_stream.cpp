#include "server/http/event_stream.h"

#include <fmt/format.h>

#include <utility>

#include "report/report_parts.h"
#include "server/http/http_error.h"

namespace tramline::server {

std::shared_ptr<void> StreamPermits::take() {
  if (open_.fetch_add(1) >= most_) {
    --open_;
    throw HttpError(
        Fault::kBusy,
        fmt::format("{} live views are open already, which is as many as there can be; close one of "
                    "them, such as another tab of this page",
                    most_));
  }
  return {this, [this](void*) { --open_; }};
}

bool EventSink::send(const std::string& event, const nlohmann::ordered_json& data) {
  return send_text(event, app::json_line(data));
}

bool EventSink::send_text(const std::string& event, const std::string& data) {
  return write(fmt::format("event: {}\ndata: {}\n\n", event, data));
}

bool EventSink::ping() { return write(": \n\n"); }

bool EventSink::write(const std::string& text) { return sink_.write(text.data(), text.size()); }

void stream_events(StreamPermits& permits, httplib::Response& response,
                   std::function<bool(EventSink&)> more) {
  std::shared_ptr<void> permit = permits.take();
  response.set_header("Cache-Control", "no-store");
  response.set_header("X-Accel-Buffering", "no");
  response.set_chunked_content_provider(
      "text/event-stream",
      [&permits, permit = std::move(permit), more = std::move(more)](std::size_t, httplib::DataSink& sink) {
        EventSink events(sink);
        try {
          if (permits.stopping() || !more(events)) sink.done();
        } catch (...) {
          const Answer problem = answer_to(std::current_exception());
          events.send("error", {{"code", word_of(problem.fault)}, {"message", problem.sentence}});
          sink.done();
        }
        return true;
      });
}

}  // namespace tramline::server
