#pragma once

#include <filesystem>

#include "tramline/io/geopackage/metadata.h"
#include "tramline/model/field.h"

namespace tramline::io {

/// A field as written by write_field().
struct StoredField {
  Field field;       ///< bit-identical; in a plain frame, which is shifted, to 1e-9 m
  Metadata remarks;  ///< without their prefix
};

/// Reads a field file. Throws Error(kBadInput) naming the file, and the layer and feature at fault, where the
/// file is missing, truncated, not a field file, or holds a value of the wrong type. O(n).
StoredField read_field(const std::filesystem::path& path);

}  // namespace tramline::io
