#pragma once
// The state of a server for drives.
// Separate from App, so that only code for drives depends on the coverage engine.

#include <cstddef>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "server/feeds/feed_board.h"
#include "server/store/drive_store.h"
#include "server/work/feed_source.h"
#include "server/work/replay_cache.h"

namespace tramline::server {

/// Members are safe for several threads.
struct DriveRooms {
  DriveRooms(const StoreFolder& folder, std::size_t most_feeds, FeedSources feed_sources,
             std::vector<std::string>& warnings)
      : sources(std::move(feed_sources)), store(folder, warnings), feeds(folder, most_feeds) {}

  const FeedSources sources;
  DriveStore store;
  ReplayCache replays;
  FeedBoard feeds;
  std::mutex partfields;  ///< held while a partfield is looked up, and while it is stored if it is new
};

}  // namespace tramline::server
