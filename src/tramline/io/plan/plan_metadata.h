#pragma once
// The data of a plan without shapes, as keys and values: the table `metadata` of a plan file.

#include <filesystem>

#include "tramline/io/geopackage/metadata.h"
#include "tramline/model/plan.h"

namespace tramline::io {

/// The first version with headlands and curved tracks, and so with their layers and keys. Files of the
/// previous version have none and are still read.
inline constexpr int kVersionWithHeadlands = 3;
/// The version of repairs, which have a layer of worked land.
inline constexpr int kVersionWithRepairs = 4;
/// The first version whose tally, cost and layers are those of tracks and headland passes together, and with
/// a price for each subfield after the first.
inline constexpr int kVersionWithWholeFigures = 5;
/// The first version that says whether the search was ended early.
inline constexpr int kVersionWithSearchEnd = 6;
/// The version of plans whose subfields follow lines of their own. All others are written in the previous
/// version, unless a later one is needed.
inline constexpr int kVersionWithOwnLines = 7;

/// The version of plans for a part of the land, and of those with land left out or subfields drawn by the
/// user.
inline constexpr int kVersionWithGivenLand = 8;
/// The version of plans with turns, of those whose machine has other values for turning than the defaults,
/// and of those with different numbers of headland passes along the edges of the field. It may have whatever
/// the versions before it have.
inline constexpr int kVersionWithTurning = 9;
/// The version of plans with a route, or that were asked for one. It may have whatever version 9 has.
inline constexpr int kVersionWithRoute = 10;

/// Machine, objective, settings, tally, local frame, source and remarks of a plan. The source file is
/// named without its folder: a plan must not contain paths of the machine it was made on. Guide line and
/// references are in the coordinates of the file, as paths of tracks are.
Metadata metadata_of(const Plan& plan);

/// The inverse: fills those parts of `plan`, and returns the version of the format. Throws Error(kBadInput)
/// naming `file` and the key where a key is missing, a word is unknown, a number not finite, or the version
/// cannot be read.
int apply_metadata(const Metadata& metadata, const std::filesystem::path& file, Plan& plan);

/// Sets what the user gave of the land: which subfields were drawn, and which land is left out, once both
/// have been read. Throws as apply_metadata().
void apply_given_land(const Metadata& metadata, const std::filesystem::path& file, Plan& plan);

/// Sets the lines that the tracks of the subfields follow, once the subfields have been read. Throws as
/// apply_metadata().
void apply_references(const Metadata& metadata, const std::filesystem::path& file, int version, Plan& plan);

/// Whether the plan of a file of this version is a repair, determined without its layers.
bool is_repair(const Metadata& metadata, int version);

}  // namespace tramline::io
