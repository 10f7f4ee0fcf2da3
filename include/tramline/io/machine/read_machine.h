#pragma once

#include <filesystem>

#include "tramline/model/machine.h"

namespace tramline::io {

/// Reads a machine from a TOML file (docs/machine.md). Throws bad_input, naming file, line and key, for
/// a file that cannot be read, is longer than 1 MiB or is not TOML, keys of deeply nested tables, an unknown
/// key, a value of the wrong type, a length, speed or time that is negative, not finite or larger than that
/// of any machine, a width that is missing or zero, and a drawbar without a towed implement or the reverse.
Machine read_machine(const std::filesystem::path& path);

}  // namespace tramline::io
