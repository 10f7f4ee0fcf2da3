#pragma once
// The folders whose files a live feed may read.

#include <filesystem>
#include <string>
#include <vector>

namespace tramline::server {

/// Whoever uses the server may have any line of such a file, so that these are named by who starts it.
class FeedFolders {
 public:
  FeedFolders() = default;
  /// Throws bad_input where one of them is no folder that is there.
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
