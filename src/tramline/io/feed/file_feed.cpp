#include <fcntl.h>
#include <fmt/format.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/io/feed/descriptor.h"
#include "tramline/io/feed/feed.h"
#include "tramline/io/feed/line_splitter.h"

namespace tramline::io {
namespace {

/// How soon a change is noticed that the system does not announce (network file systems), or another file of
/// the same name.
constexpr int kLook_ms = 1000;

using MayRead = std::function<bool(const std::string& opened)>;

/// The path of what is open, whatever its name has become since; "" where the system does not tell.
std::string path_of(const Descriptor& file) {
  std::error_code fault;
  return std::filesystem::read_symlink(fmt::format("/proc/self/fd/{}", file.number()), fault).string();
}

class FileFeed final : public Feed {
 public:
  FileFeed(const std::string& path, MayRead may_read)
      : path_(path), may_read_(std::move(may_read)), watch_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
    if (!open_file()) throw bad_input(fmt::format("'{}' cannot be followed: {}", path_, words_for(errno)));
  }

  std::string name() const override { return path_.substr(path_.find_last_of('/') + 1); }
  int descriptor() const override { return watch_.number(); }
  int wait_ms() const override { return more_ ? 0 : kLook_ms; }

  Received receive() override {
    forget_events();
    Received out;
    std::string bytes;
    int fault = 0;
    const ReadResult result = read_some(file_, bytes, fault);
    read_ += bytes.size();
    splitter_.add(bytes, out.lines);
    more_ = out.more = result == ReadResult::kBytes;
    if (!more_) look_for_another(out);
    return out;
  }
  std::string rest() override { return splitter_.take_rest(); }

 private:
  bool open_file() {
    file_ = Descriptor(open(path_.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    struct stat status {};
    if (!file_.open() || fstat(file_.number(), &status) != 0) return false;
    if (S_ISDIR(status.st_mode)) {
      errno = EISDIR;
      return false;
    }
    // Asked of the open file: its name may lead elsewhere by now.
    if (may_read_ && !(S_ISREG(status.st_mode) && may_read_(path_of(file_)))) {
      file_.reset();
      errno = EACCES;
      return false;
    }
    inode_ = status.st_ino;
    read_ = 0;
    more_ = true;
    if (watch_.open()) inotify_add_watch(watch_.number(), path_.c_str(), IN_MODIFY | IN_MOVE_SELF);
    return true;
  }

  void forget_events() {
    std::array<char, 4096> events;
    while (watch_.open() && read(watch_.number(), events.data(), events.size()) > 0) {
    }
  }

  void look_for_another(Received& out) {
    struct stat open_one {
    }, named{};
    const bool same = stat(path_.c_str(), &named) != 0 || named.st_ino == inode_;
    const bool cut =
        fstat(file_.number(), &open_one) == 0 && static_cast<std::size_t>(open_one.st_size) < read_;
    if (same && !cut) return;
    splitter_.take_rest();
    if (!open_file()) return;
    out.messages.push_back(fmt::format("'{}' was started again; its new lines are added", path_));
    out.more = true;
  }

  std::string path_;
  MayRead may_read_;
  Descriptor watch_, file_;
  ino_t inode_ = 0;
  std::size_t read_ = 0;
  bool more_ = true;
  LineSplitter splitter_;
};

}  // namespace

std::unique_ptr<Feed> file_feed(const std::string& path,
                                std::function<bool(const std::string& opened)> may_read) {
  return std::make_unique<FileFeed>(path, std::move(may_read));
}

}  // namespace tramline::io
