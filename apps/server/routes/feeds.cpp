// Live feeds: begun, looked at, followed, ended.

#include <fmt/format.h>

#include <memory>
#include <string>
#include <utility>

#include "report/watch_report.h"
#include "server/drives/work_drive.h"
#include "server/drives/work_stream.h"
#include "server/http/http_error.h"
#include "server/http/page_words.h"
#include "server/input/drive_input.h"
#include "server/input/json_input.h"
#include "server/routes/routes.h"
#include "server/store/new_id.h"
#include "server/work/feed_source.h"
#include "tramline/geometry/error.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

ordered_json listed(const OpenFeed& open) {
  const FeedNote& note = open.note;
  const std::string problem = open.feed->problem();
  return {{"id", note.id},
          {"name", note.name},
          {"source", note.source},
          {"field", note.field.empty() ? ordered_json() : ordered_json(note.field)},
          {"created", note.created},
          {"fixes", open.feed->fixes()},
          {"ended", open.feed->ended()},
          {"problem", problem.empty() ? ordered_json() : ordered_json(in_page_words(problem))}};
}

ordered_json in_full(const OpenFeed& open) {
  ordered_json out = listed(open);
  out["width_m"] = nullptr;
  if (open.note.log.options.drive.width_m > 0) out["width_m"] = open.note.log.options.drive.width_m;
  out["options"] = drive_options_json(open.note.log.options);
  out["summary"] = app::live_json(open.feed->figures());
  return out;
}

/// --tcp is how a command line says it.
std::string for_the_page(std::string sentence) {
  for (const char* option : {"--tcp", "--udp", "--gpsd", "--serial", "--follow"})
    for (std::size_t at = sentence.find(option); at != std::string::npos; at = sentence.find(option))
      sentence.replace(at, std::string(option).size(), std::string(option).substr(2));
  return sentence;
}

OpenFeed begin(App& app, const ordered_json& json) {
  const JsonInput input(json, "", {"source", "field", "width_m", "options", "name"});
  FeedNote note;
  note.id = new_id();
  note.created = time_now();
  note.source = input.text("source");
  note.name = name_of(input, "name");
  if (note.name.empty()) note.name = note.source;
  note.field = input.text_or_none("field");
  note.log.options = drive_options_in(json.value("options", ordered_json()), input.number_if("width_m"));
  note.log.log_name = note.source;
  note.log.extension = ".log";
  const app::WorkGround ground = ground_of(app, note.field);
  std::shared_ptr<void> room = app.drives->feeds.take_room();
  try {
    return app.drives->feeds.open(note, open_feed(note.source, app.drives->sources), ground, std::move(room));
  } catch (const Error& error) {
    throw Error(error.kind(), for_the_page(error.what()));
  }
}

/// Work that nobody follows.
class Unfollowed : public JobRun {
 public:
  void progress(int, int) override {}
  void step(const std::string&) override {}
  void check() override {}
};

/// The drive of a feed that is no longer read.
ordered_json keep(App& app, const FeedNote& note, JobRun& run) {
  DriveStore& store = app.drives->store;
  // A server that was killed may have kept it and not yet said so.
  if (store.has(note.id)) {
    app.drives->feeds.remove_files(note.id);
    return {{"drive", note.id}};
  }
  DriveOrder order;
  order.id = note.id;
  order.name = note.name;
  order.created = note.created;
  order.field = note.field;
  order.source = note.log;
  // The field may have been deleted meanwhile.
  try {
    if (!order.field.empty()) app.fields.get(order.field);
  } catch (const HttpError&) {
    order.field.clear();
  }
  const std::shared_ptr<void> log =
      store.take_log(order.id, order.source, app.drives->feeds.raw_log(note.id));
  const std::string id = work_drive(app, order, run).id;
  app.drives->feeds.remove_files(note.id);
  return {{"drive", id}};
}

ordered_json end(App& app, const std::string& id) {
  const OpenFeed open = app.drives->feeds.take(id);
  open.feed->stop();
  if (open.feed->fixes() == 0 && open.feed->problem().empty()) {
    app.drives->feeds.remove_files(id);
    return {{"drive", nullptr}, {"message", "no position came, so that there is no drive to keep"}};
  }
  Unfollowed run;
  try {
    return keep(app, open.note, run);
  } catch (const Error& error) {
    return {{"drive", nullptr},
            {"message", fmt::format("{}; what came is kept in {}", in_page_words(error.what()),
                                    app.drives->feeds.raw_log(id).string())}};
  }
}

void take_up_left_feeds(App& app) {
  for (const FeedNote& note : app.drives->feeds.left()) {
    std::error_code fault;
    if (std::filesystem::file_size(app.drives->feeds.raw_log(note.id), fault) == 0 || fault) {
      app.drives->feeds.remove_files(note.id);
      continue;
    }
    try {
      app.jobs.submit("evaluate", "taking up " + note.name,
                      [&app, note](JobRun& run) { return keep(app, note, run); });
    } catch (const HttpError&) {
      return;  // too many at once: the others are taken up at the next start
    }
  }
}

}  // namespace

void add_feed_routes(Router& router, App& app) {
  take_up_left_feeds(app);
  router.get(api("/feeds"), [&app](const Call&, httplib::Response& response) {
    ordered_json out = ordered_json::array();
    for (const OpenFeed& open : app.drives->feeds.list()) out.push_back(listed(open));
    answer(response, out);
  });
  router.post(api("/feeds"), [&app](const Call& call, httplib::Response& response) {
    answer(response, in_full(begin(app, call.json())), 201);
  });
  router.get(api("/feeds/{feed}"), [&app](const Call& call, httplib::Response& response) {
    answer(response, in_full(app.drives->feeds.get(call.part("feed"))));
  });
  router.get(api("/feeds/{feed}/events"), [&app](const Call& call, httplib::Response& response) {
    stream_work(app.streams, response,
                std::make_shared<FeedReader>(app.drives->feeds.get(call.part("feed")).feed),
                detail_in(call, kCoarsestWork_m));
  });
  router.post(api("/feeds/{feed}/work"), [&app](const Call& call, httplib::Response& response) {
    const ordered_json json = call.json();
    const JsonInput input(json, "", {"on"});
    if (!input.has("on")) throw bad_input("on has to be true or false");
    const OpenFeed open = app.drives->feeds.get(call.part("feed"));
    open.feed->set_work(input.flag_if("on").value_or(true));
    answer(response, listed(open));
  });
  router.remove(api("/feeds/{feed}"), [&app](const Call& call, httplib::Response& response) {
    answer(response, end(app, call.part("feed")));
  });
}

}  // namespace tramline::server
