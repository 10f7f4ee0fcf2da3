#include <fcntl.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/io/feed/descriptor.h"
#include "tramline/io/feed/feed.h"
#include "tramline/io/feed/line_splitter.h"

namespace tramline::io {
namespace {

using std::chrono::steady_clock;

constexpr const char* kUsualBaud = "115200";
constexpr std::array<std::pair<const char*, speed_t>, 12> kSpeeds = {{{"1200", B1200},
                                                                      {"2400", B2400},
                                                                      {"4800", B4800},
                                                                      {"9600", B9600},
                                                                      {"19200", B19200},
                                                                      {"38400", B38400},
                                                                      {"57600", B57600},
                                                                      {"115200", B115200},
                                                                      {"230400", B230400},
                                                                      {"460800", B460800},
                                                                      {"921600", B921600},
                                                                      {"1000000", B1000000}}};

speed_t speed_of(const std::string& baud) {
  const auto at =
      std::find_if(kSpeeds.begin(), kSpeeds.end(), [&](const auto& s) { return s.first == baud; });
  if (at != kSpeeds.end()) return at->second;
  std::string list;
  for (const auto& [known, speed] : kSpeeds) list += (list.empty() ? "" : ", ") + std::string(known);
  throw bad_input(fmt::format("--serial: {} is not a known speed; known are {}", baud, list));
}

class SerialFeed final : public Feed {
 public:
  SerialFeed(const std::string& device_and_baud, WhenLost lost) : lost_(lost) {
    const std::size_t comma = device_and_baud.find(',');
    device_ = device_and_baud.substr(0, comma);
    speed_ = speed_of(comma == std::string::npos ? kUsualBaud : device_and_baud.substr(comma + 1));
    if (const std::string cause = open_device(); !cause.empty())
      throw bad_input(fmt::format("--serial: '{}' cannot be opened: {}", device_, cause));
  }

  std::string name() const override { return device_; }
  int descriptor() const override { return port_.number(); }
  int wait_ms() const override { return port_.open() ? -1 : kAgain_ms; }

  Received receive() override {
    Received out;
    if (!port_.open()) {
      if (steady_clock::now() < again_) return out;
      again_ = steady_clock::now() + std::chrono::milliseconds(kAgain_ms);
      if (open_device().empty()) out.messages.push_back(fmt::format("{} is there again", device_));
      return out;
    }
    std::string bytes;
    int fault = 0;
    const ReadResult result = read_some(port_, bytes, fault);
    splitter_.add(bytes, out.lines);
    out.more = result == ReadResult::kBytes;
    if (result != ReadResult::kEnd && result != ReadResult::kFault) return out;
    splitter_.take_rest();
    port_.reset();
    again_ = steady_clock::now() + std::chrono::milliseconds(kAgain_ms);
    out.messages.push_back(fmt::format("{} is unplugged ({}){}", device_,
                                       result == ReadResult::kEnd ? "no device" : words_for(fault),
                                       lost_ == WhenLost::kEnd ? "" : "; looking for it every second"));
    out.ended = lost_ == WhenLost::kEnd;
    return out;
  }

 private:
  /// The cause, or "" where it went well.
  std::string open_device() {
    Descriptor port(open(device_.c_str(), O_RDONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    if (!port.open()) return words_for(errno);
    termios mode{};
    if (tcgetattr(port.number(), &mode) != 0) return "it is no serial device";
    // Two readers would get half of the lines each.
    if (ioctl(port.number(), TIOCEXCL) != 0) return words_for(errno);
    cfmakeraw(&mode);
    mode.c_cflag |= CLOCAL | CREAD;
    cfsetispeed(&mode, speed_);
    cfsetospeed(&mode, speed_);
    if (tcsetattr(port.number(), TCSANOW, &mode) != 0) return words_for(errno);
    port_ = std::move(port);
    return "";
  }

  WhenLost lost_;
  std::string device_;
  speed_t speed_ = B0;
  Descriptor port_;
  steady_clock::time_point again_;
  LineSplitter splitter_;
};

}  // namespace

std::unique_ptr<Feed> serial_feed(const std::string& device_and_baud, WhenLost lost) {
  return std::make_unique<SerialFeed>(device_and_baud, lost);
}

}  // namespace tramline::io
