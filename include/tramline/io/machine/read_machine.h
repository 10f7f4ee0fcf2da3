#pragma once

#include <filesystem>

#include "tramline/model/machine.h"

namespace tramline::io {

/// Reads a machine from a TOML file (docs/machine.md). Throws bad_input, naming file, line and key, for
/// a file that cannot be read, is longer than 1 MiB or is not TOML, keys of deeply nested tables, an unknown
/// key, a value of the wrong type, a length that is negative, not finite or above kFarthest_m, and a width
/// that is missing or zero.
Machine read_machine(const std::filesystem::path& path);

}  // namespace tramline::io
