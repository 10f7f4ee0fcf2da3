#pragma once

#include <string>

#include "tramline/model/dose_map.h"

namespace tramline::io {

/// Reads the transverse pattern of a machine: a table of two columns, offset from the machine's middle in
/// metres (positive to the left) and relative rate, separated by comma, semicolon, tab or blanks; with
/// semicolons and tabs a comma may be the decimal point. Empty lines and comments (#, % or //) are ignored,
/// and so is a first line of names. Throws bad_input, naming the file and the line, for a file that cannot be
/// opened or is not such a table, for a rate that is negative, and for more than 10 000 rows. Whether the
/// rows make a valid pattern is checked where it is used. O(size).
SprayPattern read_pattern(const std::string& path);
}  // namespace tramline::io
