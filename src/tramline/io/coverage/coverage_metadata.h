#pragma once
// Everything of an evaluation that has no shape: the table `metadata` of a coverage file.

#include <filesystem>

#include "tramline/io/geopackage/metadata.h"
#include "tramline/model/coverage.h"

namespace tramline::io {

/// Figures, counts, names, local frame and remarks of an evaluation; the program's version, and worked hours
/// for people. What is not known (NaN) is an empty text.
Metadata metadata_of(const Coverage& coverage);

/// The inverse: fills those parts of `coverage`. Throws Error(kBadInput) naming `file` and the key where a
/// key is missing, a number none or infinite, or the version one that cannot be read.
void apply_metadata(const Metadata& metadata, const std::filesystem::path& file, Coverage& coverage);

}  // namespace tramline::io
