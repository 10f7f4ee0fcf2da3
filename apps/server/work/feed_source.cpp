#include "server/work/feed_source.h"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

#include "tramline/geometry/error.h"

namespace tramline::server {
namespace {

constexpr const char* kForms =
    "give tcp://HOST:PORT, udp://:PORT, gpsd://HOST:PORT, serial:///dev/ttyUSB0,115200 or file:///home/me/"
    "drive.csv";

int port_in(const std::string& source, std::string_view place) {
  if (place.starts_with(':')) place.remove_prefix(1);
  int port = 0;
  const auto [end, fault] = std::from_chars(place.data(), place.data() + place.size(), port);
  if (fault != std::errc() || end != place.data() + place.size() || port < 1 || port > 65535)
    throw bad_input(fmt::format("{}: give the port that the lines are sent to, as udp://:4001", source));
  return port;
}

/// The path of file:///home/me and of serial:///dev/tty; "localhost" before it is this machine, too.
std::string path_in(const std::string& source, std::string_view place) {
  constexpr std::string_view kHere = "localhost";
  if (place.starts_with(kHere)) place.remove_prefix(kHere.size());
  if (!place.starts_with('/'))
    throw bad_input(fmt::format("{}: give the whole path, with three slashes: {}", source, kForms));
  return std::string(place);
}

}  // namespace

std::unique_ptr<io::Feed> open_feed(const std::string& source, const FeedSources& sources) {
  const std::size_t mark = source.find("://");
  if (mark == std::string::npos || source.find('\0') != std::string::npos)
    throw bad_input(fmt::format("'{}' is not a source of a live feed: {}", source, kForms));
  const std::string kind = source.substr(0, mark), place = source.substr(mark + 3);
  if (kind == "tcp") return io::tcp_feed(place, io::WhenLost::kReopen);
  if (kind == "udp") return io::udp_feed(port_in(source, place));
  if (kind == "gpsd") return io::gpsd_feed(place, io::WhenLost::kReopen);
  if (kind == "file") {
    const std::string file = path_in(source, place);
    sources.folders.require(file);
    return io::file_feed(
        file, [folders = sources.folders](const std::string& opened) { return folders.hold(opened); });
  }
  if (kind == "serial") {
    if (!sources.serial_devices)
      throw bad_input(fmt::format(
          "{}: serial devices are opened only for pages on the same machine; use tcp://, udp:// or gpsd://",
          source));
    const std::string device = path_in(source, place);
    if (!device.starts_with("/dev/"))
      throw bad_input(fmt::format("{}: serial devices are in /dev, such as serial:///dev/ttyUSB0", source));
    return io::serial_feed(device, io::WhenLost::kReopen);
  }
  throw bad_input(fmt::format("'{}' is not a source of a live feed: {}", source, kForms));
}

}  // namespace tramline::server
