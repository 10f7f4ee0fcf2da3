#pragma once
// A file that stores the lines of a stream unchanged.

#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tramline/io/feed/descriptor.h"

namespace tramline::io {

/// The prefix of lines that the program itself adds; they are not part of the stream. Readers of logs read
/// them without the exclamation mark: "#!work=1" means "#work=1".
inline constexpr const char* kOwnLine = "#!";

/// Appends lines; each is with the operating system when append() returns, and on the disk a second later.
/// The file is locked against other writers of this kind. Data that cannot be written because the disk is
/// full are kept and retried every second, 64 MiB at most.
class RawLog {
 public:
  /// Opens or creates the file. Anything after the last line end is cut off: it was being written when the
  /// machine stopped. Throws bad_input where another process has it open, or it cannot be written.
  explicit RawLog(std::string path);
  RawLog(const RawLog&) = delete;
  RawLog& operator=(const RawLog&) = delete;
  ~RawLog();

  /// Returns the lines that the file held when it was opened.
  std::vector<std::string> take_lines_before() { return std::move(before_); }
  void append(const std::string& lines_with_ends);
  /// Tries once more to write the pending data.
  void retry();
  /// The reason why the last lines are not in the file; "" when all are.
  const std::string& fault() const { return fault_; }
  /// Releases the file without writing, for a forked process: lock and file belong to the parent.
  void abandon();

 private:
  void read_before();
  void write_pending();
  void keep_syncing();

  std::string path_;
  Descriptor file_;
  std::vector<std::string> before_;
  std::string pending_;
  std::size_t size_ = 0;  ///< of the file
  std::string fault_;
  bool lost_ = false;

  // A separate thread syncs bytes to the disk: waiting for that may take longer than the interval of fixes.
  std::mutex mutex_;
  std::condition_variable wake_;
  bool dirty_ = false;
  bool stop_ = false;
  std::thread syncing_;
};

}  // namespace tramline::io
