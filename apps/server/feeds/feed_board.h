#pragma once
// The live feeds of a server.

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "server/store/drive_store.h"
#include "server/store/store_folder.h"
#include "server/work/live_feed.h"

namespace tramline::server {

/// What a feed is, whether it still comes or not.
struct FeedNote {
  std::string id;
  std::string name;     ///< for people
  std::string source;   ///< "tcp://tractor:5017"
  std::string field;    ///< id; empty: none
  std::string created;  ///< "2026-03-14T08:15:00Z"
  DriveSource log;
};

struct OpenFeed {
  FeedNote note;
  std::shared_ptr<LiveFeed> feed;
  std::shared_ptr<void> room;  ///< of FeedBoard::take_room()
};

/// For each feed feeds/ID.json, feeds/ID.log with every line that came, and now and then feeds/ID.gpkg. They
/// stay until the drive is kept: a server that was killed finds them again. Safe for several threads.
class FeedBoard {
 public:
  FeedBoard(const StoreFolder& folder, std::size_t most) : folder_(folder), most_(most) {}

  /// A permit for one more feed, valid until it is destroyed. Throws HttpError(kBusy) where there are too
  /// many feeds already.
  std::shared_ptr<void> take_room();
  /// Begins to read. `room`: the permit from take_room(). `ground`: empty without a field. Throws kBadInput,
  /// failure.
  OpenFeed open(const FeedNote& note, std::unique_ptr<io::Feed> source, const app::WorkGround& ground,
                std::shared_ptr<void> room);
  /// All feeds, the latest first.
  std::vector<OpenFeed> list() const;
  /// The feed of that id; take() also removes it from the board, but keeps its files. Both throw
  /// HttpError(kNotFound).
  OpenFeed get(const std::string& id) const;
  OpenFeed take(const std::string& id);

  std::filesystem::path raw_log(const std::string& id) const;
  void remove_files(const std::string& id) const;
  /// Feeds of a server that ended without keeping their drives.
  std::vector<FeedNote> left() const;

 private:
  const StoreFolder& folder_;
  const std::size_t most_;
  std::atomic<std::size_t> open_ = 0;  ///< those that are only being opened, too
  mutable std::mutex mutex_;
  std::map<std::string, OpenFeed> feeds_;
};

}  // namespace tramline::server
