#pragma once
// Reads and writes several machines in one file.

#include <filesystem>
#include <string>
#include <vector>

#include "tramline/model/machine.h"

namespace tramline::io {

struct ListedMachine {
  std::string id;
  Machine machine;
};

/// Writes a GeoPackage with the attribute table machines: id, name, width_m, radius_m, min_length_m, which is
/// NULL for the default, and turning: the values of Turning as JSON, empty where all are the defaults. Bytes
/// and errors as those of write_plan(). O(n).
void write_machines(const std::vector<ListedMachine>& machines, const std::filesystem::path& path);

/// The inverse. Throws Error(kBadInput) naming file, row and column where the file is missing, cut off, has
/// no such table, or a value is missing or not finite. O(n).
std::vector<ListedMachine> read_machines(const std::filesystem::path& path);

}  // namespace tramline::io
