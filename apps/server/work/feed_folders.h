#pragma once
// The folders whose files a live feed may read.

#include <filesystem>
#include <string>
#include <vector>

namespace tramline::server {

/// The folders whose files live feeds may read. Every user of the server can see any line of these files, so
/// the folders are named by the person who starts the server.
class FeedFolders {
 public:
  FeedFolders() = default;
  /// Throws bad_input where one of them is not an existing folder.
  explicit FeedFolders(const std::vector<std::filesystem::path>& folders);

  /// Is the file, links resolved, a regular one in one of the folders or below? False where it is not there.
  bool hold(const std::filesystem::path& file) const;
  /// Throws bad_input, naming the folders, for a file elsewhere, whether it is there or not, and for devices,
  /// pipes and folders. A file that is missing in one of the folders passes.
  void require(const std::filesystem::path& file) const;

 private:
  bool are_above(const std::filesystem::path& resolved) const;

  std::vector<std::filesystem::path> folders_;  ///< links resolved
};

}  // namespace tramline::server
