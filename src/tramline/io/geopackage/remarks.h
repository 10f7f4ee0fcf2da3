#pragma once
// Remarks that the program which keeps a tramline file stores in it, in addition to the file's own data.

#include <filesystem>

#include "tramline/io/geopackage/file_kind.h"
#include "tramline/io/geopackage/metadata.h"

namespace tramline::io {

/// The prefix of the key of every remark in the table `metadata`; readers of the file itself ignore such
/// keys.
inline constexpr const char* kRemarkPrefix = "kept.";

void add_remarks(const Metadata& remarks, Metadata& out);
/// The remarks in the table, with keys without the prefix.
Metadata remarks_in(const Metadata& metadata);

/// The table `metadata` of a file including remarks: much faster than reading the whole file. Throws
/// Error(kBadInput) naming the file where it is missing, cut off or has no such table.
Metadata read_metadata(const std::filesystem::path& path, const FileKind& kind);

}  // namespace tramline::io
