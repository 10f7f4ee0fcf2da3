#pragma once
// What whoever keeps a file of ours notes in it, beside what the file itself has to say.

#include <filesystem>

#include "tramline/io/geopackage/file_kind.h"
#include "tramline/io/geopackage/metadata.h"

namespace tramline::io {

/// Before the key of every remark in the table `metadata`; readers of the file itself pass over such keys.
inline constexpr const char* kRemarkPrefix = "kept.";

void add_remarks(const Metadata& remarks, Metadata& out);
/// Without the prefix.
Metadata remarks_in(const Metadata& metadata);

/// The table `metadata` of a file alone, remarks and all: much quicker than the whole. Throws
/// Error(kBadInput) naming the file where it is missing, cut off or has no such table.
Metadata read_metadata(const std::filesystem::path& path, const FileKind& kind);

}  // namespace tramline::io
