#pragma once
// Where the lines of a live log come from.

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tramline::io {

/// What a feed has to say at one time.
struct Received {
  std::vector<std::string> lines;     ///< without their ends
  std::vector<std::string> messages;  ///< for the user: a connection lost, or there again
  bool ended = false;                 ///< nothing more will come
  bool more = false;                  ///< there may be more at once
};

/// A source of lines. None of these blocks; who waits uses descriptor() and wait_ms().
class Feed {
 public:
  virtual ~Feed() = default;
  /// "tcp://tractor:5017"; the log's name.
  virtual std::string name() const = 0;
  /// To be waited on for reading; -1: none at present.
  virtual int descriptor() const = 0;
  /// receive() has to be called after so many milliseconds even when nothing is there; -1: no need.
  virtual int wait_ms() const = 0;
  /// What has come.
  virtual Received receive() = 0;
  /// What came of a line whose end did not come, at the end; "" where that is not to be trusted.
  virtual std::string rest() { return {}; }
};

/// All throw bad_input, in one sentence, where the source cannot be opened.

/// Standard input; ends with it.
std::unique_ptr<Feed> stdin_feed();
/// A file that is being written, from its beginning. It never ends; a file that is written anew, or replaced
/// by another of its name, is read from its beginning. Only regular files that `may_read` takes are read: it
/// is given the path, links resolved, of each file that was opened under the name. Without it any file is.
std::unique_ptr<Feed> file_feed(const std::string& path,
                                std::function<bool(const std::string& opened)> may_read = {});
/// What becomes of a feed whose source is lost.
enum class WhenLost { kReopen, kEnd };

/// What a server sends. `place`: "tractor:5017", "[::1]:5017". A lost connection is made again, or is the
/// end. Waits for the first connection, 10 s at most.
std::unique_ptr<Feed> tcp_feed(const std::string& place, WhenLost lost);
/// Datagrams that are sent to this port, by whomever. The end of one is the end of its last line.
std::unique_ptr<Feed> udp_feed(int port);
/// A serial device, 8N1, for this program alone: "/dev/ttyUSB0" or "/dev/ttyUSB0,38400" (115200 Bd unless
/// told). One that is unplugged is opened again when it is back, or that is the end.
std::unique_ptr<Feed> serial_feed(const std::string& device_and_baud, WhenLost lost);
/// NMEA sentences from gpsd: as the receiver sends them, or made by gpsd for receivers that speak otherwise.
/// `place`: "", "host", "host:port".
std::unique_ptr<Feed> gpsd_feed(const std::string& place, WhenLost lost);

}  // namespace tramline::io
