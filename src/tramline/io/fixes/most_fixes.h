#pragma once
// The limit on the number of fixes of one log.

#include <cstddef>
#include <string>

namespace tramline::io {

/// Seven days of ten hours, ten fixes a second, are 2.5 million; each takes some 230 bytes while it is read.
inline constexpr std::size_t kMostFixes = 3'000'000;

/// Throws bad_input, with the figure, where a log at `place` would have more than `most`.
void require_room_for_fix(std::size_t already, const std::string& place, std::size_t most = kMostFixes);

}  // namespace tramline::io
