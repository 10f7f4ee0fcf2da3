#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "tramline/model/plan.h"

namespace tramline::io {

/// Writes a plan as a GeoPackage with the layers field, obstacles, body, headland, given_up, subfields,
/// headland_passes, tracks, swaths, overlap, uncovered, headland_unworked, dropped and encounters, and the
/// attribute tables metadata and layer_styles (styles for QGIS that match the pictures drawn here); empty
/// layers exist too. A plan with a front has the attribute table front as well, a repair the layer worked.
/// Curved tracks, those with detours and headland passes are drawn as chords (kChordSagitta) and have their
/// exact path as text.
///
/// Coordinates: for a geodetic frame the field's local metres in a transverse Mercator on WGS 84
/// defined in the file; for a plain frame the input plane (local metres plus the frame's origin), in
/// an engineering CRS. Numbers for people (order, subfield, track, obstacles) count from 1.
///
/// The same plan gives the same bytes: time stamps are SOURCE_DATE_EPOCH where that is set, else
/// 1970-01-01. `remarks` go into metadata (remarks.h). The file is written whole or not at all.
///
/// Throws Error(kBadInput) for a name that does not end in .gpkg (in any case), Error(kFailure) where the
/// file cannot be written. O(n) in vertices and pieces.
void write_plan(const Plan& plan, const std::filesystem::path& path,
                const std::map<std::string, std::string>& remarks = {});

}  // namespace tramline::io
