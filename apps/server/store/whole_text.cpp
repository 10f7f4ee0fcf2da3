#include "server/store/whole_text.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>
#include <system_error>

#include "tramline/geometry/error.h"
#include "tramline/io/feed/descriptor.h"

namespace tramline::server {

void write_whole(const std::filesystem::path& path, const std::string& text) {
  const std::string beside = path.string() + ".part";
  const auto refuse = [&] {
    throw failure(
        fmt::format("{} cannot be written ({}); is the disk full?", path.string(), io::words_for(errno)));
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
  std::error_code fault;
  std::filesystem::rename(beside, path, fault);
  if (fault)
    throw failure(
        fmt::format("{} cannot be written ({}); is the disk full?", path.string(), fault.message()));
}

}  // namespace tramline::server
