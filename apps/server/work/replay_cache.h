#pragma once
// A cache of recently prepared drives.

#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "server/work/ready_drive.h"

namespace tramline::server {

/// Keeps those asked for last, so that moving the slider of a replay does not read the log again. Safe for
/// several threads.
class ReplayCache {
 public:
  explicit ReplayCache(std::size_t most = 4, std::size_t most_bytes = std::size_t{256} << 20)
      : most_(most), most_bytes_(most_bytes) {}

  /// The drive of that id, made by `make` where it is not there. What `make` throws is thrown on. What is
  /// made while something is forgotten is not kept: it may be what it was before.
  std::shared_ptr<const ReadyDrive> get(const std::string& id, const std::function<ReadyDrive()>& make);
  void forget(const std::string& id);

 private:
  using Entry = std::pair<std::string, std::shared_ptr<const ReadyDrive>>;
  std::size_t bytes() const;

  const std::size_t most_, most_bytes_;
  std::mutex mutex_;
  std::size_t forgotten_ = 0;  ///< calls of forget()
  std::list<Entry> entries_;   ///< asked for last: first
};

}  // namespace tramline::server
