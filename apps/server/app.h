#pragma once
// What the routes share.

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "server/feeds/feed_board.h"
#include "server/http/event_stream.h"
#include "server/jobs/job_queue.h"
#include "server/store/drive_store.h"
#include "server/store/field_store.h"
#include "server/store/plan_store.h"
#include "server/store/store_folder.h"
#include "server/uploads/uploads.h"
#include "server/work/replay_cache.h"

namespace tramline::server {

struct Limits {
  std::size_t upload_bytes = std::size_t{256} << 20;
  int streams = 24;       ///< open at once
  int jobs = 2;           ///< running at once
  std::size_t feeds = 8;  ///< open at once
};

struct ServerSettings {
  std::filesystem::path folder;
  std::string host = "127.0.0.1";
  int port = 0;       ///< 0: any that is free
  std::string token;  ///< empty: none is asked for
  std::string tiles;  ///< URL of raster tiles; empty: none
  Limits limits;
};

/// Everything a server has while it runs. Members are safe for several threads.
struct App {
  explicit App(ServerSettings given)
      : settings(std::move(given)),
        folder(settings.folder),
        fields(folder, warnings),
        plans(folder, warnings),
        drives(folder, warnings),
        feeds(folder, settings.limits.feeds),
        uploads(folder),
        streams(settings.limits.streams),
        jobs(settings.limits.jobs) {}

  const ServerSettings settings;
  std::vector<std::string> warnings;  ///< about files in the folder; does not change after the start
  StoreFolder folder;
  FieldStore fields;
  PlanStore plans;
  DriveStore drives;
  ReplayCache replays;
  FeedBoard feeds;
  Uploads uploads;
  StreamPermits streams;
  JobQueue jobs;  ///< last: its work uses the others
};

}  // namespace tramline::server
