#pragma once
// A temporary folder for files that are to be sent or moved to their final location.

#include <filesystem>

#include "server/store/store_folder.h"

namespace tramline::server {

/// A folder of its own on the disk of the store; gone with this, or at the next start.
class ScratchFolder {
 public:
  explicit ScratchFolder(const StoreFolder& folder);
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace tramline::server
