#include "tramline/route/connection/unreachable.h"

#include <algorithm>
#include <cassert>
#include <functional>

namespace tramline {

const Unreachable::From* Unreachable::to(const Pose& end) const {
  const auto known = to_end_.find(key_of(end));
  return known == to_end_.end() ? nullptr : &known->second;
}

Unreachable::From Unreachable::to_any(const std::vector<Pose>& ends) const {
  From out(poses_, 1);
  for (const Pose& end : ends) {
    const From* known = to(end);
    if (known == nullptr) return From(poses_, 0);
    std::ranges::transform(out, *known, out.begin(), std::bit_and<>{});
  }
  return out;
}

void Unreachable::add(const Pose& end, const From& nowhere) {
  assert(nowhere.size() == poses_);
  const auto [known, is_new] = to_end_.try_emplace(key_of(end), nowhere);
  if (!is_new) std::ranges::transform(known->second, nowhere, known->second.begin(), std::bit_or<>{});
}

}  // namespace tramline
