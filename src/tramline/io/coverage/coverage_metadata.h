#pragma once
// The data of an evaluation without shapes: the table `metadata` of a coverage file.

#include <filesystem>

#include "tramline/io/geopackage/metadata.h"
#include "tramline/model/coverage.h"

namespace tramline::io {

/// Figures, counts, names, local frame and remarks of an evaluation; the program's version, and worked hours
/// for people. Unknown values (NaN) are empty texts.
Metadata metadata_of(const Coverage& coverage);

/// The inverse: fills those parts of `coverage`. Throws Error(kBadInput) naming `file` and the key where a
/// key is missing, a number is invalid or infinite, or the version cannot be read.
void apply_metadata(const Metadata& metadata, const std::filesystem::path& file, Coverage& coverage);

}  // namespace tramline::io
