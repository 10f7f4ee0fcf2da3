#pragma once

#include <map>
#include <string>

namespace tramline::io {

/// What has no shape, as keys and values: the table `metadata` of our files. Sorted by key. Numbers carry as
/// many digits as it takes to read the same bits back.
using Metadata = std::map<std::string, std::string>;

/// The name of that table.
inline constexpr const char* kMetadataTable = "metadata";

}  // namespace tramline::io
