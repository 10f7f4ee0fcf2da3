#include <fmt/format.h>

#include "tramline/io/feed/connection.h"
#include "tramline/io/feed/feed.h"
#include "tramline/io/feed/line_splitter.h"

namespace tramline::io {
namespace {

class TcpFeed final : public Feed {
 public:
  TcpFeed(const std::string& place, WhenLost lost)
      : place_(place), lost_(lost), connection_(host_and_port(place, "--tcp", ""), "--tcp") {}

  std::string name() const override { return "tcp://" + place_; }
  int descriptor() const override { return connection_.descriptor(); }
  int wait_ms() const override { return connection_.wait_ms(); }

  Received receive() override {
    Received out;
    if (connection_.descriptor() < 0) {
      if (connection_.try_again()) out.messages.push_back(fmt::format("{} is there again", name()));
      return out;
    }
    std::string bytes;
    int fault = 0;
    const ReadResult result = connection_.read(bytes, fault);
    splitter_.add(bytes, out.lines);
    if (result == ReadResult::kNothingYet) return out;
    out.more = result == ReadResult::kBytes;
    if (!out.more) lose(out, result, fault);
    return out;
  }
  std::string rest() override { return splitter_.take_rest(); }

 private:
  void lose(Received& out, ReadResult result, int fault) {
    connection_.drop();
    out.ended = lost_ == WhenLost::kEnd;
    if (out.ended && result == ReadResult::kEnd) return;
    splitter_.take_rest();
    out.messages.push_back(fmt::format("the connection to {} is lost ({}){}", name(),
                                       result == ReadResult::kEnd ? "closed there" : words_for(fault),
                                       lost_ == WhenLost::kEnd ? "" : "; trying again every second"));
  }

  std::string place_;
  WhenLost lost_;
  Connection connection_;
  LineSplitter splitter_;
};

}  // namespace

std::unique_ptr<Feed> tcp_feed(const std::string& place, WhenLost lost) {
  return std::make_unique<TcpFeed>(place, lost);
}

}  // namespace tramline::io
