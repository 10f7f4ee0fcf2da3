#pragma once

#include <string>

#include "tramline/io/fixes/lines.h"
#include "tramline/model/dose_map.h"

namespace tramline::io {

/// read_pattern() for any source of lines, called `name` in messages.
SprayPattern read_pattern(Lines& lines, const std::string& name);

}  // namespace tramline::io
