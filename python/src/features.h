#pragma once
// Geometries that Python holds as features of the library.

#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "tramline/model/raw_feature.h"

namespace tramline::python {

/// {bytes, "wkb", "wkt" or "geojson", id}
using GivenGeometry = std::tuple<std::string, std::string, std::string>;

/// One layer of features numbered from 0. `crs`: a definition for Crs; empty: none is known. `name`: what
/// messages call them. Throws Error(kBadInput) where there is none, and for bytes that are no geometry.
std::shared_ptr<RawDataset> features_of(const std::vector<GivenGeometry>& geometries, const std::string& crs,
                                        const std::string& name);

}  // namespace tramline::python
