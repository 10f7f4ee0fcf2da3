#pragma once
// Chooses the layers of a dataset to read.

#include <string>
#include <vector>

#include "tramline/io/vector/read_vector.h"

class GDALDataset;
class OGRLayer;

namespace tramline::io {

/// The layer called query.layer; without one the only layer that can hold the shapes wanted (the others are
/// listed in `skipped`); with all_layers every layer. Throws bad_input listing the layers where none or
/// several qualify.
std::vector<OGRLayer*> choose_layers(GDALDataset& dataset, const VectorQuery& query,
                                     std::vector<Skipped>& skipped);

/// "--where" and "--layer", or the names of these options for lines.
const char* where_option(const VectorQuery& query);
const char* layer_option(const VectorQuery& query);

/// "roads (Line String), fields (Polygon)".
std::string layer_list(GDALDataset& dataset);

}  // namespace tramline::io
