#include "server/work/replay_cache.h"

#include <algorithm>
#include <numeric>

namespace tramline::server {

std::size_t ReplayCache::bytes() const {
  return std::accumulate(entries_.begin(), entries_.end(), std::size_t{0},
                         [](std::size_t sum, const Entry& entry) { return sum + entry.second->bytes(); });
}

std::shared_ptr<const ReadyDrive> ReplayCache::get(const std::string& id,
                                                   const std::function<ReadyDrive()>& make) {
  const auto of_id = [&](const Entry& entry) { return entry.first == id; };
  std::size_t forgotten = 0;
  {
    const std::lock_guard lock(mutex_);
    forgotten = forgotten_;
    const auto found = std::find_if(entries_.begin(), entries_.end(), of_id);
    if (found != entries_.end()) {
      entries_.splice(entries_.begin(), entries_, found);
      return found->second;
    }
  }
  // Two who ask at once both read it: rare, and better than all waiting for one.
  auto made = std::make_shared<const ReadyDrive>(make());
  const std::lock_guard lock(mutex_);
  if (forgotten != forgotten_) return made;
  entries_.remove_if(of_id);
  entries_.emplace_front(id, made);
  while (entries_.size() > 1 && (entries_.size() > most_ || bytes() > most_bytes_)) entries_.pop_back();
  return made;
}

void ReplayCache::forget(const std::string& id) {
  const std::lock_guard lock(mutex_);
  ++forgotten_;
  entries_.remove_if([&](const Entry& entry) { return entry.first == id; });
}

}  // namespace tramline::server
