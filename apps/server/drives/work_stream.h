#pragma once
// Events of work as server-sent events.

#include <httplib.h>

#include <chrono>
#include <memory>
#include <utility>

#include "server/http/event_stream.h"
#include "server/http/router.h"
#include "server/http/shape_detail.h"
#include "server/work/work_json.h"

namespace tramline::server {

/// Work as it comes in is drawn no coarser, m.
inline constexpr double kCoarsestWork_m = 10;

/// What takes this long has to show that somebody still listens.
inline constexpr std::chrono::milliseconds kPingEvery{1000};

/// Answers with the events of a Replay or of a FeedReader, until its end. `detail_m`: of EventWriter. Throws
/// HttpError(kBusy).
template <class Source>
void stream_work(StreamPermits& permits, httplib::Response& response, std::shared_ptr<Source> source,
                 double detail_m) {
  auto writer = std::make_shared<EventWriter>(detail_m);
  stream_events(permits, response, [source = std::move(source), writer](EventSink& events) {
    const WorkEvent event = source->next(kPingEvery);
    if (std::holds_alternative<std::monostate>(event)) return !source->ended() && events.ping();
    const NamedEvent named = writer->named(event);
    return events.send_text(named.name, named.data) && !source->ended();
  });
}

}  // namespace tramline::server
