#include "server/drives/drive_rooms.h"

#include "server/app.h"

namespace tramline::server {

std::shared_ptr<DriveRooms> make_drive_rooms(const StoreFolder& folder, const Limits& limits,
                                             std::vector<std::string>& warnings) {
  return std::make_shared<DriveRooms>(folder, static_cast<std::size_t>(limits.feeds), warnings);
}

}  // namespace tramline::server
