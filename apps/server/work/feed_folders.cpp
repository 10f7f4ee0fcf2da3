#include "server/work/feed_folders.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "tramline/geometry/error.h"

namespace tramline::server {

namespace fs = std::filesystem;

FeedFolders::FeedFolders(const std::vector<fs::path>& folders) {
  for (const fs::path& folder : folders) {
    std::error_code fault;
    const fs::path resolved = fs::canonical(folder, fault);
    if (fault || !fs::is_directory(resolved, fault))
      throw bad_input(fmt::format(
          "'{}', a folder for live feeds, does not exist; make it, or name another one", folder.string()));
    folders_.push_back(resolved);
  }
}

bool FeedFolders::are_above(const fs::path& resolved) const {
  return std::any_of(folders_.begin(), folders_.end(), [&](const fs::path& folder) {
    // Part by part: /farm-old is not below /farm.
    const auto [end, at] = std::mismatch(folder.begin(), folder.end(), resolved.begin(), resolved.end());
    return end == folder.end() && at != resolved.end();
  });
}

bool FeedFolders::hold(const fs::path& file) const {
  std::error_code fault;
  const fs::path resolved = fs::canonical(file, fault);
  return !fault && are_above(resolved) && fs::is_regular_file(resolved, fault);
}

void FeedFolders::require(const fs::path& file) const {
  std::error_code fault;
  const fs::path resolved = fs::weakly_canonical(file, fault);
  if (fault || !are_above(resolved)) {
    std::string list;
    for (const fs::path& folder : folders_) list += (list.empty() ? "" : ", ") + folder.string();
    throw bad_input(
        fmt::format("'{}' is not in a folder that live feeds may read ({}); write it there, or name its "
                    "folder for live feeds when the server is started",
                    file.string(), list));
  }
  const fs::file_status status = fs::status(resolved, fault);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw bad_input(fmt::format("'{}' is a folder, a device or a pipe; name a file that is being written",
                                file.string()));
}

}  // namespace tramline::server
