#pragma once

#include <map>
#include <string>

namespace tramline::io {

/// Data without shapes as keys and values: the table `metadata` of tramline's files. Sorted by key. Numbers
/// have as many digits as are needed to restore the same bits.
using Metadata = std::map<std::string, std::string>;

/// The name of that table.
inline constexpr const char* kMetadataTable = "metadata";

}  // namespace tramline::io
