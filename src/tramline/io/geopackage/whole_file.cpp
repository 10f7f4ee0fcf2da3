#include "tramline/io/geopackage/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include "tramline/geometry/error.h"

namespace tramline::io {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, int cause) {
  throw failure(fmt::format("cannot write {}: {}; choose a folder that exists, is writable and has room",
                            path.string(), std::generic_category().message(cause)));
}

fs::path name_beside(const fs::path& path) {
  static std::atomic<unsigned> count{0};
  return path.parent_path() / fmt::format(".{}.{}-{}.part", path.filename().string(), getpid(), count++);
}

/// An open file that disappears unless it is kept.
class Temporary {
 public:
  explicit Temporary(const fs::path& target)
      : target_(target),
        name_(name_beside(target)),
        descriptor_(open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0) refuse(target_, errno);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!kept_) unlink(name_.c_str());
  }

  void append(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
      const ssize_t written = write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) refuse(target_, errno);
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
  }

  /// A full disk may show only on closing.
  void keep() {
    const int closed = close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) refuse(target_, errno);
    if (std::rename(name_.c_str(), target_.c_str()) != 0) refuse(target_, errno);
    kept_ = true;
  }

 private:
  fs::path target_;
  fs::path name_;
  int descriptor_;
  bool kept_ = false;
};

}  // namespace

void write_whole(const fs::path& path, std::span<const std::byte> bytes) {
  Temporary temporary(path);
  temporary.append(bytes);
  temporary.keep();
}

}  // namespace tramline::io
