#include "server/store/whole_text.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <string_view>

#include "tramline/geometry/error.h"
#include "tramline/io/feed/descriptor.h"

namespace tramline::server {
namespace {

/// Hidden, so that what is left of it after a kill goes at the next start, and no other writer's.
std::filesystem::path name_beside(const std::filesystem::path& path) {
  static std::atomic<unsigned> count{0};
  return path.parent_path() / fmt::format(".{}.{}-{}.part", path.filename().string(), getpid(), count++);
}

}  // namespace

void write_whole(const std::filesystem::path& path, const std::string& text) {
  const std::filesystem::path beside = name_beside(path);
  const auto refuse = [&] {
    const std::string cause = io::words_for(errno);
    unlink(beside.c_str());
    throw failure(fmt::format("{} cannot be written ({}); is the disk full?", path.string(), cause));
  };
  {
    const io::Descriptor file(open(beside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
    if (!file.open()) refuse();
    for (std::string_view rest = text; !rest.empty();) {
      const ssize_t some = write(file.number(), rest.data(), rest.size());
      if (some < 0 && errno == EINTR) continue;
      if (some <= 0) refuse();
      rest.remove_prefix(static_cast<std::size_t>(some));
    }
    if (fsync(file.number()) != 0) refuse();
  }
  if (std::rename(beside.c_str(), path.c_str()) != 0) refuse();
}

}  // namespace tramline::server
