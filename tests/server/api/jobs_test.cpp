#include <cmath>
#include <future>

#include "server/jobs/job_queue.h"
#include "server/served.h"

namespace tramline::server {
namespace {

using std::chrono::steady_clock;

double seconds_since(steady_clock::time_point start) {
  return std::chrono::duration<double>(steady_clock::now() - start).count();
}

/// Some 2 km across, with a wavy edge of 240 vertices: minutes of work to compare.
ordered_json wavy_field() {
  ordered_json ring = ordered_json::array();
  for (int i = 0; i <= 240; ++i) {
    const double angle = 2 * 3.14159265358979 * (i % 240) / 240, radius = 1 + 0.05 * std::sin(17 * angle);
    ring.push_back({9 + 0.014 * radius * std::cos(angle), 50 + 0.009 * radius * std::sin(angle)});
  }
  return {{"type", "Polygon"}, {"coordinates", {ring}}};
}

ordered_json long_job(const Served& served) {
  const std::string field = served.post("/fields", {{"name", "wavy"}, {"geometry", wavy_field()}}).json["id"];
  return {{"kind", "compare"}, {"field", field}, {"machine", {{"width_m", 1}, {"radius_m", 3}}}};
}

void wait_until_running(const Served& served, const std::string& id) {
  for (int i = 0; i < 1000 && served.get("/jobs/" + id).json["state"] != "running"; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

/// Until a search of the job has reported that it has done something, 10 s at most.
void wait_until_searching(const Served& served, const std::string& id) {
  for (int i = 0; i < 1000 && served.get("/jobs/" + id).json["done"] == 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

TEST_F(ServerTest, ALongJobIsCancelledAtOnce) {
  const std::string id = served.post("/jobs", long_job(served)).json["id"];
  wait_until_running(served, id);
  wait_until_searching(served, id);
  ASSERT_EQ(served.get("/jobs/" + id).json["state"], "running") << "the job is too short for this test";
  const auto start = steady_clock::now();
  EXPECT_EQ(served.remove("/jobs/" + id).status, 200);
  const ordered_json job = served.finished({{"id", id}});
  EXPECT_EQ(job["state"], "cancelled");
  EXPECT_TRUE(job["result"].is_null());
  // Tens of milliseconds, but for machines that do much else.
  EXPECT_LT(seconds_since(start), 3);
  EXPECT_EQ(served.remove("/jobs/" + id).json["state"], "cancelled") << "once more changes nothing";
}

TEST_F(ServerTest, JobsBeyondTheLimitWaitAndMayBeCancelledThere) {
  const ordered_json request = long_job(served);
  std::vector<std::string> ids;
  for (int i = 0; i < 3; ++i) ids.push_back(served.post("/jobs", request).json["id"]);
  wait_until_running(served, ids[1]);
  EXPECT_EQ(served.get("/jobs/" + ids[2]).json["state"], "queued");
  EXPECT_EQ(served.remove("/jobs/" + ids[2]).json["state"], "cancelled");
  const ordered_json list = served.get("/jobs").json;
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[2]["id"], ids[2]) << "those that run come first";
  for (const std::string& id : ids) served.remove("/jobs/" + id);
}

TEST_F(ServerTest, ManyPlansAtOnceAreAllTheSame) {
  const std::string field = served.field_of("plain-metres.gpkg");
  std::vector<std::future<ordered_json>> plans;
  for (int i = 0; i < 6; ++i)
    plans.push_back(std::async(std::launch::async, [&] {
      ordered_json summary = served.get("/plans/" + served.planned(field)).json["summary"];
      summary.erase("seconds");
      return summary;
    }));
  const ordered_json first = plans.front().get();
  EXPECT_GT(first["tracks"], 1);
  for (std::size_t i = 1; i < plans.size(); ++i) EXPECT_EQ(plans[i].get(), first);
  EXPECT_EQ(served.get("/plans").json.size(), 6U);
}

TEST_F(ServerTest, EventsTellHowAJobGoesAndEnds) {
  const std::string field = served.field_of("plain-metres.gpkg");
  const Got begun = served.post(
      "/jobs", {{"kind", "plan"}, {"field", field}, {"machine", {{"width_m", 6}, {"radius_m", 6}}}});
  httplib::Client client("127.0.0.1", served.port());
  client.set_read_timeout(60);
  std::string events;
  const auto result =
      client.Get("/api/v1/jobs/" + std::string(begun.json["id"]) + "/events",
                 httplib::Headers{{"Accept-Encoding", "gzip, br"}}, [&](const char* data, std::size_t size) {
                   events.append(data, size);
                   return true;
                 });
  ASSERT_TRUE(result);
  EXPECT_EQ(result->get_header_value("Content-Type"), "text/event-stream");
  EXPECT_TRUE(events.starts_with("event: ")) << events.substr(0, 100);
  const std::size_t last = events.rfind("event: ");
  EXPECT_TRUE(events.substr(last).starts_with("event: done\ndata: {")) << events.substr(last);
  const std::size_t data = events.find("data: ", last) + 6;
  const ordered_json job = ordered_json::parse(events.substr(data, events.find('\n', data) - data));
  EXPECT_EQ(job["state"], "done");
  EXPECT_EQ(served.get("/plans/" + std::string(job["result"]["plan"])).status, 200);
}

TEST(Streams, AreBoundedAndEndWithTheServer) {
  const testing_support::TemporaryFolder folder;
  ServerSettings settings;
  settings.limits.streams = 2;
  std::vector<std::thread> readers;
  std::atomic<int> open = 0, ended = 0;
  steady_clock::time_point stopped;
  {
    const Served served(folder.path(), settings);
    const std::string id = served.post("/jobs", long_job(served)).json["id"];
    const std::string path = "/api/v1/jobs/" + id + "/events";
    for (int i = 0; i < 2; ++i)
      readers.emplace_back([&, path, port = served.port()] {
        httplib::Client client("127.0.0.1", port);
        client.set_read_timeout(60);
        bool first = true;
        client.Get(path, [&](const char*, std::size_t) {
          open += first ? 1 : 0;
          first = false;
          return true;
        });
        ++ended;
      });
    while (open < 2) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    const Got third = served.get("/jobs/" + id + "/events");
    EXPECT_EQ(third.status, 503);
    EXPECT_EQ(third.code(), "busy");
    EXPECT_EQ(served.get("/fields").status, 200) << "other requests have threads of their own";
    stopped = steady_clock::now();
  }
  EXPECT_LT(seconds_since(stopped), 5) << "open streams and running jobs hold nothing up";
  for (std::thread& reader : readers) reader.join();
  EXPECT_EQ(ended, 2);
}

TEST_F(ServerTest, AFailedJobSaysWhy) {
  const std::string field = served.post("/fields", {{"name", "small"}, {"geometry", square()}}).json["id"];
  const Got begun = served.post(
      "/jobs", {{"kind", "plan"}, {"field", field}, {"machine", {{"width_m", 900}, {"radius_m", 6}}}});
  ASSERT_EQ(begun.status, 202) << begun.text;
  const ordered_json job = served.finished(begun.json);
  ASSERT_EQ(job["state"], "failed");
  EXPECT_EQ(job["error"]["code"], "bad_input");
  EXPECT_NE(std::string(job["error"]["message"]).find("900 m"), std::string::npos);
}

TEST_F(ServerTest, ASearchEndsAfterTheSecondsItIsGiven) {
  const std::string field = served.field_of("riverside.geojson");
  const auto planned = [&](const ordered_json& seconds) {
    const ordered_json job =
        served.job_of(served.post("/jobs", {{"kind", "plan"},
                                            {"field", field},
                                            {"machine", {{"width_m", 3}, {"radius_m", 6}}},
                                            {"objective", {{"minimise", "overlap"}}},
                                            {"seconds", seconds}}));
    EXPECT_EQ(job["state"], "done") << job.dump();
    return served.get("/plans/" + std::string(job["result"]["plan"])).json["summary"];
  };
  const ordered_json soon = planned(1e-6), late = planned(nullptr);
  EXPECT_TRUE(soon["cut_short"]);
  EXPECT_FALSE(late["cut_short"]);
  EXPECT_GE(soon["cost"], late["cost"]);
}

TEST_F(ServerTest, RefusesJobsThatMakeNoSense) {
  const std::string field = served.post("/fields", {{"name", "square"}, {"geometry", square()}}).json["id"];
  const ordered_json good{{"kind", "plan"}, {"field", field}, {"machine", {{"width_m", 3}, {"radius_m", 6}}}};
  const auto refused = [&](const char* key, const ordered_json& value, int status = 400) {
    ordered_json body = good;
    body[key] = value;
    const Got got = served.post("/jobs", body);
    EXPECT_EQ(got.status, status) << body.dump() << got.text;
    EXPECT_EQ(got.message().find("--"), std::string::npos) << got.message();
    return got.message();
  };
  refused("field", "20200101-000000-abcdef", 404);
  refused("field", "../../etc/passwd", 404);
  refused("field", 7);
  refused("kind", "dance");
  refused("kind", nullptr);
  refused("machine", {{"width_m", 0}, {"radius_m", 6}});
  refused("machine", {{"width_m", 1e300}, {"radius_m", 6}});
  refused("objective", {{"prices", {{"overlap", -1}, {"uncovered", 1}, {"turn", 1}}}});
  refused("objective", {{"minimise", "everything"}});
  refused("objective", ordered_json::object());
  EXPECT_NE(refused("settings", {{"strategy", "guess"}}).find("strategy takes best or sweep"),
            std::string::npos);
  EXPECT_NE(refused("seconds", 0).find("seconds has to be a number above 0"), std::string::npos);
  refused("settings", {{"headlands", 1.5}});
  refused("settings", {{"headlands", 101}});
  refused("settings", {{"line", {{9, 50}}}});
  refused("settings", {{"line", {{9, 50}, {9, "x"}}}});
  refused("settings", {{"curved", "auto"}, {"line", {{9, 50}, {9.001, 50}}}});
  EXPECT_NE(refused("setings", ordered_json::object()).find("setings"), std::string::npos);
  EXPECT_EQ(served.get("/jobs").json.size(), 0U) << "nothing was begun";
  EXPECT_EQ(served.get("/jobs/none").status, 404);
  EXPECT_EQ(served.get("/jobs/none/events").status, 404);
  EXPECT_EQ(served.remove("/jobs/none").status, 404);
  EXPECT_EQ(served.post("/jobs", {{"kind", "check"}, {"plan", "none"}}).status, 404);
}

TEST(JobQueue, RemembersTheLastOnes) {
  JobQueue queue(1, 10, 2);
  std::vector<std::string> ids;
  for (int i = 0; i < 4; ++i) {
    ids.push_back(queue.submit("plan", "work", [i](JobRun&) { return ordered_json(i); }).id);
    while (!is_over(queue.find(ids.back())->state)) std::this_thread::yield();
  }
  // The worker forgets after it has told.
  for (int i = 0; i < 1000 && queue.list().size() > 2; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_FALSE(queue.find(ids[0]) || queue.find(ids[1]));
  EXPECT_EQ(queue.find(ids[3])->result, 3);
}

TEST(JobQueue, LetsGoOfWhatIsCancelledWhileItWaits) {
  JobQueue queue(0, 100, 5);
  std::weak_ptr<int> held;
  for (int i = 0; i < 20; ++i) {
    auto kept = std::make_shared<int>(i);
    held = kept;
    const JobStatus job =
        queue.submit("plan", "", [kept = std::move(kept)](JobRun&) { return ordered_json(); });
    EXPECT_FALSE(held.expired());
    EXPECT_EQ(queue.cancel(job.id)->state, JobState::kCancelled);
    EXPECT_TRUE(held.expired());
  }
  EXPECT_EQ(queue.list().size(), 5U) << "no more are remembered than of those that ran";
}

TEST(JobQueue, TakesNoMoreThanItCanHold) {
  std::promise<void> go;
  const std::shared_future<void> gone = go.get_future().share();
  JobQueue queue(1, 2);
  const Work wait = [gone](JobRun&) {
    gone.wait();
    return ordered_json();
  };
  const std::string first = queue.submit("plan", "", wait).id;
  while (queue.find(first)->state != JobState::kRunning) std::this_thread::yield();
  queue.submit("plan", "", wait);
  queue.submit("plan", "", wait);
  EXPECT_THROW(queue.submit("plan", "", wait), HttpError);
  go.set_value();
}

}  // namespace
}  // namespace tramline::server
