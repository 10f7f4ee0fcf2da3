// Sources of lines: files that change, and what cannot be opened. Sockets, serial devices and gpsd are met in
// tests/watch, from outside.

#include "tramline/io/feed/feed.h"
#include "support/refusals.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tramline/geometry/error.h"
#include "tramline/io/feed/connection.h"

namespace tramline::io {
namespace {

class Followed : public testing::Test {
 protected:
  void SetUp() override {
    path_ = (std::filesystem::temp_directory_path() / ("feed_" + std::to_string(getpid()) + ".log")).string();
    std::ofstream(path_) << "a\nb";
  }
  void TearDown() override { std::filesystem::remove(path_); }

  void append(const std::string& text) const { std::ofstream(path_, std::ios::app) << text; }
  /// All that is there now.
  static std::vector<std::string> lines_of(Feed& feed) {
    std::vector<std::string> out;
    for (bool more = true; more;) {
      const Received received = feed.receive();
      EXPECT_FALSE(received.ended);
      out.insert(out.end(), received.lines.begin(), received.lines.end());
      more = received.more;
    }
    return out;
  }
  using Lines = std::vector<std::string>;

  std::string path_;
};

TEST_F(Followed, LinesComeWhenTheyAreWhole) {
  const auto feed = file_feed(path_);
  EXPECT_EQ(lines_of(*feed), Lines{"a"});
  append("b\nc");
  EXPECT_EQ(lines_of(*feed), Lines{"bb"});
  EXPECT_EQ(feed->rest(), "c");
}

TEST_F(Followed, WhoWaitsIsWoken) {
  const auto feed = file_feed(path_);
  lines_of(*feed);
  pollfd wanted{feed->descriptor(), POLLIN, 0};
  EXPECT_EQ(poll(&wanted, 1, 0), 0) << "nothing to do, and no waiting in a circle";
  append("more\n");
  EXPECT_EQ(poll(&wanted, 1, 1000), 1);
  EXPECT_EQ(lines_of(*feed), Lines{"bmore"});
  EXPECT_EQ(poll(&wanted, 1, 0), 0);
}

TEST_F(Followed, AFileThatBeginsAnew) {
  const auto feed = file_feed(path_);
  lines_of(*feed);
  std::ofstream(path_, std::ios::trunc) << "n\n";
  EXPECT_EQ(lines_of(*feed), Lines{"n"});
  std::ofstream(path_ + ".new") << "other\n";
  std::filesystem::rename(path_ + ".new", path_);
  EXPECT_EQ(lines_of(*feed), Lines{"other"});
}

TEST(Feeds, WhatCannotBeOpenedIsRefused) {
  EXPECT_REFUSED(file_feed("/no/such/file"));
  EXPECT_REFUSED(file_feed("/tmp"));
  EXPECT_REFUSED(serial_feed("/no/such/device", WhenLost::kEnd));
  EXPECT_REFUSED(serial_feed("/dev/null,12345", WhenLost::kEnd));
  EXPECT_REFUSED(tcp_feed("tractor", WhenLost::kEnd));
  EXPECT_REFUSED(tcp_feed("tractor:0", WhenLost::kEnd));
  EXPECT_REFUSED(tcp_feed(":80", WhenLost::kEnd));
}

TEST(Feeds, HostsAndPorts) {
  const auto parts = [](const char* text, const char* port) {
    const HostPort out = host_and_port(text, "--tcp", port);
    return out.host + " " + out.port;
  };
  EXPECT_EQ(parts("tractor:5017", ""), "tractor 5017");
  EXPECT_EQ(parts("[::1]:5017", ""), "::1 5017");
  EXPECT_EQ(parts("tractor", "2947"), "tractor 2947");
  EXPECT_EQ(parts("::1", "2947"), "::1 2947");
  EXPECT_EQ(parts("[::1]", "2947"), "::1 2947");
}

}  // namespace
}  // namespace tramline::io
