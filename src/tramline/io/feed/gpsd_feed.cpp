#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "tramline/io/feed/connection.h"
#include "tramline/io/feed/feed.h"
#include "tramline/io/feed/line_splitter.h"

namespace tramline::io {
namespace {

constexpr const char* kPort = "2947";
/// Sentences as the receiver wrote them keep all their digits; positions in JSON come without headings of
/// HDT.
constexpr const char* kRequest = "?WATCH={\"enable\":true,\"nmea\":true,\"json\":false}\n";

class GpsdFeed final : public Feed {
 public:
  GpsdFeed(const std::string& place, WhenLost lost)
      : place_(place.empty() ? std::string("localhost:") + kPort : place),
        lost_(lost),
        connection_(host_and_port(place_, "--gpsd", kPort), "gpsd does not answer; is it running?") {
    connection_.send(kRequest);
  }

  std::string name() const override { return "gpsd://" + place_; }
  int descriptor() const override { return connection_.descriptor(); }
  int wait_ms() const override { return connection_.wait_ms(); }

  Received receive() override {
    Received out;
    if (connection_.descriptor() < 0) {
      if (!connection_.try_again()) return out;
      connection_.send(kRequest);
      out.messages.push_back("gpsd is there again");
      return out;
    }
    std::string bytes;
    int fault = 0;
    const ReadResult result = connection_.read(bytes, fault);
    std::vector<std::string> lines;
    splitter_.add(bytes, lines);
    for (std::string& line : lines) {
      if (line.starts_with('{'))
        take_report(line, out);
      else
        out.lines.push_back(std::move(line));
    }
    out.more = result == ReadResult::kBytes;
    if (result == ReadResult::kEnd || result == ReadResult::kFault) {
      connection_.drop();
      splitter_.take_rest();
      out.messages.push_back(
          fmt::format("gpsd has gone{}", lost_ == WhenLost::kEnd ? "" : "; trying again every second"));
      out.ended = lost_ == WhenLost::kEnd;
    }
    return out;
  }

 private:
  /// What gpsd says besides sentences: which receivers it has.
  static void take_report(const std::string& line, Received& out) {
    const nlohmann::json report = nlohmann::json::parse(line, nullptr, false);
    if (!report.is_object() || !report.contains("class") || !report["class"].is_string()) return;
    if (report["class"] == "DEVICES" && report.contains("devices") && report["devices"].empty())
      out.messages.emplace_back("gpsd has no receiver yet; waiting for one");
    if (report["class"] == "DEVICE" && report.contains("activated") && report["activated"] == 0)
      out.messages.emplace_back("gpsd has lost its receiver; waiting for it");
  }

  std::string place_;
  WhenLost lost_;
  Connection connection_;
  LineSplitter splitter_;
};

}  // namespace

std::unique_ptr<Feed> gpsd_feed(const std::string& place, WhenLost lost) {
  return std::make_unique<GpsdFeed>(place, lost);
}

}  // namespace tramline::io
