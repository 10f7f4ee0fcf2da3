#include "tramline/io/fixes/most_fixes.h"

#include <fmt/format.h>

#include "tramline/geometry/error.h"

namespace tramline::io {

void require_room_for_fix(std::size_t already, const std::string& place, std::size_t most) {
  if (already >= most)
    throw bad_input(fmt::format("{} holds more than {} fixes; split it, such as by the day", place, most));
}

}  // namespace tramline::io
