// Clients that hang, send slowly or ask for the same many times over delay nobody else.

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <thread>
#include <vector>

#include "server/http/threads_on_demand.h"
#include "server/served.h"

namespace tramline::server {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

/// A connection that sends what it is given, and then nothing more.
class Hanging {
 public:
  Hanging(int port, const std::string& bytes) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
    EXPECT_EQ(send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL), static_cast<ssize_t>(bytes.size()));
  }
  Hanging(const Hanging&) = delete;
  Hanging& operator=(const Hanging&) = delete;
  ~Hanging() { close(socket_); }

 private:
  int socket_;
};

class SlowClients : public ServerTest {
 protected:
  void hang(int count, const std::string& head) {
    for (int i = 0; i < count; ++i)
      hanging_.push_back(std::make_unique<Hanging>(
          served.port(), head + "\r\nHost: " + served.own_host() + "\r\nContent-Length: 1000\r\n\r\n{"));
  }
  /// Of the slowest of ten answers, s.
  double slowest_answer_s() const {
    double out = 0;
    for (int i = 0; i < 10; ++i) {
      const auto start = steady_clock::now();
      EXPECT_EQ(served.get("/machines").status, 200);
      out = std::max(out, std::chrono::duration<double>(steady_clock::now() - start).count());
    }
    return out;
  }

  std::vector<std::unique_ptr<Hanging>> hanging_;
};

TEST_F(SlowClients, HangingUploadsDelayNobody) {
  hang(40, "POST /api/v1/uploads?name=a.gpkg HTTP/1.1");
  EXPECT_LT(slowest_answer_s(), 1);
  EXPECT_EQ(served.upload_example("riverside.geojson").status, 201);
}

TEST_F(SlowClients, HangingHeadersDelayNobody) {
  for (int i = 0; i < 40; ++i)
    hanging_.push_back(std::make_unique<Hanging>(served.port(), "GET /api/v1/machines HTTP/1.1\r\nHost: "));
  EXPECT_LT(slowest_answer_s(), 1);
}

TEST_F(SlowClients, MoreBodiesThanThereIsRoomForAreRefusedAtOnce) {
  hang(kMostBodies, "POST /api/v1/machines HTTP/1.1");
  Got last;
  for (int i = 0; i < 100 && last.status != 503; ++i) {
    last = served.post("/machines", {{"name", "drill"}, {"width_m", 6}, {"radius_m", 6}});
    std::this_thread::sleep_for(milliseconds(10));
  }
  EXPECT_EQ(last.status, 503) << last.text;
  EXPECT_EQ(last.code(), "busy");
  EXPECT_LT(slowest_answer_s(), 1);
  hanging_.clear();
  for (int i = 0; i < 100 && last.status != 201; ++i) {
    last = served.post("/machines", {{"name", "drill"}, {"width_m", 6}, {"radius_m", 6}});
    std::this_thread::sleep_for(milliseconds(10));
  }
  EXPECT_EQ(last.status, 201) << last.text;
}

class Ranges : public ServerTest {
 protected:
  void SetUp() override {
    const ordered_json quick{{"strategy", "sweep"}, {"route", false}};
    plan_ = "/plans/" + served.planned(served.field_of("riverside.geojson"), quick) + "/files/gpkg";
  }
  Got with_range(const std::string& range) {
    served.headers = {{"Range", range}};
    return served.get(plan_);
  }
  std::string plan_;
};

TEST_F(Ranges, OneIsAnswered) {
  const std::string whole = served.get(plan_).text;
  ASSERT_TRUE(whole.starts_with("SQLite format 3"));
  const Got part = with_range("bytes=7-12");
  EXPECT_EQ(part.status, 206);
  EXPECT_EQ(part.text, "format");
  EXPECT_EQ(with_range(fmt::format("bytes={}-", whole.size() - 5)).text, whole.substr(whole.size() - 5));
}

TEST_F(Ranges, OfSeveralNoneIsTakenAndTheWholeIsSent) {
  const std::string whole = served.get(plan_).text;
  std::string many = "bytes=0-";
  while (many.size() < 8000) many += ",0-";
  for (const std::string& ranges : {std::string("bytes=0-1,5-9"), many}) {
    const Got got = with_range(ranges);
    EXPECT_EQ(got.status, 200) << ranges.size();
    EXPECT_TRUE(got.text == whole) << got.text.size();
  }
}

TEST(ThreadsOnDemand, AreAsManyAsTasksWaitAndNoMoreThanAllowed) {
  ThreadsOnDemand threads(3);
  std::atomic<bool> go = false;
  std::atomic<int> running = 0, done = 0;
  for (int i = 0; i < 5; ++i)
    threads.enqueue([&] {
      ++running;
      while (!go) std::this_thread::sleep_for(milliseconds(1));
      ++done;
    });
  for (int i = 0; i < 1000 && running < 3; ++i) std::this_thread::sleep_for(milliseconds(1));
  EXPECT_EQ(running, 3);
  EXPECT_EQ(threads.threads(), 3U);
  go = true;
  threads.shutdown();
  EXPECT_EQ(done, 5);
}

TEST(ThreadsOnDemand, AnIdleOneIsTakenAgain) {
  ThreadsOnDemand threads(100);
  for (int i = 0; i < 20; ++i) {
    std::atomic<bool> done = false;
    threads.enqueue([&] { done = true; });
    while (!done) std::this_thread::yield();
    std::this_thread::sleep_for(milliseconds(5));
  }
  EXPECT_LE(threads.threads(), 2U);
}

}  // namespace
}  // namespace tramline::server
