#include "server/store/scratch_folder.h"

#include <system_error>

#include "server/store/new_id.h"

namespace tramline::server {

ScratchFolder::ScratchFolder(const StoreFolder& folder) : path_(folder.path() / ".scratch" / new_id()) {
  std::filesystem::create_directories(path_);
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace tramline::server
