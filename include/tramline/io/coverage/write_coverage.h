#pragma once

#include <filesystem>

#include "tramline/model/coverage.h"

namespace tramline::io {

/// Writes an evaluation as a GeoPackage with the layers field, covered, repeated, missed, not_recorded,
/// multiplicity, gaps and track, and the attribute tables metadata, layer_styles (styles for QGIS that match
/// the pictures drawn here) and, where there are any, slices; empty layers exist too. Nothing is simplified.
///
/// The polygons of field, covered, repeated, missed, not_recorded and of each multiplicity are sorted by
/// area, the largest first; among equals the one whose bounding box begins further west, then further south,
/// then in their given order. A line of one point is written as that point twice; an empty line has no shape.
/// Unknown values (NaN) are NULL in tables and empty in metadata.
///
/// Coordinates are those of a plan file: for a geodetic frame the local metres in a transverse Mercator on
/// WGS 84 defined in the file; for a plain frame the input plane (local metres plus the frame's origin), in
/// an engineering CRS. Runs count from 1.
///
/// The same evaluation gives the same bytes: time stamps are SOURCE_DATE_EPOCH where that is set, else
/// 1970-01-01. The file is written whole or not at all.
///
/// Throws Error(kBadInput) for a name that does not end in .gpkg (in any case), Error(kFailure) where the
/// file cannot be written. O(n log n) in vertices.
void write_coverage(const Coverage& coverage, const std::filesystem::path& path);

}  // namespace tramline::io
