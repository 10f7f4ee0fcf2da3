#include "server/drives/drive_rooms.h"

#include "server/app.h"
#include "server/http/gate.h"

namespace tramline::server {

std::shared_ptr<DriveRooms> make_drive_rooms(const StoreFolder& folder, const ServerSettings& settings,
                                             std::vector<std::string>& warnings) {
  std::vector<std::filesystem::path> folders = settings.feed_folders;
  folders.push_back(folder.path());
  return std::make_shared<DriveRooms>(folder, static_cast<std::size_t>(settings.limits.feeds),
                                      FeedSources{FeedFolders(folders), is_loopback(settings.host)},
                                      warnings);
}

}  // namespace tramline::server
