#pragma once
// Parses the work states of tables and lines.

#include <optional>
#include <string_view>

#include "tramline/model/work_log.h"

namespace tramline::io {

/// On: 1, on, true, yes, and what an implement in the ground is called: in, down, lowered, engaged, working …
/// Off: 0, off, false, no, out, up, raised, disengaged … Case and blanks do not matter. Unknown for an empty
/// text; nullopt for any other.
std::optional<WorkState> work_word(std::string_view text);

}  // namespace tramline::io
