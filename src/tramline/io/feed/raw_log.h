#pragma once
// The lines of a stream in a file, as they came.

#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tramline/io/feed/descriptor.h"

namespace tramline::io {

/// Lines that the program itself adds begin so; they are no part of the stream. For readers of logs they are
/// what stands behind it: "#!work=1" says "#work=1".
inline constexpr const char* kOwnLine = "#!";

/// Appends lines; each is with the operating system when append() comes back, and on the disk a second later.
/// Locked: nobody else can open it so. What cannot be written, because the disk is full, is kept and tried
/// again every second, 64 MiB at most.
class RawLog {
 public:
  /// Opens or makes it. What it holds after the last line end is cut off: it was being written when the
  /// machine stopped. Throws bad_input where another process has it, or it cannot be written.
  explicit RawLog(std::string path);
  RawLog(const RawLog&) = delete;
  RawLog& operator=(const RawLog&) = delete;
  ~RawLog();

  /// The lines that were there when it was opened.
  std::vector<std::string> take_lines_before() { return std::move(before_); }
  void append(const std::string& lines_with_ends);
  /// Tries once more to write what could not be written.
  void retry();
  /// Why the last lines are not in the file; "" when all are.
  const std::string& fault() const { return fault_; }
  /// In a forked process: the lock and the file are the parent's.
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

  // Bytes reach the disk by a thread of their own: waiting for one may take longer than fixes are apart.
  std::mutex mutex_;
  std::condition_variable wake_;
  bool dirty_ = false;
  bool stop_ = false;
  std::thread syncing_;
};

}  // namespace tramline::io
