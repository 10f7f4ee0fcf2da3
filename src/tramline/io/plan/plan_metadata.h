#pragma once
// Everything of a plan that has no shape, as keys and values: the table `metadata` of a plan file.

#include <filesystem>
#include <map>
#include <string>

#include "tramline/model/plan.h"

namespace tramline::io {

/// Sorted by key. Numbers carry as many digits as it takes to read the same bits back.
using Metadata = std::map<std::string, std::string>;

/// Machine, objective, settings, tally, local frame, source and remarks of a plan. The source file is
/// named without its folder: a plan does not carry the paths of the machine it was made on.
Metadata metadata_of(const Plan& plan);

/// The inverse: fills those parts of `plan`. Throws Error(kBadInput) naming `file` and the key where
/// a key is missing, a word unknown or a number not finite.
void apply_metadata(const Metadata& metadata, const std::filesystem::path& file, Plan& plan);

}  // namespace tramline::io
