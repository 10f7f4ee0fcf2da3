#pragma once
// Names shared by the writer and the reader of coverage files.
//
// Runs count from 1; the model counts from 0.

#include "tramline/io/geopackage/file_kind.h"

namespace tramline::io {

inline constexpr FileKind kCoverageFile{"coverage file", "tramline evaluate"};

}  // namespace tramline::io

namespace tramline::io::coverage_layers {

inline constexpr const char* kField = "field";
inline constexpr const char* kCovered = "covered";
inline constexpr const char* kRepeated = "repeated";
inline constexpr const char* kMissed = "missed";
inline constexpr const char* kNotRecorded = "not_recorded";               ///< from version 2 on
inline constexpr const char* kNotRecordedArea = "areas.not_recorded_m2";  ///< key of metadata, likewise
inline constexpr const char* kMultiplicity = "multiplicity";
inline constexpr const char* kGaps = "gaps";
inline constexpr const char* kTrack = "track";
inline constexpr const char* kSlices = "slices";  ///< only where there are any
inline constexpr const char* kMetadata = "metadata";

}  // namespace tramline::io::coverage_layers
