#pragma once
// A folder in GDAL's memory, so that nothing half-written is ever on the disk.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace tramline::io {

/// The folder is deleted at the end of the scope, with everything in it.
class MemoryFolder {
 public:
  MemoryFolder();
  MemoryFolder(const MemoryFolder&) = delete;
  MemoryFolder& operator=(const MemoryFolder&) = delete;
  ~MemoryFolder();

  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }
  /// Names, ascending.
  std::vector<std::string> files() const;
  /// Valid as long as nobody writes to the file; empty where there is none.
  std::span<const std::byte> bytes(const std::string& name) const;

 private:
  std::string path_;
};

}  // namespace tramline::io
