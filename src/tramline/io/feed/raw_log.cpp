#include "tramline/io/feed/raw_log.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/io/feed/line_splitter.h"

namespace tramline::io {
namespace {

constexpr std::size_t kMostPending = std::size_t{64} << 20;

}  // namespace

RawLog::RawLog(std::string path) : path_(std::move(path)) {
  file_ = Descriptor(open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666));
  if (!file_.open())
    throw bad_input(fmt::format("the raw log '{}' cannot be written: {}", path_, words_for(errno)));
  if (flock(file_.number(), LOCK_EX | LOCK_NB) != 0)
    throw bad_input(
        fmt::format("'{}' is being written by another watch: end that first, or choose another -o", path_));
  read_before();
  syncing_ = std::thread([this] { keep_syncing(); });
}

RawLog::~RawLog() {
  {
    const std::lock_guard hold(mutex_);
    stop_ = true;
  }
  wake_.notify_one();
  if (syncing_.joinable()) syncing_.join();
  if (!file_.open()) return;
  fdatasync(file_.number());
  // Nothing came: a run that was refused leaves nothing behind.
  if (size_ == 0) unlink(path_.c_str());
}

void RawLog::read_before() {
  LineSplitter splitter;
  std::string bytes;
  int fault = 0;
  ReadResult result = ReadResult::kBytes;
  std::size_t total = 0;
  while ((result = read_some(file_, bytes, fault)) == ReadResult::kBytes) {
    total += bytes.size();
    splitter.add(bytes, before_);
    bytes.clear();
  }
  if (result == ReadResult::kFault)
    throw bad_input(fmt::format("the raw log '{}' cannot be read: {}", path_, words_for(fault)));
  size_ = total - splitter.take_rest().size();
  if (size_ < total && ftruncate(file_.number(), static_cast<off_t>(size_)) != 0)
    throw bad_input(fmt::format("the raw log '{}' cannot be written: {}", path_, words_for(errno)));
}

void RawLog::append(const std::string& lines_with_ends) {
  const bool room = pending_.size() + lines_with_ends.size() <= kMostPending;
  if (room)
    pending_ += lines_with_ends;
  else
    lost_ = true;
  if (fault_.empty()) write_pending();
}

void RawLog::retry() {
  if (!fault_.empty()) write_pending();
}

void RawLog::write_pending() {
  fault_.clear();
  while (!pending_.empty()) {
    const ssize_t written =
        pwrite(file_.number(), pending_.data(), pending_.size(), static_cast<off_t>(size_));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      fault_ = words_for(written == 0 ? ENOSPC : errno);
      break;
    }
    size_ += static_cast<std::size_t>(written);
    pending_.erase(0, static_cast<std::size_t>(written));
  }
  const std::lock_guard hold(mutex_);
  dirty_ = true;
}

void RawLog::keep_syncing() {
  std::unique_lock hold(mutex_);
  while (!stop_) {
    wake_.wait_for(hold, std::chrono::milliseconds(900), [this] { return stop_; });
    if (!std::exchange(dirty_, false)) continue;
    hold.unlock();
    fdatasync(file_.number());
    hold.lock();
  }
}

void RawLog::abandon() { file_.reset(); }

}  // namespace tramline::io
