#pragma once
// The source of a live feed, as one line of text.

#include <memory>
#include <string>

#include "server/work/feed_folders.h"
#include "tramline/io/feed/feed.h"

namespace tramline::server {

/// The sources on this machine that a live feed may read.
struct FeedSources {
  FeedFolders folders;          ///< files in them and below
  bool serial_devices = false;  ///< those that are attached here
};

/// tcp://HOST:PORT, udp://:PORT, gpsd://HOST:PORT, serial:///dev/ttyUSB0,115200 or file:///…. Waits 10 s at
/// most for a connection. Throws kBadInput, one sentence, where the text is none of these, or the source
/// cannot be opened.
std::unique_ptr<io::Feed> open_feed(const std::string& source, const FeedSources& sources);

}  // namespace tramline::server
