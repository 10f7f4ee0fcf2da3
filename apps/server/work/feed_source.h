#pragma once
// Where a live feed comes from, as one line of text.

#include <memory>
#include <string>

#include "tramline/io/feed/feed.h"

namespace tramline::server {

/// tcp://HOST:PORT, udp://:PORT, gpsd://HOST:PORT, serial:///dev/ttyUSB0,115200 or file:///…; `local`:
/// whether files and devices of this machine may be named. Waits 10 s at most for a connection. Throws
/// kBadInput, one sentence, where the text is none of these, or the source cannot be opened.
std::unique_ptr<io::Feed> open_feed(const std::string& source, bool local);

}  // namespace tramline::server
