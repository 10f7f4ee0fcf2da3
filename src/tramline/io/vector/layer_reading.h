#pragma once
// The steps by which features of a layer are read, all at once or some at a time.

#include <string>

#include "tramline/io/vector/layer_crs.h"
#include "tramline/io/vector/read_vector.h"
#include "tramline/model/raw_feature.h"

class GDALDataset;
class OGRFeature;
class OGRLayer;

namespace tramline::io {

class GdalMessages;

/// The feature with its number, id, shapes and the attributes that the query asks for.
RawFeature raw_feature(const OGRFeature& feature, AxisOrder axes, const VectorQuery& query);

/// Sets the filter of the query. Throws bad_input where OGR does not understand it.
void filter(OGRLayer& layer, const VectorQuery& query, const std::string& place, GdalMessages& messages);

/// Throws bad_input where the messages say that reading went wrong.
void check_reading(OGRLayer& layer, const VectorQuery& query, const std::string& place,
                   const GdalMessages& messages);

/// "layer 'parcels' of 'farm.gpkg'"
std::string place_of(OGRLayer& layer, const VectorQuery& query);

/// What is known of the layer, and of the file, before any feature is read.
RawLayer bare_layer(OGRLayer& layer, const VectorQuery& query);
RawDataset bare_dataset(GDALDataset& dataset, const VectorQuery& query);

}  // namespace tramline::io
