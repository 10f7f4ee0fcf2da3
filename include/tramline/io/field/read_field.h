#pragma once

#include <filesystem>

#include "tramline/io/geopackage/metadata.h"
#include "tramline/model/field.h"

namespace tramline::io {

/// A field as write_field() wrote it.
struct StoredField {
  Field field;       ///< to the bit; in a plain frame, which is shifted, to 1e-9 m
  Metadata remarks;  ///< without their prefix
};

/// Throws Error(kBadInput) naming the file, and the layer and feature at fault, where the file is missing,
/// cut off, no field, or holds a value of another kind. O(n).
StoredField read_field(const std::filesystem::path& path);

}  // namespace tramline::io
