#pragma once
// From a path to an open dataset of GDAL.

#include <gdal_priv.h>

#include <string>

namespace tramline::io {

class GdalMessages;

/// Opens a vector file, a folder of Shapefiles, a database, or the one dataset of a zip; of a zip with
/// several the one with the wanted layer. Throws bad_input when there is no such file, when it is no vector
/// file, and when it is not clear which dataset is meant. GDAL's drivers are registered, and `messages`
/// collects what GDAL says.
GDALDatasetUniquePtr open_dataset(const std::string& path, const std::string& wanted_layer,
                                  GdalMessages& messages);

}  // namespace tramline::io
