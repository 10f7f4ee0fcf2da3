#pragma once
// Recent fronts, kept for fetching plans from them.

#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <string>

namespace tramline::server {

/// kept_front.h: who only has the shelf need not know the planner.
struct KeptFront;
using KeptFrontPtr = std::shared_ptr<const KeptFront>;

/// The last few, in memory: a search can be done again. Safe for several threads.
class FrontShelf {
 public:
  explicit FrontShelf(std::size_t most) : most_(most) {}
  KeptFrontPtr add(KeptFront front);
  /// Throws HttpError(kNotFound).
  KeptFrontPtr get(const std::string& id) const;

 private:
  const std::size_t most_;
  mutable std::mutex mutex_;
  std::deque<KeptFrontPtr> fronts_;
};

}  // namespace tramline::server
