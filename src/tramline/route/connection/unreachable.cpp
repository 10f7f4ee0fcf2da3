#include "tramline/route/connection/unreachable.h"

#include <algorithm>
#include <cassert>
#include <functional>

namespace tramline {

Unreachable::From Unreachable::to_any(const std::vector<Pose>& ends) const {
  From out(poses_, 1);
  for (const Pose& end : ends) {
    const auto known = to_end_.find(key_of(end));
    if (known == to_end_.end()) return From(poses_, 0);
    std::ranges::transform(out, known->second, out.begin(), std::bit_and<>{});
  }
  return out;
}

void Unreachable::add(const Pose& end, const From& nowhere) {
  assert(nowhere.size() == poses_);
  const auto [known, is_new] = to_end_.try_emplace(key_of(end), nowhere);
  if (!is_new) std::ranges::transform(known->second, nowhere, known->second.begin(), std::bit_or<>{});
}

}  // namespace tramline
