#pragma once
// The state shared by all routes.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "server/http/event_stream.h"
#include "server/jobs/job_queue.h"
#include "server/store/field_store.h"
#include "server/store/front_shelf.h"
#include "server/store/machine_store.h"
#include "server/store/plan_store.h"
#include "server/store/store_folder.h"
#include "server/uploads/uploads.h"
#include "tramline/io/raster/background_map.h"

namespace tramline::server {

struct Limits {
  std::size_t upload_bytes = std::size_t{256} << 20;
  int streams = 24;  ///< open at once
  int jobs = 2;      ///< running at once
  int feeds = 8;     ///< live ones, open at once
};

struct ServerSettings {
  std::filesystem::path folder;
  std::string host = "127.0.0.1";
  int port = 0;                      ///< 0: any that is free
  std::string token;                 ///< empty: no token is required
  std::string tiles;                 ///< URL of raster tiles; empty: none
  std::string tiles_attribution;     ///< the source of the tiles to name; empty: their host
  std::filesystem::path background;  ///< a picture of the land to show below the map; empty: none
  std::vector<std::filesystem::path>
      feed_folders;  ///< folders whose files live feeds may read, besides `folder`
  Limits limits;
};

/// The number of comparisons that are kept so that plans can be fetched from them; each holds 16 searches.
inline constexpr std::size_t kMostFronts = 8;

/// Drives and live feeds: drives/drive_rooms.h.
struct DriveRooms;
/// `folder` and `warnings` are those of App. Throws bad_input where a folder of feeds does not exist.
std::shared_ptr<DriveRooms> make_drive_rooms(const StoreFolder& folder, const ServerSettings& settings,
                                             std::vector<std::string>& warnings);

/// Everything a server has while it runs. Members are safe for several threads.
struct App {
  explicit App(ServerSettings given)
      : settings(std::move(given)),
        folder(settings.folder),
        fields(folder, warnings),
        plans(folder, warnings),
        machines(folder, warnings),
        fronts(kMostFronts),
        drives(make_drive_rooms(folder, settings, warnings)),
        uploads(folder),
        streams(settings.limits.streams),
        jobs(settings.limits.jobs) {}

  const ServerSettings settings;
  std::unique_ptr<io::BackgroundMap> background;  ///< null: none; opened before the first request
  std::vector<std::string> addresses;  ///< of the page, with the token; known before the first request
  std::vector<std::string> warnings;   ///< about files in the folder; does not change after the start
  StoreFolder folder;
  FieldStore fields;
  PlanStore plans;
  MachineStore machines;
  FrontShelf fronts;
  const std::shared_ptr<DriveRooms> drives;
  Uploads uploads;
  StreamPermits streams;
  JobQueue jobs;  ///< last: its work uses the others
};

}  // namespace tramline::server
