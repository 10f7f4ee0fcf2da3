#include "server/store/scratch_folder.h"

#include <system_error>

#include "server/store/new_id.h"
#include "tramline/geometry/error.h"

namespace tramline::server {

ScratchFolder::ScratchFolder(const StoreFolder& folder) : path_(folder.part(".scratch") / new_id()) {
  std::error_code error;
  if (!std::filesystem::create_directory(path_, error))
    throw failure("nothing can be written into the folder of the server (" + error.message() +
                  "); is the disk full?");
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace tramline::server
